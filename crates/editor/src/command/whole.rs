//! What the operations have in common that make one mesh of each.

use super::{Input, Output, WholeMesh};
use crate::error::Problem;
use halfedge::{Mesh, Progress};
use std::ops::ControlFlow;

/// An operation that makes one mesh of each: the frame around an algorithm.
pub(crate) trait EachMesh {
    /// Looks at the fields: what can be refused without looking at a mesh.
    fn check(&self) -> Result<(), Problem> {
        Ok(())
    }

    /// Makes the new mesh. What the user should know besides goes to `notes`.
    fn make(
        &self,
        mesh: &Mesh,
        notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Mesh, Problem>;

    /// How much work it is, in faces to look at or to make.
    fn cost(&self, mesh: &Mesh) -> usize;
}

impl<T: EachMesh> WholeMesh for T {
    fn check(&self) -> Result<(), Problem> {
        EachMesh::check(self)
    }

    fn compute(
        &self,
        inputs: &[Input],
        notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Vec<Output>, Problem> {
        let mut outputs = Vec::with_capacity(inputs.len());
        for (at, input) in inputs.iter().enumerate() {
            let mut part =
                |fraction: f32| -> ControlFlow<()> { progress((at as f32 + fraction) / inputs.len() as f32) };
            outputs.push(Output::new("", self.make(&input.mesh, notes, &mut part)?));
        }
        Ok(outputs)
    }

    fn cost(&self, inputs: &[Input]) -> usize {
        inputs.iter().map(|input| EachMesh::cost(self, &input.mesh)).fold(0, usize::saturating_add)
    }
}

/// How many faces there are to look at.
pub(super) fn faces(inputs: &[Input]) -> usize {
    inputs.iter().map(|input| input.mesh.face_count()).sum()
}

/// Refuses to do nothing.
pub(super) fn at_least_one(times: u32, field: &str) -> Result<(), Problem> {
    if times == 0 { Err(Problem::field(field, "0 does nothing; it must be 1 or more")) } else { Ok(()) }
}
