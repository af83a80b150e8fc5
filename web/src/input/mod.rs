//! The actions a user can start, their keys, and whether each is available now.

pub mod actions;
pub(crate) mod availability;
pub mod keys;
pub mod menus;
mod view_menu;
