//! What the subdivisions have in common.

use super::{Input, Output};
use crate::error::Problem;
use halfedge::{Mesh, Progress};
use serde::{Deserialize, Serialize};
use std::ops::ControlFlow;
use std::sync::Arc;
use surface::{BoundaryRule, SurfaceError};

/// What subdivision does at the boundary.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Boundary {
    /// The boundary becomes a smooth curve.
    #[default]
    EdgeOnly,
    /// As `EdgeOnly`, but vertices with one face stay where they are.
    EdgeAndCorner,
}

impl From<Boundary> for BoundaryRule {
    fn from(boundary: Boundary) -> Self {
        match boundary {
            Boundary::EdgeOnly => Self::EdgeOnly,
            Boundary::EdgeAndCorner => Self::EdgeAndCorner,
        }
    }
}

/// The names of [`Boundary`] in JSON.
pub(super) const BOUNDARY_NAMES: &[&str] = &["edge-only", "edge-and-corner"];

/// The most levels that menus offer; a result that is too large is refused whatever the level.
pub(super) const MOST_LEVELS: u32 = 12;

pub(super) fn one() -> u32 {
    1
}

/// How many faces there are after that many levels of cutting each into four.
pub(super) fn faces_after(inputs: &[Input], levels: u32) -> usize {
    let faces: usize = inputs.iter().map(|input| input.mesh.face_count()).sum();
    faces.saturating_mul(4usize.saturating_pow(levels))
}

/// Runs an algorithm on each input, its result in place of it.
pub(super) fn each(
    inputs: &[Input],
    progress: &mut Progress<'_>,
    algorithm: impl Fn(&Mesh, &mut Progress<'_>) -> Result<Mesh, SurfaceError>,
) -> Result<Vec<Output>, Problem> {
    let mut outputs = Vec::with_capacity(inputs.len());
    for (at, input) in inputs.iter().enumerate() {
        let mut part =
            |fraction: f32| -> ControlFlow<()> { progress((at as f32 + fraction) / inputs.len() as f32) };
        let mesh = algorithm(&input.mesh, &mut part).map_err(|error| match error {
            SurfaceError::TooManyFaces { .. } => Problem::field("levels", error.to_string()),
            other => other.into(),
        })?;
        outputs.push(Output { name: String::new(), mesh: Arc::new(mesh) });
    }
    Ok(outputs)
}

/// Refuses to do nothing.
pub(super) fn check_levels(levels: u32) -> Result<(), Problem> {
    if levels == 0 { Err(Problem::field("levels", "0 does nothing; it must be 1 or more")) } else { Ok(()) }
}
