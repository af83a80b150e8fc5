//! From the pointer to an amount: pure functions of the camera and two places on the screen.

use glam::{DVec3, Mat3, Vec2, Vec3};
use viewport::Camera;

use super::lock::Lock;

/// A pointer that begins nearer to the middle than this gives no useful ratio of distances, in points.
const MIN_RADIUS_POINTS: f32 = 24.0;
/// A pointer that begins nearer than this is in the middle, which tells no direction from another, in points.
const MIN_DIRECTED_RADIUS_POINTS: f32 = 10.0;
/// From the middle, this many points to the right or up double the size.
const DOUBLING_TRAVEL_POINTS: f32 = 120.0;
/// A direction that the picture shows shorter than this part of its length points at the viewer.
const MIN_VISIBLE_PART: f32 = 0.2;
/// Steps of Newton's method along a line: each doubles the exact digits.
const NEWTON_STEPS: usize = 3;
/// The distance that the pointer travels to slide over a whole edge that points at the viewer, in points.
const EDGE_TRAVEL_POINTS: f32 = 240.0;

/// The camera, the size of its picture in points, and the middle of what moves.
#[derive(Clone, Copy)]
pub(crate) struct Sight<'a> {
    pub camera: &'a Camera,
    pub size: Vec2,
    pub anchor: Vec3,
}

impl Sight<'_> {
    /// The middle of what moves, on the screen.
    pub fn middle(&self) -> Vec2 {
        self.camera.project(self.anchor, self.size).unwrap_or(self.size * 0.5)
    }

    /// Mesh units per point at the depth of what moves.
    pub fn units_per_point(&self) -> f32 {
        let one = self.camera.drag(self.anchor, Vec2::X, self.size) - self.anchor;
        let length = one.length();
        if length.is_finite() && length > 0.0 {
            length
        } else {
            self.camera.units_per_pixel(self.size) as f32
        }
    }

    /// How a step of one mesh unit in a direction moves on the screen; none if it points at the viewer.
    fn on_screen(&self, direction: Vec3) -> Option<Vec2> {
        let unit = self.units_per_point();
        // A step of about a hundred points: long enough to be exact, short enough for the perspective.
        let step = direction * unit * 100.0;
        let ahead = self.camera.project(self.anchor + step, self.size)?;
        let behind = self.camera.project(self.anchor - step, self.size)?;
        let moved = (ahead - behind) / (200.0 * unit);
        (moved.length() * unit > MIN_VISIBLE_PART).then_some(moved)
    }

    /// The distance along a direction for a movement of the pointer: the point on the line that is nearest to the
    /// pointer on the screen. Where the direction points at the viewer, up is more.
    pub fn along(&self, direction: Vec3, by: Vec2) -> f32 {
        let unit = self.units_per_point();
        let Some(moved) = self.on_screen(direction) else { return -by.y * unit };
        let mut distance = by.dot(moved) / moved.length_squared();
        // Newton's method, since perspective shortens what is farther away.
        for _ in 0..NEWTON_STEPS {
            let here = self.anchor + direction * distance;
            let places = [here, here + direction * unit].map(|point| self.camera.project(point, self.size));
            let [Some(at), Some(ahead)] = places else { break };
            let moved = (ahead - at) / unit;
            if moved.length() * unit < MIN_VISIBLE_PART / 2.0 {
                break;
            }
            distance += (by - (at - self.middle())).dot(moved) / moved.length_squared();
        }
        distance
    }

    /// The movement between two places of the pointer within a lock, as numbers along the lock's axes.
    pub fn offset(&self, lock: Lock, axes: Mat3, from: Vec2, to: Vec2) -> Vec3 {
        let free = self.camera.drag(self.anchor, to - from, self.size) - self.anchor;
        match lock {
            Lock::Free => axes.transpose() * free,
            Lock::Along(axis, _) => {
                lock.fill(Vec3::ZERO, |_, _| self.along(axes.col(axis.min(2)), to - from))
            }
            Lock::Across(axis, _) => {
                let normal = axes.col(axis.min(2));
                let in_plane = self.on_plane(normal, from, to).unwrap_or(free - normal * free.dot(normal));
                lock.limited(axes.transpose() * in_plane)
            }
        }
    }

    /// The movement in the plane through the middle; none if the plane is seen from its edge.
    fn on_plane(&self, normal: Vec3, from: Vec2, to: Vec2) -> Option<Vec3> {
        let normal = normal.as_dvec3();
        // The middle moves as the pointer does, wherever the pointer took it.
        let middle = self.middle();
        let hit = |pixel: Vec2| -> Option<DVec3> {
            let ray = self.camera.ray(pixel, self.size);
            let (origin, direction) = (ray.origin.as_dvec3(), ray.direction.as_dvec3());
            let slope = direction.dot(normal);
            let along = (self.anchor.as_dvec3() - origin).dot(normal) / slope;
            (slope.abs() > 0.05 && along > 0.0).then(|| origin + direction * along)
        };
        Some((hit(middle + to - from)? - hit(middle)?).as_vec3())
    }

    /// The degrees about an axis when the pointer goes around the middle, counter-clockwise as seen from the axis's
    /// tip.
    pub fn turn(&self, axis: Vec3, from: Vec2, to: Vec2) -> f32 {
        let (a, b) = (from - self.middle(), to - self.middle());
        if a.length() < 1.0 || b.length() < 1.0 {
            return 0.0;
        }
        let [_, _, forward] = self.camera.axes();
        let towards = axis.as_dvec3().dot(-forward) >= 0.0;
        // On the screen y points down.
        let degrees = -a.perp_dot(b).atan2(a.dot(b)).to_degrees();
        if towards { degrees } else { -degrees }
    }

    /// The factor when the pointer goes away from the middle or towards it.
    pub fn factor(&self, from: Vec2, to: Vec2) -> f32 {
        let (start, by) = (from - self.middle(), to - from);
        let radius = start.length();
        if radius < MIN_DIRECTED_RADIUS_POINTS {
            ((by.x - by.y) / DOUBLING_TRAVEL_POINTS).exp2()
        } else if radius < MIN_RADIUS_POINTS {
            (1.0 + by.dot(start / radius) / MIN_RADIUS_POINTS).max(0.0)
        } else {
            (start + by).length() / radius
        }
    }

    /// The fraction of an edge for a movement along it.
    pub fn fraction(&self, edge: Vec3, by: Vec2) -> f32 {
        match self.on_screen(edge.normalize_or_zero()).filter(|_| edge.length() > 0.0) {
            Some(moved) => by.dot(moved) / moved.length_squared() / edge.length(),
            None => (by.x - by.y) / EDGE_TRAVEL_POINTS,
        }
    }
}

/// The round step of length that is 8 to 80 points long on the screen: a power of ten.
pub(crate) fn length_step(units_per_point: f32) -> f32 {
    let exponent = (units_per_point * 25.0).log10().round();
    if exponent.is_finite() { 10f32.powf(exponent) } else { 1.0 }
}

/// Rounds to a multiple of a step.
pub(crate) fn rounded(value: f32, step: f32) -> f32 {
    let rounded = (f64::from(value) / f64::from(step)).round() * f64::from(step);
    rounded as f32
}

#[cfg(all(test, not(target_arch = "wasm32")))]
mod tests {
    use super::*;
    use crate::transforming::Orientation;
    use proptest::prelude::*;

    const SIZE: Vec2 = Vec2::new(800.0, 600.0);

    fn camera(yaw: f64, pitch: f64, orthographic: bool) -> Camera {
        Camera { yaw, pitch, orthographic, ..Camera::default() }
    }

    proptest! {
        /// What moves stays under the pointer, as far as its lock allows.
        #[test]
        fn the_middle_follows_the_pointer(
            yaw in 0.3f64..1.2, pitch in 0.3f64..1.2, parallel: bool,
            x in -60f32..60.0, y in -60f32..60.0, axis in 0usize..3,
        ) {
            let camera = camera(yaw, pitch, parallel);
            let sight = Sight { camera: &camera, size: SIZE, anchor: Vec3::new(0.2, -0.1, 0.3) };
            let (from, to) = (Vec2::new(100.0, 90.0), Vec2::new(100.0 + x, 90.0 + y));
            let moved = |offset: Vec3| camera.project(sight.anchor + offset, SIZE).expect("in view") - sight.middle();
            let free = sight.offset(Lock::Free, Mat3::IDENTITY, from, to);
            prop_assert!(moved(free).distance(to - from) < 0.5);
            // A plane that is nearly seen from its edge is moved in by the part of the movement that lies in it.
            let [_, _, forward] = camera.axes();
            let steep = forward.as_vec3()[axis].abs() > 0.35;
            let plane = sight.offset(Lock::Across(axis, Orientation::Global), Mat3::IDENTITY, from, to);
            prop_assert_eq!(plane[axis], 0.0);
            prop_assert!(!steep || moved(plane).distance(to - from) < 0.5, "{}", moved(plane));
            let line = sight.offset(Lock::Along(axis, Orientation::Global), Mat3::IDENTITY, from, to);
            prop_assert_eq!(line, Mat3::IDENTITY.col(axis) * line[axis]);
            // Along a line, the rest of the pointer's movement is perpendicular to it.
            let way = Mat3::IDENTITY.col(axis);
            let there = (moved(line + way * 0.01) - moved(line - way * 0.01)).normalize_or_zero();
            let off = (moved(line) - (to - from)).dot(there).abs();
            prop_assert!(forward.as_vec3()[axis].abs() > 0.8 || off < 1.0, "{off} of {}", to - from);
        }

        #[test]
        fn a_circle_is_a_whole_turn(yaw in 0f64..6.2, pitch in -1.4f64..1.4, steps in 8usize..40) {
            let camera = camera(yaw, pitch, false);
            let sight = Sight { camera: &camera, size: SIZE, anchor: Vec3::ZERO };
            let at = |step: usize| {
                let angle = step as f32 / steps as f32 * std::f32::consts::TAU;
                // Counter-clockwise on a screen whose y points down.
                sight.middle() + Vec2::new(angle.cos(), -angle.sin()) * 80.0
            };
            let towards = -camera.axes()[2].as_vec3();
            let turned: f32 = (0..steps).map(|step| sight.turn(towards, at(step), at(step + 1))).sum();
            prop_assert!((turned - 360.0).abs() < 0.1, "{turned}");
            let away: f32 = (0..steps).map(|step| sight.turn(-towards, at(step), at(step + 1))).sum();
            prop_assert!((away + 360.0).abs() < 0.1, "{away}");
        }
    }

    #[test]
    fn a_face_goes_where_the_screen_shows_its_normal() {
        let camera = camera(0.0, 0.0, false);
        let sight = Sight { camera: &camera, size: SIZE, anchor: Vec3::ZERO };
        assert!(sight.along(Vec3::X, Vec2::new(40.0, 0.0)) > 0.0);
        assert!(sight.along(Vec3::NEG_X, Vec2::new(-40.0, 0.0)) > 0.0, "a face on the left goes left");
        assert!(sight.along(Vec3::Y, Vec2::new(0.0, -40.0)) > 0.0, "up is up");
        assert_eq!(sight.along(Vec3::X, Vec2::new(0.0, 40.0)), 0.0, "across the normal nothing happens");
        assert!(sight.along(Vec3::Z, Vec2::new(0.0, -40.0)) > 0.0, "towards the viewer, up is more");
        assert!((sight.factor(Vec2::new(500.0, 300.0), Vec2::new(600.0, 300.0)) - 2.0).abs() < 1e-5);
        assert!(
            (sight.fraction(Vec3::X * 2.0, Vec2::new(40.0, 0.0)) * 2.0 - 40.0 * sight.units_per_point())
                .abs()
                < 1e-3
        );
    }
}
