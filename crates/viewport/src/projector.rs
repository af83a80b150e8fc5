//! From points in space to places on the screen.

use glam::{DVec2, DVec3, Vec2, Vec3};

/// A camera's projection, with everything precomputed that doesn't depend on the point.
#[derive(Clone, Copy)]
pub(crate) struct Projector {
    pub(super) axes: [DVec3; 3],
    pub(super) eye: DVec3,
    pub(super) middle: DVec2,
    /// Pixels per unit at depth 1.
    pub(super) focal: f64,
    /// Points nearer than this depth count as behind the eye.
    pub near: f64,
    /// For a parallel projection, the depth whose scale is used for all depths.
    pub(super) parallel: Option<f64>,
}

impl Projector {
    /// The place of a point on the viewport, and its depth; none if it is behind the eye.
    pub fn project(&self, point: Vec3) -> Option<(Vec2, f64)> {
        let [right, up, forward] = self.axes;
        let from_eye = point.as_dvec3() - self.eye;
        let depth = from_eye.dot(forward);
        if depth < self.near {
            return None;
        }
        let across = DVec2::new(from_eye.dot(right), -from_eye.dot(up));
        Some(((self.middle + across / self.units_per_pixel(depth)).as_vec2(), depth))
    }

    pub fn depth(&self, point: Vec3) -> f64 {
        (point.as_dvec3() - self.eye).dot(self.axes[2])
    }

    pub fn units_per_pixel(&self, depth: f64) -> f64 {
        self.parallel.unwrap_or(depth) / self.focal
    }

    /// A number that grows towards the eye and is linear across the screen on a plane.
    pub fn nearness(&self, depth: f64) -> f32 {
        (if self.parallel.is_some() { -depth } else { 1.0 / depth }) as f32
    }

    /// The depth for a nearness.
    pub fn depth_of(&self, nearness: f32) -> f64 {
        let nearness = f64::from(nearness);
        if self.parallel.is_some() { -nearness } else { 1.0 / nearness }
    }
}
