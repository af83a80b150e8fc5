//! A document out: which writer, and what the format can't hold.

use crate::format::Format;
use crate::import::NamedBytes;
use crate::{collada, gltf, json, obj, off, ply, stl};
use halfedge::Mesh;
use std::fmt;

/// One mesh to write. Ids may have gaps; files are numbered without.
#[derive(Clone, Copy, Debug)]
pub struct ObjectRef<'a> {
    /// Its name in the file.
    pub name: &'a str,
    /// The mesh.
    pub mesh: &'a Mesh,
}

/// Why nothing was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WriteError {
    /// What is wrong and what to do.
    pub message: String,
}

impl WriteError {
    pub(crate) fn new(message: &str) -> Self {
        Self { message: message.to_owned() }
    }
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for WriteError {}

/// Writes objects as one document: the model file first, then what belongs beside it. `name` is
/// the document's, without extension; the files are called after it.
///
/// # Errors
/// When the document is too large for the format's numbers.
pub fn write(format: Format, name: &str, objects: &[ObjectRef]) -> Result<Vec<NamedBytes>, WriteError> {
    Ok(match format {
        Format::Obj => obj::write(name, objects),
        Format::Ply => ply::write(name, objects)?,
        Format::PlyText => ply::write_text(name, objects),
        Format::Stl => stl::write(name, objects)?,
        Format::StlText => stl::write_text(name, objects),
        Format::Off => off::write(name, objects),
        Format::Collada => collada::write(name, objects),
        Format::Glb => gltf::write_binary(name, objects)?,
        Format::Gltf => gltf::write_text(name, objects),
        Format::Json => json::write(name, objects),
    })
}
