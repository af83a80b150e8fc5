//! The actions a user can start, their keys, and whether each is available now.

pub(crate) mod action;
pub mod actions;
pub(crate) mod availability;
pub(crate) mod brush_key;
pub mod camera_style;
pub(crate) mod held_keys;
pub mod key_map;
pub mod key_preset;
pub mod key_reference;
mod key_table;
pub mod keys;
pub mod menus;
pub mod mouse;
pub mod pacing;
pub mod presets;
pub(crate) mod scroll;
mod select_menu;
pub mod shortcut;
pub mod tools;
mod transform_menu;
mod view_menu;
