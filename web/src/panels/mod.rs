//! The panels and windows of the page, one per file. Each adds methods to [`crate::app::App`].

mod about;
pub(crate) mod adjust;
mod bezier;
mod color_button;
mod drop_overlay;
mod elements;
pub(crate) mod estimate;
pub(crate) mod fields;
pub(crate) mod inspector;
mod menu_bar;
mod messages;
mod objects;
pub(crate) mod operations;
pub(crate) mod palette;
pub(crate) mod save;
pub(crate) mod sheet;
mod shortcuts;
mod status_bar;
mod trial;

pub(crate) use fields::selection_words;

/// Seconds that what a field changes may take to be made at every step of a spin.
const QUICK: f64 = 0.03;
