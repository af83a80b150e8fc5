//! Axis-aligned bounds: what the camera frames and fits its depth range to.

use glam::Vec3;
use halfedge::Mesh;

/// An axis-aligned box, in mesh units. Both corners are finite and `min <= max` in each axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// The corner with the smallest coordinates.
    pub min: Vec3,
    /// The corner with the largest coordinates.
    pub max: Vec3,
}

impl Bounds {
    /// The bounds of points; none when there are none. Points that are not finite are left out.
    pub fn of_points(points: impl IntoIterator<Item = Vec3>) -> Option<Self> {
        points.into_iter().filter(|p| p.is_finite()).fold(None, |bounds: Option<Self>, p| {
            Some(bounds.map_or(Self { min: p, max: p }, |b| Self { min: b.min.min(p), max: b.max.max(p) }))
        })
    }

    /// The bounds of all vertices, isolated ones too. Costs O(vertices).
    pub fn of_mesh(mesh: &Mesh) -> Option<Self> {
        if mesh.vertex_count() == mesh.vertex_capacity() {
            return Self::of_points(mesh.positions().iter().copied());
        }
        Self::of_points(mesh.vertices().map(|v| mesh.position(v)))
    }

    /// The smallest box around both.
    #[must_use]
    pub fn union(self, other: Self) -> Self {
        Self { min: self.min.min(other.min), max: self.max.max(other.max) }
    }

    /// The middle. Computed without overflow for any finite corners.
    pub fn center(&self) -> Vec3 {
        self.min * 0.5 + self.max * 0.5
    }

    /// Half the diagonal: the radius of the sphere around the box.
    pub fn radius(&self) -> f64 {
        (self.max.as_dvec3() - self.min.as_dvec3()).length() * 0.5
    }
}
