//! Each kind of content, in each format: either it comes back or a message names it.

#[path = "../common/mod.rs"]
mod common;
mod reading;
mod writing;
