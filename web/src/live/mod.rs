//! The edit that follows the pointer: its state, its keys, and how the pointer and typed numbers set its amount.

pub(crate) mod edit;
pub(crate) mod edit_keys;
pub(crate) mod lock;
pub(crate) mod place;
pub(crate) mod pointer;
pub(crate) mod slide;
mod trail;
mod typed;
