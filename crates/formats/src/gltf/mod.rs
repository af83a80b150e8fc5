//! glTF 2.0, as `.gltf` with its buffers beside or inside it and as binary `.glb`. After the
//! Khronos "glTF 2.0 Specification".
//!
//! Each node that shows a mesh is one object. Vertices that files split for the sake of their
//! normals and texture coordinates become one again; those values are kept at the corners. Different
//! vertices at one place are told apart in files of ours by an attribute, [`VERTEX_ID`].

mod accessor;
mod document;
mod read;
mod write;

pub(crate) use document::{buffer_names, looks_like};
pub(crate) use read::read;
pub(crate) use write::{with_data, write_binary, write_text};

/// What our files say made them. In these a node without a mesh is an empty one: the format has no
/// meshes with nothing to draw.
const GENERATOR: &str = "Meshwright";

/// The number of the vertex that a row is one of, as four bytes, low ones first: the format has no
/// 32-bit numbers for such attributes. Written where vertices lie at one place, which would become one.
const VERTEX_ID: &str = "_VERTEX_ID";

/// The first bytes of a binary file.
const MAGIC: &[u8; 4] = b"glTF";
const JSON_CHUNK: u32 = 0x4e4f_534a;
const BIN_CHUNK: u32 = 0x004e_4942;
