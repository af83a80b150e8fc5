//! STL, triangles for printers: text and binary.
//!
//! A file has no shared vertices: each triangle brings its own corners. On import, corners at
//! exactly the same position become one vertex.

mod read;
mod write;

pub(crate) use read::{is_binary, is_text_stl, read};
pub(crate) use write::{write, write_text};
