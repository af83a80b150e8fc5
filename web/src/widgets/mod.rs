//! Controls that egui has not.

pub(crate) mod color_button;
pub(crate) mod icons;
