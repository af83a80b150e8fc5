//! What the subdivisions share.

use crate::error::Problem;
use crate::ops::choice::choice;
use crate::ops::{DefaultValue, Estimate, Field};
use surface::{BoundaryRule, SUBDIVISION_LEVELS_RANGE, SurfaceError};

choice! {
    /// What subdivision does at the boundary.
    pub enum Boundary {
        /// The boundary becomes a smooth curve.
        EdgeOnly = "edge-only" "Smooth everywhere",
        /// As `EdgeOnly`, but vertices with one face stay where they are.
        EdgeAndCorner = "edge-and-corner" "Keep corners",
    }
}

impl From<Boundary> for BoundaryRule {
    fn from(boundary: Boundary) -> Self {
        match boundary {
            Boundary::EdgeOnly => Self::EdgeOnly,
            Boundary::EdgeAndCorner => Self::EdgeAndCorner,
        }
    }
}

/// The default number of levels.
pub(super) const LEVELS: u32 = 1;

/// The `levels` field.
pub(super) const fn levels() -> Field {
    Field::count("levels", SUBDIVISION_LEVELS_RANGE, "The number of levels").or(DefaultValue::Integer(LEVELS))
}

/// The `boundary` field.
pub(super) const fn boundary() -> Field {
    Boundary::field("boundary", "Whether corners of the boundary stay")
}

/// The number of faces after cutting each into four this often.
pub(super) fn faces_after(faces: usize, levels: u32) -> usize {
    faces.saturating_mul(4usize.saturating_pow(levels))
}

/// The number of quads after these levels of a subdivision that makes one of each corner at first.
pub(super) fn quads_after(corners: usize, levels: u32) -> usize {
    faces_after(corners, levels.saturating_sub(1))
}

pub(super) fn estimate(faces: usize) -> Option<Estimate> {
    // A count that doesn't fit is refused when it runs.
    (faces < usize::MAX).then(|| Estimate::faces(faces))
}

/// A subdivision's refusal; too many faces come of too many levels.
pub(super) fn refused(error: SurfaceError) -> Problem {
    match error {
        SurfaceError::TooManyFaces { .. } => Problem::field("levels", format!("{error}; use fewer levels")),
        other => other.into(),
    }
}
