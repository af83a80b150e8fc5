//! What readers are given and what they give back.

use crate::error::ReadError;
use crate::file::NamedBytes;
use crate::model::NamedMesh;
use crate::model::material::Materials;
use crate::report::{ImportReport, Places};
use crate::room::Room;
use crate::soup::origin::Origin;
use crate::soup::repairs::{self, Repairs};
use halfedge::{Mesh, PolygonSoup, Progress};
use std::sync::Arc;

/// A file to read, with those that were given with it.
pub(crate) struct Source<'a> {
    /// The model file.
    pub file: &'a NamedBytes,
    /// All files, the model included.
    pub files: &'a [NamedBytes],
    /// Those that are not models themselves.
    pub companions: &'a [&'a NamedBytes],
}

/// What readers have to know besides the file.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Reading {
    /// Where positions are counted from, if not from zero.
    pub origin: Option<Origin>,
    /// How faces that form no mesh are made one.
    pub repairs: Repairs,
    /// How much may be read.
    pub room: Room,
    /// The corners of faces that were read so far.
    pub corners: u64,
}

/// What a reader found in a file.
pub(crate) struct Contents {
    /// The meshes, in the file's order.
    pub objects: Vec<NamedMesh>,
    /// The materials that faces have.
    pub materials: Materials,
    /// What was changed or left out.
    pub report: ImportReport,
}

impl From<(NamedMesh, ImportReport)> for Contents {
    fn from((object, report): (NamedMesh, ImportReport)) -> Self {
        Self { objects: vec![object], materials: Materials::default(), report }
    }
}

/// The last step of every reader: makes a mesh of a soup and reports the changes that this took.
pub(crate) fn build(
    name: &str,
    soup: PolygonSoup,
    file: &str,
    reading: &mut Reading,
    report: &mut ImportReport,
    progress: &mut Progress,
) -> Result<NamedMesh, ReadError> {
    if progress(0.0).is_break() {
        return Err(ReadError::Cancelled);
    }
    reading.corners += soup.corners.len() as u64;
    if let Some(why) = reading.room.refusal_of_corners(reading.corners) {
        return Err(ReadError::file(file, why));
    }
    let (mesh, notes, original) =
        repairs::build(soup, &reading.repairs).map_err(|error| ReadError::file(file, error.to_string()))?;
    notes.into_iter().for_each(|note| report.warn(note));
    note_isolated_vertices(&mesh, report);
    if progress(1.0).is_break() {
        return Err(ReadError::Cancelled);
    }
    Ok(NamedMesh { soup: original.map(Arc::new), ..NamedMesh::new(name, mesh) })
}

/// Reports vertices in no face: each counts as a component, which is puzzling if one doesn't know of them.
fn note_isolated_vertices(mesh: &Mesh, report: &mut ImportReport) {
    let mut isolated = Places::default();
    mesh.vertices().filter(|&v| mesh.halfedge_from(v).is_none()).for_each(|v| isolated.add(v.index()));
    if !isolated.is_empty() {
        report.info(isolated.sentence("vertex", "vertices", "in no face, kept as single points", "number"));
    }
}
