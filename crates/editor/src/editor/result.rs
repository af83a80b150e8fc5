//! The result of local edits: what they leave selected, and whether it is valid.

use super::Editor;
use super::run::local_edits;
use crate::ops::Op;
use crate::outcome::ElementIds;
use crate::selection::Selection;
use halfedge::{Element, Mesh, Touched};

impl Editor {
    /// What operations on the active object's elements leave selected; none if it is what was selected. Someone who works on
    /// vertices or edges goes on with those of the result; with faces, a cut gives edges to go on with.
    pub(super) fn result(&self, ops: &[Op], created: &ElementIds) -> Option<Selection> {
        let mesh = self.mesh()?;
        // Operations of one kind select the same of everything that their step created.
        let made =
            local_edits(ops).next()?.selects(mesh, created).filter(|selection| !selection.is_empty())?;
        let (from, to) = (made.kind(), self.selection.kind());
        if from == to || !matches!(to, Element::Vertex | Element::Edge) {
            return Some(made);
        }
        let ids = surface::selecting::convert(mesh, from, to, made.set());
        Some(Selection::of_set(to, ids, None)).filter(|selection| !selection.is_empty())
    }
}

/// Validates the elements that an edit touched, and those next to the half-edges that it touched.
pub(super) fn validate_touched(mesh: &Mesh, touched: &Touched) -> Result<(), halfedge::Defect> {
    if touched.everything {
        return mesh.validate();
    }
    let mut vertices = touched.vertices.clone();
    let mut faces = touched.faces.clone();
    for &h in touched.halfedges.iter().filter(|h| mesh.has_halfedge(**h)) {
        vertices.push(mesh.to(h));
        faces.extend(mesh.face_of(h));
    }
    vertices.sort_unstable();
    vertices.dedup();
    faces.sort_unstable();
    faces.dedup();
    mesh.validate_near(vertices, faces)
}
