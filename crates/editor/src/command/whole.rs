//! What the operations have in common that make one mesh of each.

use super::{Input, Output};
use crate::error::Problem;
use halfedge::{Mesh, Progress};
use std::ops::ControlFlow;

/// Runs an algorithm on each input, its result in place of it.
pub(super) fn each(
    inputs: &[Input],
    progress: &mut Progress<'_>,
    mut algorithm: impl FnMut(&Mesh, &mut Progress<'_>) -> Result<Mesh, Problem>,
) -> Result<Vec<Output>, Problem> {
    let mut outputs = Vec::with_capacity(inputs.len());
    for (at, input) in inputs.iter().enumerate() {
        let mut part =
            |fraction: f32| -> ControlFlow<()> { progress((at as f32 + fraction) / inputs.len() as f32) };
        let mesh = algorithm(&input.mesh, &mut part)?;
        outputs.push(Output::new("", mesh));
    }
    Ok(outputs)
}

/// How many faces there are to look at.
pub(super) fn faces(inputs: &[Input]) -> usize {
    inputs.iter().map(|input| input.mesh.face_count()).sum()
}

/// Refuses to do nothing.
pub(super) fn at_least_one(times: u32, field: &str) -> Result<(), Problem> {
    if times == 0 { Err(Problem::field(field, "0 does nothing; it must be 1 or more")) } else { Ok(()) }
}
