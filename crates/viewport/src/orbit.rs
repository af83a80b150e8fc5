//! Turning a camera: about a point, on a turntable or freely.

use crate::Camera;
use crate::camera::MAX_PITCH_RADIANS;
use glam::{DVec3, Vec2};

/// How a drag turns a camera.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Rotation {
    /// Sideways about the up axis, up and down to the poles: the up axis stays upright.
    #[default]
    Turntable,
    /// About the picture's own axes, over the poles: the view may be tilted.
    Trackball,
}

impl Camera {
    /// Turns for a drag of `delta` pixels; a drag over the viewport's height is half a turn. The point at `center`
    /// stays where it is in the picture; without one the target does.
    pub fn turn(&mut self, rotation: Rotation, center: Option<DVec3>, delta: Vec2, viewport: Vec2) {
        let before = self.axes();
        match rotation {
            Rotation::Turntable => self.orbit(delta, viewport),
            Rotation::Trackball => self.roll_ball(delta, viewport),
        }
        if let Some(center) = center {
            let to_target = self.target - center;
            let turned = before.iter().zip(self.axes()).map(|(old, new)| new * to_target.dot(*old));
            self.target = center + turned.sum::<DVec3>();
        }
    }

    /// Looks at the target in a direction, with the up axis upright.
    pub fn look_along(&mut self, forward: DVec3) {
        let Some(forward) = forward.try_normalize() else { return };
        self.set_back(self.up.to_upright(-forward));
        self.roll = 0.0;
    }

    /// Turns about the picture's own axes.
    fn roll_ball(&mut self, delta: Vec2, viewport: Vec2) {
        let by = delta.as_dvec2() * (std::f64::consts::PI / f64::from(viewport.y.max(1.0)));
        let [right, up, forward] = self.axes();
        let axis = up * -by.x + right * -by.y;
        let Some(unit) = axis.try_normalize() else { return };
        let turn = glam::DQuat::from_axis_angle(unit, axis.length());
        let back = self.up.to_upright(turn * -forward);
        let right = self.up.to_upright(turn * right);
        self.set_back(back);
        // How far the picture is tilted from the upright one in the same direction.
        self.roll = 0.0;
        let [level, upright, _] = self.axes().map(|axis| self.up.to_upright(axis));
        self.roll = right.dot(upright).atan2(right.dot(level));
    }

    /// Sets the direction from the target to the eye, a unit vector with y as the up axis.
    fn set_back(&mut self, back: DVec3) {
        let level = back.x.hypot(back.z);
        // More precise near the poles than the arcsine of y.
        self.pitch = back.y.atan2(level).clamp(-MAX_PITCH_RADIANS, MAX_PITCH_RADIANS);
        // At the poles every yaw looks along the axis; the present one turns least.
        if level > 1e-9 {
            self.yaw = back.x.atan2(back.z).rem_euclid(std::f64::consts::TAU);
        }
    }
}
