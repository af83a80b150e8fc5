//! The results of operations: computed, validated, and what they leave selected.

use super::Editor;
use super::run::{broken, local_edits};
use crate::document::ObjectId;
use crate::error::Problem;
use crate::job;
use crate::ops::{Op, Symmetry};
use crate::outcome::ElementIds;
use crate::selection::Selection;
use halfedge::{Element, Mesh, Touched};

impl Editor {
    /// The valid result of a whole-mesh operation on objects.
    pub(super) fn compute(
        &self,
        op: &Op,
        objects: &[ObjectId],
        progress: &mut halfedge::Progress<'_>,
    ) -> Result<job::Made, Problem> {
        self.compute_all(std::slice::from_ref(op), Symmetry::None, objects, progress)
    }

    /// The valid result of the operations that a command resolved to.
    pub(super) fn compute_all(
        &self,
        ops: &[Op],
        symmetry: Symmetry,
        objects: &[ObjectId],
        progress: &mut halfedge::Progress<'_>,
    ) -> Result<job::Made, Problem> {
        let made = job::run(ops, symmetry, &self.inputs(objects), progress)?;
        made.validate().map_err(|defect| broken(&defect))?;
        Ok(made)
    }

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
