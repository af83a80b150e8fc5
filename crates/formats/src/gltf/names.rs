//! Words and numbers that readers and writers of glTF share.

/// What our files say made them. In these a node without a mesh is an empty one: the format has no
/// meshes with nothing to draw.
pub(crate) const GENERATOR: &str = "Meshwright";

/// The number of the vertex that a row is one of, as four bytes, low ones first: the format has no
/// 32-bit numbers for such attributes. Written where vertices lie at one place, which would become one.
pub(crate) const VERTEX_ID: &str = "_VERTEX_ID";

/// The first bytes of a binary file.
pub(crate) const MAGIC: &[u8; 4] = b"glTF";
pub(crate) const JSON_CHUNK: u32 = 0x4e4f_534a;
pub(crate) const BIN_CHUNK: u32 = 0x004e_4942;
