//! Models on a disk, as the command line and the desktop program read and write them: with their companion files, and
//! without destroying what they replace.

#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable))]
#![cfg_attr(not(test), deny(clippy::indexing_slicing))]

mod read;
mod write;

pub use read::{companions, read, read_bytes};
pub use write::write;
