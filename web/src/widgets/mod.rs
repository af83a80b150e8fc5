//! Controls that egui lacks.

pub(crate) mod color_button;
pub(crate) mod controls;
pub(crate) mod focus_ring;
pub(crate) mod icon_button;
pub(crate) mod icons;
pub(crate) mod list_row;
pub(crate) mod number_box;
pub(crate) mod operation_icons;
pub(crate) mod scroll_fade;
pub(crate) mod tool_button;
pub(crate) mod window;
