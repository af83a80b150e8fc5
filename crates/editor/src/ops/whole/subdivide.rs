//! What the subdivisions share.

use crate::error::Problem;
use crate::ops::choice::choice;
use crate::ops::{DefaultValue, Estimate, Field};
use surface::{BoundaryRule, SurfaceError};

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

/// The highest level that forms offer; a result that is too large is refused whatever the level.
const MAX_FORM_LEVELS: u32 = 12;

/// The most levels. Meshes with faces reach their own limit long before; those without have none.
const MAX_LEVELS: u32 = 1000;

/// The default number of levels.
pub(super) const LEVELS: u32 = 1;

/// The `levels` field.
pub(super) const fn levels() -> Field {
    Field::count("levels", [1, MAX_FORM_LEVELS], "The number of levels").or(DefaultValue::Integer(LEVELS))
}

/// The `boundary` field.
pub(super) const fn boundary() -> Field {
    Boundary::field("boundary", "Whether corners of the boundary stay")
}

/// Refuses 0 levels, and too many.
pub(super) fn check_levels(levels: u32) -> Result<(), Problem> {
    if levels == 0 {
        return Err(Problem::field("levels", "0 does nothing; it must be 1 or more"));
    }
    if levels > MAX_LEVELS {
        return Err(Problem::field(
            "levels",
            format!("{levels} levels make too many faces; use fewer levels"),
        ));
    }
    Ok(())
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
