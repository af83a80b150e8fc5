//! glTF 2.0 after the Khronos "glTF 2.0 Specification": `.gltf` with its data beside or inside it, and
//! binary `.glb`.
//!
//! Each node that shows a mesh becomes one object. Files split vertices where normals or texture
//! coordinates differ; the reader merges them again and keeps these values at the corners. The writer
//! adds an attribute, `_VERTEX_ID`, where different vertices share a position. A fault costs what needs
//! the faulty value and no more: the report names what is left out.

mod accessor;
mod buffers;
mod container;
mod draco;
mod faces;
mod json;
mod left_out;
mod material;
mod mesh;
mod meshopt;
mod morph;
mod names;
mod primitive;
mod read;
mod rows;
mod scene;
mod skin;
mod texture;
mod write;

use crate::format::loss::Part;
use crate::format::{Certainty, Codec, FormatInfo};

/// glTF as one binary file.
pub(crate) static BINARY: FormatInfo = FormatInfo {
    code: "glb",
    name: "GLB",
    save_label: "Save as GLB…",
    description: "glTF in one binary file, for the web and game engines.",
    extensions: &["glb"],
    detect: Some((Certainty::Signature, container::is_binary)),
    ..COMMON
};

pub(crate) const BINARY_CODEC: Codec = Codec { read: Some(read::read), write: Some(write::write_binary) };

/// glTF as JSON, with its data in a file beside it.
pub(crate) static TEXT: FormatInfo = FormatInfo {
    code: "gltf",
    name: "glTF",
    save_label: "Save as glTF…",
    description: "glTF as text, with its data in a file beside it.",
    extensions: &["gltf"],
    detect: Some((Certainty::Signature, container::is_json)),
    is_text: |_| true,
    single_file: write::single_file,
    ..COMMON
};

pub(crate) const TEXT_CODEC: Codec =
    Codec { read: Some(read::read), write: Some(|model| Ok(write::write_text(model))) };

const COMMON: FormatInfo = FormatInfo {
    is_read: true,
    is_written: true,
    companion_extensions: &[("bin", "holds only data: open it together with the glTF model it belongs to")],
    companions: buffers::companions,
    keeps_name: true,
    lacks: &[Part::Polygons, Part::Groups, Part::Smoothing, Part::Creases, Part::Attributes],
    keeps_property: write::keeps,
    // Meshes have one set of texture coordinates.
    keeps_placement: |texture| texture.uv_set == 0,
    losses: write::losses,
    ..FormatInfo::DEFAULT
};
