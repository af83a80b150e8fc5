//! What the subdivisions have in common.

use crate::error::Problem;
use serde::{Deserialize, Serialize};
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
pub(super) fn faces_after(faces: usize, levels: u32) -> usize {
    faces.saturating_mul(4usize.saturating_pow(levels))
}

/// A subdivision's refusal; too many faces come of too many levels.
pub(super) fn refused(error: SurfaceError) -> Problem {
    match error {
        SurfaceError::TooManyFaces { .. } => Problem::field("levels", format!("{error}; use fewer levels")),
        other => other.into(),
    }
}
