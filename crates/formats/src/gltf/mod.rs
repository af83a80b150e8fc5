//! glTF 2.0, as `.gltf` with its buffers beside or inside it and as binary `.glb`. After the
//! Khronos "glTF 2.0 Specification".
//!
//! Each node that shows a mesh is one object. Vertices that files split for the sake of their
//! normals and texture coordinates become one again; those values are kept at the corners.

mod accessor;
mod document;
mod read;
mod write;

pub(crate) use document::{buffer_names, looks_like};
pub(crate) use read::read;
pub(crate) use write::{write_binary, write_text};

/// The first bytes of a binary file.
const MAGIC: &[u8; 4] = b"glTF";
const JSON_CHUNK: u32 = 0x4e4f_534a;
const BIN_CHUNK: u32 = 0x004e_4942;
