//! Selecting commands with some of their fields filled in, each with a menu entry of its own.

use editor::Command;
use editor::ops::{
    CompareCount, FACING_ANGLE_DEGREES, SelectByCorners, SelectFacing, SelectMode, SelectSimilar, Similarity,
};
use glam::DVec3;

/// A selecting command with its fields filled in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Preset {
    /// Faces with three corners.
    Triangles,
    /// Faces with four corners.
    Quads,
    /// Faces with more corners.
    NGons,
    /// Faces that face the view.
    TowardsView,
    /// Elements like the one selected last.
    Similar(Similarity),
}

impl Preset {
    /// The command. `to_eye` is the direction from the model to the eye.
    pub(crate) fn command(self, to_eye: DVec3) -> Command {
        let corners =
            |compare, corners| SelectByCorners { corners, compare, mode: SelectMode::Replace }.into();
        match self {
            Self::Triangles => corners(CompareCount::Equal, 3),
            Self::Quads => corners(CompareCount::Equal, 4),
            Self::NGons => corners(CompareCount::More, 4),
            Self::TowardsView => SelectFacing {
                direction: Some(to_eye.as_vec3().to_array()),
                angle: FACING_ANGLE_DEGREES,
                mode: SelectMode::Replace,
            }
            .into(),
            Self::Similar(similarity) => SelectSimilar::by(similarity).into(),
        }
    }
}
