//! What a person can start, by which keys, and whether it can be done now.

pub mod actions;
pub(crate) mod availability;
pub mod keys;
