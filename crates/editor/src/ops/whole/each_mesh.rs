//! Operations that replace each mesh by one other.

use crate::error::Problem;
use crate::ops::{Estimate, Facts, NamedMesh, WholeMesh, refuse_bezier};
use halfedge::geometry::BitSet;
use halfedge::{Element, Mesh, Progress};
use std::ops::ControlFlow;

/// An operation that replaces each mesh by one other: the frame around an algorithm.
pub(super) trait EachMesh {
    /// Checks the fields: what can be refused without looking at a mesh.
    fn check(&self) -> Result<(), Problem> {
        Ok(())
    }

    /// Checks a mesh, as far as it can be refused without running. Costs O(mesh) at most.
    fn check_mesh(&self, mesh: &Mesh) -> Result<(), Problem> {
        let _ = mesh;
        Ok(())
    }

    /// Whether there is nothing to do on a mesh without faces.
    fn needs_faces(&self) -> bool {
        true
    }

    /// Makes the new mesh. Warnings go to `notes`.
    fn make(
        &self,
        mesh: &Mesh,
        notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Mesh, Problem>;

    /// The elements of the result that a set of elements of one kind became; none where the result is made anew.
    fn follow(&self, mesh: &Mesh, element: Element, set: &BitSet) -> Option<BitSet> {
        let _ = (mesh, element, set);
        None
    }

    /// How large the result is.
    fn result(&self, facts: &Facts) -> Option<Estimate>;

    /// The work in faces read or made, at least as many as the result has. Costs O(mesh) at most.
    fn cost(&self, mesh: &Mesh) -> usize;
}

impl<T: EachMesh> WholeMesh for T {
    fn check(&self) -> Result<(), Problem> {
        EachMesh::check(self)
    }

    fn check_inputs(&self, inputs: &[NamedMesh]) -> Result<(), Problem> {
        inputs.iter().try_for_each(|input| {
            refuse_bezier(&input.name, input.bezier.as_deref())?;
            self.check_mesh(&input.mesh)
        })
    }

    fn changes_nothing(&self, inputs: &[NamedMesh]) -> Option<&'static str> {
        let is_empty = inputs.iter().all(|input| input.mesh.face_count() == 0);
        (self.needs_faces() && is_empty).then_some("The mesh has no face.")
    }

    fn compute(
        &self,
        inputs: &[NamedMesh],
        notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Vec<NamedMesh>, Problem> {
        let mut outputs = Vec::with_capacity(inputs.len());
        for (at, input) in inputs.iter().enumerate() {
            let mut part =
                |fraction: f32| -> ControlFlow<()> { progress((at as f32 + fraction) / inputs.len() as f32) };
            // Algorithms on faces drop vertices that have none; where there is nothing to do, those stay.
            let is_idle = self.needs_faces() && input.mesh.face_count() == 0;
            let made =
                if is_idle { Mesh::clone(&input.mesh) } else { self.make(&input.mesh, notes, &mut part)? };
            outputs.push(NamedMesh::new("", made));
        }
        Ok(outputs)
    }

    fn follow(&self, mesh: &Mesh, element: Element, set: &BitSet) -> Option<BitSet> {
        EachMesh::follow(self, mesh, element, set)
    }

    fn result(&self, facts: &Facts) -> Option<Estimate> {
        EachMesh::result(self, facts)
    }

    fn cost(&self, inputs: &[NamedMesh]) -> usize {
        inputs.iter().map(|input| EachMesh::cost(self, &input.mesh)).fold(0, usize::saturating_add)
    }
}
