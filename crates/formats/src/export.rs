//! A document out: which writer, and what the format can't hold.

use crate::bezier::Controls;
use crate::format::Format;
use crate::import::NamedBytes;
use crate::material::Materials;
use crate::{bezier, collada, gltf, json, obj, off, ply, stl};
use glam::DVec3;
use halfedge::Mesh;
use std::fmt;

/// One mesh to write. Ids may have gaps; files are numbered without.
#[derive(Clone, Copy, Debug)]
pub struct ObjectRef<'a> {
    /// Its name in the file.
    pub name: &'a str,
    /// The mesh.
    pub mesh: &'a Mesh,
    /// The control points that the mesh was made from, for formats that hold those; a curve has an
    /// empty mesh.
    pub controls: Option<&'a Controls>,
    /// What to add to every position, as [`Import::offset`](crate::Import::offset) said.
    pub offset: DVec3,
    /// The document's materials, as [`Import::materials`](crate::Import::materials).
    pub materials: &'a Materials,
}

static NO_MATERIALS: Materials = Materials { list: Vec::new(), images: Vec::new() };

impl<'a> ObjectRef<'a> {
    /// A mesh to write.
    pub fn new(name: &'a str, mesh: &'a Mesh) -> Self {
        Self { name, mesh, controls: None, offset: DVec3::ZERO, materials: &NO_MATERIALS }
    }

    /// Whether it is a curve, of which formats for meshes can write nothing.
    pub(crate) fn is_curve(&self) -> bool {
        self.controls.is_some_and(Controls::is_curve)
    }
}

/// Why nothing was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WriteError {
    /// What is wrong and what to do.
    pub message: String,
}

impl WriteError {
    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self { message: message.into() }
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
/// When the document is too large for the format's numbers, or has nothing that the format holds.
pub fn write(format: Format, name: &str, objects: &[ObjectRef]) -> Result<Vec<NamedBytes>, WriteError> {
    let all = objects;
    let meshes: Vec<ObjectRef> = all.iter().filter(|object| !object.is_curve()).copied().collect();
    if meshes.is_empty() && !all.is_empty() && !format.is_bezier() {
        return Err(WriteError::new(format!(
            "{} holds meshes, and the document has only Bezier curves: save it as BZC",
            format.name()
        )));
    }
    let objects = meshes.as_slice();
    Ok(match format {
        Format::BezierCurve | Format::BezierSurface => write_controls(format, name, all)?,
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

fn write_controls(format: Format, name: &str, objects: &[ObjectRef]) -> Result<Vec<NamedBytes>, WriteError> {
    let (files, what) = match format {
        Format::BezierCurve => (bezier::write_curves(name, objects), "curve"),
        _ => (bezier::write_surface(name, objects), "surface"),
    };
    if files.is_empty() {
        return Err(WriteError::new(format!(
            "{} holds control points, and the document has no Bezier {what}: save it in a format for meshes",
            format.name()
        )));
    }
    Ok(files)
}
