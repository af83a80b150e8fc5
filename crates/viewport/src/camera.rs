//! The orbit camera, and the mapping between the mesh and the screen.
//!
//! Everything is computed in double precision and relative to the eye, so that a model of 1e-4
//! units and one 1e6 units from the origin both keep the precision of their coordinates. Angles are in radians; in pixels,
//! y points down.

use crate::projector::Projector;
use crate::{Side, UpAxis};
use glam::{DVec2, DVec3, Mat4, Vec2, Vec3, dvec3};
use surface::{Ray, measure::Bounds};

/// The steepest pitch: straight up or down.
pub(crate) const MAX_PITCH_RADIANS: f64 = std::f64::consts::FRAC_PI_2;
/// The near plane's distance from the eye, as a fraction of the distance to the target: what it is where no surface is
/// nearer, and the least.
const NEAR_FRACTION: f64 = 0.02;
const MIN_NEAR_FRACTION: f64 = 1e-5;
/// The near plane's distance as a fraction of that to the nearest surface: less than the cosine of half the field of view
/// across the corners, so that the plane leaves out nothing.
const NEAR_PER_SURFACE: f64 = 0.4;
/// The initial direction of view: a little from the right and above.
const START_YAW_RADIANS: f64 = 0.6;
const START_PITCH_RADIANS: f64 = 0.42;
/// The initial vertical field of view.
const START_FOV_RADIANS: f64 = 0.7;

/// A camera that looks at a target from a direction and a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The point that the camera turns around, in the middle of the picture.
    pub target: DVec3,
    /// Rotation about the up axis, in radians; 0 looks along -z.
    pub yaw: f64,
    /// Angle above the horizon, in radians from -pi/2 to pi/2.
    pub pitch: f64,
    /// How far the picture's right side is tilted upwards, in radians; 0 keeps the up axis upright.
    pub roll: f64,
    /// The distance from the eye to the target, in mesh units.
    pub distance: f64,
    /// Vertical field of view, in radians. The orthographic view shows as much as the perspective one
    /// does at the target.
    pub fov_y: f64,
    /// Which axis points upwards.
    pub up: UpAxis,
    /// Whether the projection is parallel.
    pub orthographic: bool,
    /// The share of the viewport's width and height that framed things fill at most, above 0. The rest is for
    /// what lies over the picture.
    pub frame_share: DVec2,
    /// The bounds of all objects; see [`Camera::set_scene`].
    pub scene_bounds: Option<Bounds>,
    /// The distance from the eye to the nearest surface, if it may be nearer than the near plane otherwise is.
    pub surface_distance: Option<f64>,
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            target: DVec3::ZERO,
            yaw: START_YAW_RADIANS,
            pitch: START_PITCH_RADIANS,
            roll: 0.0,
            distance: 5.0,
            fov_y: START_FOV_RADIANS,
            up: UpAxis::Y,
            orthographic: false,
            frame_share: DVec2::ONE,
            scene_bounds: None,
            surface_distance: None,
        }
    }
}

impl Camera {
    /// Sets the scene's bounds, which determine the depth range, the limits of the zoom and
    /// [`Camera::reset`]. Call it when they change; the view stays.
    pub fn set_scene(&mut self, scene: Option<Bounds>) {
        self.scene_bounds = scene.filter(is_box);
    }

    /// The scene's bounds, unless it is empty.
    pub fn scene(&self) -> Option<Bounds> {
        self.scene_bounds.filter(is_box)
    }

    /// The unit vectors right, up and forward in the picture.
    pub fn axes(&self) -> [DVec3; 3] {
        let (sin_yaw, cos_yaw) = self.yaw.sin_cos();
        let (sin_pitch, cos_pitch) = self.pitch.sin_cos();
        let back = dvec3(sin_yaw * cos_pitch, sin_pitch, cos_yaw * cos_pitch);
        let right = dvec3(cos_yaw, 0.0, -sin_yaw);
        let up = back.cross(right);
        let (sin_roll, cos_roll) = self.roll.sin_cos();
        let (right, up) = (right * cos_roll + up * sin_roll, up * cos_roll - right * sin_roll);
        [right, up, -back].map(|axis| self.up.to_scene(axis))
    }

    /// The camera's position.
    pub fn eye(&self) -> DVec3 {
        let [_, _, forward] = self.axes();
        self.target - forward * self.distance
    }

    /// Turns around the target for a drag of `delta` pixels; a drag over the viewport's height is half a
    /// turn.
    pub fn orbit(&mut self, delta: Vec2, viewport: Vec2) {
        let per_pixel = std::f64::consts::PI / f64::from(viewport.y.max(1.0));
        self.yaw = (self.yaw - f64::from(delta.x) * per_pixel).rem_euclid(std::f64::consts::TAU);
        self.pitch =
            (self.pitch + f64::from(delta.y) * per_pixel).clamp(-MAX_PITCH_RADIANS, MAX_PITCH_RADIANS);
    }

    /// Looks at the target from a side of the scene, along an axis.
    pub fn look_from(&mut self, side: Side) {
        (self.yaw, self.pitch) = side.angles();
        self.roll = 0.0;
    }

    /// The direction from the target to a camera that looks from a side.
    pub fn direction_of(&self, side: Side) -> DVec3 {
        let (yaw, pitch) = side.angles();
        let [_, _, forward] = Self { yaw, pitch, ..*self }.axes();
        -forward
    }

    /// Whether the camera looks from a side, along an axis.
    pub fn is_from(&self, side: Side) -> bool {
        let [_, _, forward] = self.axes();
        -forward.dot(self.direction_of(side)) > 1.0 - 1e-9
    }

    /// Moves sideways for a drag of `delta` pixels, so that the point at the target's depth under the
    /// pointer stays under it.
    pub fn pan(&mut self, delta: Vec2, viewport: Vec2) {
        let [right, up, _] = self.axes();
        let unit = self.units_per_pixel(viewport);
        self.target += (up * f64::from(delta.y) - right * f64::from(delta.x)) * unit;
    }

    /// Moves the eye by distances to the right, upwards along the up axis, and forward; the direction stays.
    pub fn fly(&mut self, by: DVec3) {
        let [right, _, forward] = self.axes();
        self.target += right * by.x + self.up.to_scene(DVec3::Y) * by.y + forward * by.z;
    }

    /// Turns around at the place of the eye, for a movement of the pointer by `delta` pixels.
    pub fn look_around(&mut self, delta: Vec2, viewport: Vec2) {
        let eye = self.eye();
        self.orbit(delta, viewport);
        let [_, _, forward] = self.axes();
        self.target = eye + forward * self.distance;
    }

    /// Moves the target along the direction of view to this distance from the eye, which stays.
    pub fn set_target_distance(&mut self, distance: f64) {
        let [nearest, farthest] = self.distance_limits();
        let (eye, [_, _, forward]) = (self.eye(), self.axes());
        self.distance = distance.clamp(nearest, farthest);
        self.target = eye + forward * self.distance;
    }

    /// Zooms by `factor` (2 makes things look twice as large; below 1 they get smaller). The point at the
    /// target's depth under `pixel` stays where it is.
    pub fn zoom(&mut self, factor: f64, pixel: Vec2, viewport: Vec2) {
        if !(factor.is_finite() && factor > 0.0) {
            return;
        }
        let [nearest, farthest] = self.distance_limits();
        let distance = (self.distance / factor).clamp(nearest, farthest);
        let [right, up, _] = self.axes();
        let from_middle = (pixel - viewport * 0.5).as_dvec2() * self.units_per_pixel(viewport);
        let under = right * from_middle.x - up * from_middle.y;
        self.target += under * (1.0 - distance / self.distance);
        self.distance = distance;
    }

    /// Looks at `bounds` from the current direction, as near as shows all of it in a viewport with this
    /// ratio of width to height.
    pub fn frame(&mut self, bounds: Bounds, aspect: f32) {
        if !is_box(&bounds) {
            return;
        }
        // A line seen from its end needs some distance too. A single point has no size: the scene's is used.
        let scene = self.scene().map_or(0.0, radius);
        let least = [1.2 * radius(bounds), 0.15 * scene].into_iter().find(|&d| d > 0.0).unwrap_or(5.0);
        let share = self.frame_share.clamp(DVec2::splat(0.05), DVec2::ONE);
        let tan_full = (self.fov_y * 0.5).tan();
        let tan_x = tan_full * f64::from(aspect.clamp(1e-3, 1e3)) * share.x;
        let tan_y = tan_full * share.y;
        let [right, up, forward] = self.axes();
        let size = (bounds.max.as_dvec3() - bounds.min.as_dvec3()) * 0.5;
        // The distance at which each corner of the box is inside the picture.
        let needed = (0..8).map(|corner: u32| {
            let sign = |bit: u32| if corner & bit == 0 { -1.0 } else { 1.0 };
            let corner = size * dvec3(sign(1), sign(2), sign(4));
            let across = (corner.dot(right).abs() / tan_x).max(corner.dot(up).abs() / tan_y);
            if self.orthographic { across } else { across - corner.dot(forward) }
        });
        self.target = bounds.center().as_dvec3();
        self.distance = 1.1 * needed.fold(least, f64::max);
    }

    /// Restores the initial view of the scene.
    pub fn reset(&mut self, aspect: f32) {
        let start = Self::default();
        self.yaw = start.yaw;
        self.pitch = start.pitch;
        self.roll = start.roll;
        self.fov_y = start.fov_y;
        match self.scene() {
            Some(scene) => self.frame(scene, aspect),
            None => (self.target, self.distance) = (start.target, start.distance),
        }
    }

    /// The matrix from world to clip space with reversed depth: 1 at the near plane, 0 far away. For large
    /// coordinates use [`Camera::project`], which keeps their precision.
    pub fn view_proj(&self, aspect: f32) -> Mat4 {
        let scale = 1.0 / self.distance;
        let shift = -self.eye() * scale;
        self.relative_view_proj(f64::from(aspect))
            * Mat4::from_translation(shift.as_vec3())
            * Mat4::from_scale(Vec3::splat(scale as f32))
    }

    /// The place of a world point on a viewport of this size, in the viewport's unit (pixels or points), y
    /// down; none if it is behind the eye. It may lie outside the viewport.
    pub fn project(&self, point: Vec3, viewport: Vec2) -> Option<Vec2> {
        self.projector(viewport).project(point).map(|(pixel, _)| pixel)
    }

    /// A projector, for many points.
    pub(crate) fn projector(&self, viewport: Vec2) -> Projector {
        Projector {
            axes: self.axes(),
            eye: self.eye(),
            middle: viewport.as_dvec2() * 0.5,
            focal: 0.5 * f64::from(viewport.y) / (self.fov_y * 0.5).tan(),
            near: if self.orthographic { f64::NEG_INFINITY } else { self.near() },
            parallel: self.orthographic.then_some(self.distance),
        }
    }

    /// The distance of a point in front of the eye, along the viewing direction.
    pub fn depth(&self, point: Vec3) -> f64 {
        let [_, _, forward] = self.axes();
        (point.as_dvec3() - self.eye()).dot(forward)
    }

    /// The ray of world points that are seen at a pixel: from the eye or, with a parallel projection, from
    /// in front of the whole scene. The direction has length 1.
    pub fn ray(&self, pixel: Vec2, viewport: Vec2) -> Ray {
        let [right, up, forward] = self.axes();
        let across = (pixel - viewport * 0.5).as_dvec2() * self.units_per_pixel(viewport);
        let under = self.target + right * across.x - up * across.y;
        let start = if self.orthographic {
            under + forward * (self.depth_range()[0] - self.distance)
        } else {
            self.eye()
        };
        // The direction corrects for the rounding of the origin.
        let origin = start.as_vec3();
        let direction = (under - origin.as_dvec3()).normalize_or(forward);
        Ray { origin, direction: direction.as_vec3() }
    }

    /// Mesh units per pixel at the target's depth.
    pub fn units_per_pixel(&self, viewport: Vec2) -> f64 {
        2.0 * self.distance * (self.fov_y * 0.5).tan() / f64::from(viewport.y.max(1.0))
    }

    /// Goes as near or far as gives this number of mesh units per pixel at the target's depth.
    pub fn set_units_per_pixel(&mut self, units: f64, viewport: Vec2) {
        let now = self.units_per_pixel(viewport);
        if units.is_finite() && units > 0.0 && now > 0.0 {
            self.distance *= units / now;
        }
    }

    /// How far away a camera with the initial field of view would see as much at the target.
    pub(crate) fn apparent_distance(&self) -> f64 {
        self.distance * (self.fov_y * 0.5).tan() / (START_FOV_RADIANS * 0.5).tan()
    }

    /// The position of a point at `anchor` after a drag of `delta` pixels parallel to the screen.
    pub fn drag(&self, anchor: Vec3, delta: Vec2, viewport: Vec2) -> Vec3 {
        let [right, up, _] = self.axes();
        let depth = if self.orthographic { self.distance } else { self.depth(anchor).max(self.near()) };
        let unit = self.units_per_pixel(viewport) * depth / self.distance;
        let by = (right * f64::from(delta.x) - up * f64::from(delta.y)) * unit;
        (anchor.as_dvec3() + by).as_vec3()
    }

    /// The depth of the near plane in perspective. It is as far as possible, because depths are coarser the nearer it is where
    /// the graphics interface is WebGL.
    pub(crate) fn near(&self) -> f64 {
        let near = self.near_of_scene();
        let surface = self.surface_distance.map(|distance| distance * NEAR_PER_SURFACE);
        surface.map_or(near, |surface| near.min(surface.max(MIN_NEAR_FRACTION * self.distance)))
    }

    /// How near surfaces may be to the eye without a need to know their distance.
    pub fn clear_distance(&self) -> f64 {
        self.near_of_scene() / NEAR_PER_SURFACE
    }

    fn near_of_scene(&self) -> f64 {
        let closest = NEAR_FRACTION * self.distance;
        match self.scene() {
            // A tenth of the way leaves room for the ground grid in front of it.
            Some(scene) => {
                let front = self.depth(scene.center()) - radius(scene);
                closest.max(front.min(self.distance) * 0.1)
            }
            None => closest,
        }
    }

    /// The depths between which everything lies, for a parallel projection.
    fn depth_range(&self) -> [f64; 2] {
        let around = 40.0 * self.distance;
        let (mut near, mut far) = (self.distance - around, self.distance + around);
        if let Some(scene) = self.scene() {
            let (middle, radius) = (self.depth(scene.center()), radius(scene) * 1.01);
            near = near.min(middle - radius);
            far = far.max(middle + radius);
        }
        [near, far]
    }

    fn distance_limits(&self) -> [f64; 2] {
        let radius = self.scene().map(radius).filter(|&r| r > 0.0).unwrap_or(1.0);
        [radius * 1e-5, radius * 1e4]
    }

    /// The shaders' matrix: from positions relative to the eye, divided by the distance, to clip space. Depth
    /// is reversed; in perspective the far plane is at infinity.
    pub(crate) fn relative_view_proj(&self, aspect: f64) -> Mat4 {
        let [right, up, forward] = self.axes();
        let focal = 1.0 / (self.fov_y * 0.5).tan();
        let x = right * (focal / aspect.max(1e-6));
        let y = up * focal;
        let (z, w) = if self.orthographic {
            let [near, far] = self.depth_range().map(|d| d / self.distance);
            let depth = forward / (near - far);
            (depth.extend(far / (far - near)), DVec3::ZERO.extend(1.0))
        } else {
            (DVec3::ZERO.extend(self.near() / self.distance), forward.extend(0.0))
        };
        Mat4::from_cols(x.extend(0.0).as_vec4(), y.extend(0.0).as_vec4(), z.as_vec4(), w.as_vec4())
            .transpose()
    }
}

/// The radius of the sphere around a box.
fn radius(bounds: Bounds) -> f64 {
    bounds.diagonal() * 0.5
}

/// Whether a box is finite and not empty.
fn is_box(bounds: &Bounds) -> bool {
    bounds.min.is_finite() && bounds.max.is_finite() && bounds.min.cmple(bounds.max).all()
}
