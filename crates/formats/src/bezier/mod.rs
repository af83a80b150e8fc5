//! Bezier curves (`.bzc`) and surfaces (`.bez`) as the CS184 course has them: text, a count, then
//! the control points.
//!
//! A curve is its number of control points, then `x y` for each; `x y z` is understood too, since
//! the count tells the two apart. A surface is its number of patches, then 16 points `x y z` for
//! each, row by row. These files hold control points and no mesh: the editor makes one.

mod read;
mod write;

pub(crate) use read::{kind, read};
pub(crate) use write::{write_curves, write_surface};

use glam::Vec3;

/// Control points that a file holds in place of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub enum Controls {
    /// A curve: its control points in order, at least one. A plane curve has z = 0.
    Curve(Vec<Vec3>),
    /// Bicubic patches: four rows of four control points each.
    Surface(Vec<[[Vec3; 4]; 4]>),
}

impl Controls {
    /// All control points, patch by patch and row by row.
    pub fn points(&self) -> &[Vec3] {
        match self {
            Self::Curve(points) => points,
            Self::Surface(patches) => patches.as_flattened().as_flattened(),
        }
    }

    /// What [`Controls::points`] gave, as a curve or as patches; points that are too few for
    /// another patch are left out.
    pub fn from_points(is_curve: bool, points: Vec<Vec3>) -> Self {
        if is_curve {
            return Self::Curve(points);
        }
        let (rows, _) = points.as_chunks::<4>();
        let (patches, _) = rows.as_chunks::<4>();
        Self::Surface(patches.to_vec())
    }

    /// Whether it is a curve.
    pub fn is_curve(&self) -> bool {
        matches!(self, Self::Curve(_))
    }
}
