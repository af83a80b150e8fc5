//! PLY, the Stanford polygon format: text and both binary byte orders.
//!
//! Read are positions, faces of any size, triangle strips, and colours of vertices and faces;
//! other properties are noted and left out. After G. Turk's description of the format (1994).

mod header;
mod read;
mod source;
mod write;

pub(crate) use read::read;
pub(crate) use write::{write, write_text};
