//! Control points as files and documents have them: a curve, or a surface of patches.

use super::{Curve, Patch, tessellate};
use glam::Vec3;
use halfedge::{Mesh, TooLarge};

/// The control points of a Bezier object.
#[derive(Clone, Debug, PartialEq)]
pub enum Bezier {
    /// A curve.
    Curve(Curve),
    /// A surface: its patches.
    Surface(Vec<Patch>),
}

/// The approximate number of faces in a surface's preview, which is rebuilt at each movement of a control
/// point.
const MAX_PREVIEW_FACES: usize = 20_000;

/// The most quads along a patch's side in a preview.
const MAX_PREVIEW_RESOLUTION: usize = 8;

impl Bezier {
    /// "Bezier curve" or "Bezier surface".
    pub fn name(&self) -> &'static str {
        match self {
            Self::Curve(_) => "Bezier curve",
            Self::Surface(_) => "Bezier surface",
        }
    }

    /// The curve, if it is one.
    pub fn curve(&self) -> Option<&Curve> {
        match self {
            Self::Curve(curve) => Some(curve),
            Self::Surface(_) => None,
        }
    }

    /// The patches of a surface; empty for a curve.
    pub fn patches(&self) -> &[Patch] {
        match self {
            Self::Curve(_) => &[],
            Self::Surface(patches) => patches,
        }
    }

    /// All control points, patch by patch and row by row.
    pub fn points(&self) -> Vec<Vec3> {
        match self {
            Self::Curve(curve) => curve.points.clone(),
            Self::Surface(patches) => patches.iter().flat_map(|patch| patch.rows).flatten().collect(),
        }
    }

    /// The curve or the patches with these points, in the order of [`Bezier::points`]; points too few for
    /// another patch are left out.
    pub fn from_points(is_curve: bool, points: Vec<Vec3>) -> Self {
        if is_curve {
            return Self::Curve(Curve { points });
        }
        let (rows, _) = points.as_chunks::<4>();
        let (patches, _) = rows.as_chunks::<4>();
        Self::Surface(patches.iter().map(|&rows| Patch { rows }).collect())
    }

    /// The number of quads along a patch's side in the mesh of [`Bezier::preview`].
    pub fn preview_resolution(&self) -> u32 {
        let faces_per_patch = MAX_PREVIEW_FACES / self.patches().len().max(1);
        faces_per_patch.isqrt().clamp(1, MAX_PREVIEW_RESOLUTION) as u32
    }

    /// The preview mesh of a surface; empty for a curve. Costs O(its faces).
    ///
    /// # Errors
    /// [`TooLarge`] when the surface has more patches than a mesh can show.
    pub fn preview(&self) -> Result<Mesh, TooLarge> {
        match self {
            Self::Curve(_) => Ok(Mesh::new()),
            Self::Surface(patches) => tessellate(patches, self.preview_resolution()).map(|made| made.mesh),
        }
    }

    /// Approximate memory use of the control points, in bytes.
    pub fn bytes(&self) -> usize {
        match self {
            Self::Curve(curve) => curve.points.len() * size_of::<Vec3>(),
            Self::Surface(patches) => patches.len() * size_of::<Patch>(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_make_the_same_curve_or_surface() {
        let points: Vec<Vec3> = (0..35).map(|i| Vec3::splat(i as f32)).collect();
        let curve = Bezier::from_points(true, points.clone());
        assert_eq!(
            (curve.points(), curve.curve().map(|curve| curve.points.len())),
            (points.clone(), Some(35))
        );
        let surface = Bezier::from_points(false, points.clone());
        assert_eq!(surface.points(), points[..32], "two patches, and three points too few for another");
        assert_eq!(Bezier::from_points(false, surface.points()), surface);
    }
}
