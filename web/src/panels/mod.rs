//! The panels and windows of the page, one per file. Each is a function of the state that it reads and of
//! its own state, and makes requests instead of changes.

pub(crate) mod about;
pub(crate) mod adjust;
pub(crate) mod bezier;
pub(crate) mod document;
pub(crate) mod documents;
pub(crate) mod drop_overlay;
pub(crate) mod elements;
pub(crate) mod estimate;
pub(crate) mod fields;
pub(crate) mod hidden_bar;
pub(crate) mod hints;
pub(crate) mod history;
pub(crate) mod inspector;
pub(crate) mod live_bar;
pub(crate) mod menu_bar;
pub(crate) mod messages;
pub(crate) mod named_selections;
pub(crate) mod objects;
pub(crate) mod operation_list;
pub(crate) mod operations;
pub(crate) mod palette;
pub(crate) mod pointer_menu;
pub(crate) mod preview;
pub(crate) mod save;
pub(crate) mod share;
pub(crate) mod shortcuts;
pub(crate) mod status_bar;
pub(crate) mod toasts;
pub(crate) mod tool_bar;
pub(crate) mod viewport;
pub(crate) mod welcome;
