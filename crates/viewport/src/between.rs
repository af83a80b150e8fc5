//! Cameras between two others, for moves of the view that take a moment.

use crate::Camera;
use std::f64::consts::{PI, TAU};

/// A camera with less of the perspective than this part is drawn without: the difference can't be seen.
const LEAST_PERSPECTIVE: f64 = 0.02;

impl Camera {
    /// The camera that has gone this part of the way to another one: 0 is this one, 1 the other. Turns take the shorter
    /// way. What zooms and moves at once does so about the point that stays in place. Between a perspective and a parallel
    /// projection the field of view narrows while the eye goes back.
    pub fn between(&self, to: &Self, part: f64) -> Self {
        let ratio = to.distance / self.distance;
        if part >= 1.0 || !(ratio.is_finite() && ratio > 0.0) {
            return *to;
        }
        let mix = |from: f64, to: f64| from + (to - from) * part;
        let turned = |from: f64, to: f64| mix(from, from + (to - from + PI).rem_euclid(TAU) - PI);
        let factor = ratio.powf(part);
        // In a zoom the target moves as the distance does, so that one point stays where it is.
        let moved = if (ratio - 1.0).abs() < 1e-6 { part } else { (factor - 1.0) / (ratio - 1.0) };
        let camera = Self {
            target: self.target.lerp(to.target, moved),
            yaw: turned(self.yaw, to.yaw).rem_euclid(TAU),
            pitch: mix(self.pitch, to.pitch),
            roll: turned(self.roll, to.roll),
            distance: self.distance * factor,
            fov_y: mix(self.fov_y, to.fov_y),
            ..*to
        };
        let perspective = |camera: &Self| if camera.orthographic { 0.0 } else { 1.0 };
        camera.with_perspective(mix(perspective(self), perspective(to)))
    }

    /// Whether it shows what another one shows in the same viewport.
    pub fn shows_the_same(&self, other: &Self) -> bool {
        Self { frame_share: other.frame_share, scene_bounds: other.scene_bounds, ..*self } == *other
    }

    /// The camera with a part of its perspective, which sees as much at the target.
    fn with_perspective(self, part: f64) -> Self {
        if part < LEAST_PERSPECTIVE {
            return Self { orthographic: true, ..self };
        }
        let tan = (self.fov_y * 0.5).tan() * part;
        let (fov_y, distance) =
            if part < 1.0 { (2.0 * tan.atan(), self.distance / part) } else { (self.fov_y, self.distance) };
        Self { fov_y, distance, orthographic: false, ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Side;
    use glam::{DVec3, Vec3, dvec3, vec2};

    #[test]
    fn a_move_begins_and_ends_where_it_should() {
        let from = Camera { roll: 0.3, ..Camera::default() };
        let mut to = Camera { target: dvec3(1.0, 2.0, 3.0), distance: 0.5, ..from };
        to.look_from(Side::Left);
        to.orthographic = true;
        assert!(from.between(&to, 0.0).shows_the_same(&from));
        assert_eq!(from.between(&to, 1.0), to);
        assert!(!from.shows_the_same(&to));
    }

    #[test]
    fn turns_take_the_shorter_way() {
        let at = |yaw: f64| Camera { yaw, ..Camera::default() };
        let half = at(0.2).between(&at(TAU - 0.4), 0.5);
        assert!((half.yaw - (TAU - 0.1)).abs() < 1e-9, "{}", half.yaw);
        let half = at(TAU - 0.4).between(&at(0.2), 0.5);
        assert!((half.yaw - (TAU - 0.1)).abs() < 1e-9, "{}", half.yaw);
    }

    #[test]
    fn a_zoom_keeps_the_point_under_the_pointer_in_place() {
        let size = vec2(800.0, 600.0);
        for factor in [1.12, 0.01, 300.0] {
            let from = Camera::default();
            let pixel = vec2(613.0, 122.0);
            let ray = from.ray(pixel, size);
            let [_, _, forward] = from.axes();
            let along = from.distance / ray.direction.as_dvec3().dot(forward);
            let point = (ray.origin.as_dvec3() + ray.direction.as_dvec3() * along).as_vec3();
            let mut to = from;
            to.zoom(factor, pixel, size);
            for part in [0.1, 0.5, 0.9] {
                let at = from.between(&to, part).project(point, size).expect("in front of the eye");
                assert!(at.distance(pixel) < 0.05, "{factor} {part}: {at}");
            }
        }
    }

    #[test]
    fn between_projections_the_target_keeps_its_scale() {
        let size = vec2(800.0, 600.0);
        let from = Camera::default();
        let to = Camera { orthographic: true, ..from };
        let [right, _, forward] = from.axes();
        let beside = (from.target + right).as_vec3();
        let behind = (from.target + right + forward).as_vec3();
        let across = |camera: &Camera, point: Vec3| {
            let at = |point| camera.project(point, size).expect("in front of the eye");
            f64::from(at(point).x - at(DVec3::ZERO.as_vec3()).x)
        };
        let mut last = across(&from, behind);
        for part in [0.2, 0.5, 0.8, 0.95, 0.99] {
            let camera = from.between(&to, part);
            assert!((across(&camera, beside) - across(&from, beside)).abs() < 0.01, "{part}");
            let now = across(&camera, behind);
            assert!(now >= last, "what is behind grows to the size of what is in front");
            last = now;
        }
        assert!((last - across(&to, behind)).abs() < 1.0);
    }
}
