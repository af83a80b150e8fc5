//! The camera: projection, rays and drags agree at any scale.

use glam::{DVec3, Vec2, Vec3, vec2, vec3};
use proptest::prelude::*;
use viewport::{Bounds, Camera, Rotation, UpAxis};

const VIEW: Vec2 = Vec2::new(800.0, 600.0);

fn camera() -> impl Strategy<Value = Camera> {
    let scale = prop_oneof![Just(1e-4_f64), Just(1.0), Just(1e6)];
    (
        prop::array::uniform3(-1.0_f64..1.0),
        0.0..std::f64::consts::TAU,
        -1.5..1.5_f64,
        0.5..20.0_f64,
        any::<bool>(),
        scale,
    )
        .prop_map(|(target, yaw, pitch, distance, orthographic, scale)| Camera {
            target: DVec3::from(target) * scale,
            yaw,
            pitch,
            distance: distance * scale,
            orthographic,
            ..Camera::default()
        })
}

proptest! {
    /// The ray at a pixel passes through the points that are projected there.
    #[test]
    fn a_ray_meets_the_points_at_its_pixel(
        camera in camera(),
        x in 0.0_f32..800.0,
        y in 0.0_f32..600.0,
        along in 0.3_f64..3.0,
    ) {
        let ray = camera.ray(vec2(x, y), VIEW);
        prop_assert!((ray.direction.length() - 1.0).abs() < 1e-5);
        let reach = camera.distance * if camera.orthographic { 40.0 } else { along };
        let point = ray.origin.as_dvec3() + ray.direction.as_dvec3() * reach;
        let back = camera.project(point.as_vec3(), VIEW).expect("in front");
        prop_assert!(back.distance(vec2(x, y)) < 0.05, "{back}");
    }

    /// Framed bounds are completely in view, from any direction and in viewports of any shape.
    #[test]
    fn framing_shows_all(
        camera in camera(),
        low in prop::array::uniform3(-1.0_f32..1.0),
        size in prop::array::uniform3(0.0_f32..1.0),
        magnitude in -4..7,
        aspect in 0.3_f32..3.0,
    ) {
        let scale = 10_f32.powi(magnitude);
        let min = Vec3::from(low) * scale;
        let bounds = Bounds { min, max: min + Vec3::from(size) * scale };
        let mut camera = camera;
        camera.set_scene(Some(bounds));
        camera.frame(bounds, aspect);
        let view = vec2(500.0 * aspect, 500.0);
        for i in 0..8 {
            let pick = |bit: usize, axis: usize| if i & bit == 0 { bounds.min[axis] } else { bounds.max[axis] };
            let corner = vec3(pick(1, 0), pick(2, 1), pick(4, 2));
            let p = camera.project(corner, view).expect("in front of the eye");
            prop_assert!(p.cmpge(Vec2::splat(-0.5)).all() && p.cmple(view + 0.5).all(), "{p} of {view}");
        }
        // And not too far away: the sphere around the box fills nine tenths of the narrower side.
        let radius = bounds.diagonal() / 2.0;
        prop_assert!(camera.distance < radius / (0.35_f64.tan() * f64::from(aspect.min(1.0))).atan().sin() * 1.1 + 1e-30
            || radius == 0.0);
    }

    /// Zooming leaves the point under the pointer there.
    #[test]
    fn zooming_keeps_the_point_under_the_pointer(
        camera in camera(),
        x in 0.0_f32..800.0,
        y in 0.0_f32..600.0,
        factor in 0.5_f64..2.0,
    ) {
        let mut camera = camera;
        let scale = camera.distance as f32;
        camera.set_scene(Some(Bounds { min: Vec3::splat(-scale), max: Vec3::splat(scale) }));
        let unit = camera.units_per_pixel(VIEW);
        let [right, up, _] = camera.axes();
        let under = camera.target + right * f64::from(x - 400.0) * unit - up * f64::from(y - 300.0) * unit;
        let before = camera.distance;
        camera.zoom(factor, vec2(x, y), VIEW);
        prop_assert!((camera.distance * factor / before - 1.0).abs() < 1e-9);
        let after = camera.project(under.as_vec3(), VIEW).expect("in front");
        prop_assert!(after.distance(vec2(x, y)) < 0.05, "{after}");
    }

    /// The matrix agrees with the projection, for models that are not far from the origin.
    #[test]
    fn the_matrix_projects_alike(camera in camera(), p in prop::array::uniform3(-0.1_f32..0.1)) {
        let point = (camera.target + Vec3::from(p).as_dvec3() * camera.distance).as_vec3();
        let clip = camera.view_proj(VIEW.x / VIEW.y) * point.extend(1.0);
        let ndc = clip.truncate() / clip.w;
        let pixel = vec2((ndc.x * 0.5 + 0.5) * VIEW.x, (0.5 - ndc.y * 0.5) * VIEW.y);
        let expected = camera.project(point, VIEW).expect("in front");
        prop_assert!(pixel.distance(expected) < 0.1, "{pixel} {expected}");
        prop_assert!(ndc.z > 0.0 && ndc.z < 1.0);
    }

    /// A dragged vertex follows the pointer.
    #[test]
    fn a_drag_follows_the_pointer(camera in camera(), dx in -100.0_f32..100.0, dy in -100.0_f32..100.0) {
        let [right, up, forward] = camera.axes();
        let anchor = (camera.target + (right * 0.1 + up * 0.05 - forward * 0.2) * camera.distance).as_vec3();
        let start = camera.project(anchor, VIEW).expect("in front");
        let moved = camera.drag(anchor, vec2(dx, dy), VIEW);
        let end = camera.project(moved, VIEW).expect("in front");
        prop_assert!((end - start).distance(vec2(dx, dy)) < 0.05);
    }
}

#[test]
fn panning_moves_the_target_with_the_pointer() {
    let mut camera = Camera::default();
    let target = camera.target.as_vec3();
    camera.pan(vec2(40.0, -25.0), VIEW);
    let now = camera.project(target, VIEW).expect("in front");
    assert!(now.distance(vec2(440.0, 275.0)) < 1e-2, "{now}");
}

#[test]
fn orbiting_stops_at_the_poles_and_goes_round_the_horizon() {
    let mut camera = Camera { yaw: 0.0, pitch: 0.0, ..Camera::default() };
    camera.orbit(vec2(0.0, 1e6), VIEW);
    assert_eq!(camera.pitch, std::f64::consts::FRAC_PI_2);
    let [right, up, forward] = camera.axes();
    assert!(right.distance(DVec3::X) < 1e-9 && up.distance(-DVec3::Z) < 1e-9);
    assert!(forward.distance(-DVec3::Y) < 1e-9);
    camera.orbit(vec2(1200.0, 0.0), VIEW);
    assert!(camera.yaw.sin().abs() < 1e-9, "{}", camera.yaw);
}

#[test]
fn toggling_the_projection_keeps_the_size_at_the_target() {
    let mut camera = Camera::default();
    let [right, ..] = camera.axes();
    let point = (camera.target + right).as_vec3();
    let perspective = camera.project(point, VIEW).expect("in front");
    camera.orthographic = true;
    let parallel = camera.project(point, VIEW).expect("in front");
    assert!(perspective.distance(parallel) < 1e-3);
}

#[test]
fn points_behind_the_eye_are_not_on_the_screen() {
    let camera = Camera { yaw: 0.0, pitch: 0.0, ..Camera::default() };
    assert_eq!(camera.project(vec3(0.0, 0.0, 6.0), VIEW), None);
    assert!(camera.project(vec3(0.0, 0.0, 4.0), VIEW).is_some());
}

#[test]
fn scenes_without_a_size_can_be_framed() {
    let mut camera = Camera::default();
    let point = Vec3::splat(3.0);
    camera.set_scene(Some(Bounds { min: point, max: point }));
    camera.reset(1.0);
    assert!(camera.distance > 0.0 && camera.distance.is_finite());
    let start = camera;
    camera.set_scene(Some(Bounds::EMPTY));
    assert_eq!(camera.scene(), None);
    camera.frame(Bounds::EMPTY, 1.0);
    assert_eq!(camera.target, start.target);
    camera.zoom(f64::NAN, Vec2::ZERO, VIEW);
    assert_eq!(camera.distance, start.distance);
}

/// How the direction to the eye and the picture's right side differ from another camera's.
fn differs(a: &Camera, b: &Camera) -> f64 {
    a.axes().iter().zip(b.axes()).map(|(a, b)| a.distance(b)).fold(0.0, f64::max)
}

proptest! {
    /// The point that a camera turns about stays where it is in the picture.
    #[test]
    fn turning_leaves_its_center_in_place(
        camera in camera(),
        x in 100.0_f32..700.0,
        y in 100.0_f32..500.0,
        by in prop::array::uniform2(-300.0_f32..300.0),
        free in any::<bool>(),
    ) {
        let rotation = if free { Rotation::Trackball } else { Rotation::Turntable };
        let ray = camera.ray(vec2(x, y), VIEW);
        let depth = if camera.orthographic { 41.0 } else { 1.2 } * camera.distance;
        let center = ray.origin.as_dvec3() + ray.direction.as_dvec3() * depth;
        let mut turned = camera;
        turned.turn(rotation, Some(center), Vec2::from(by), VIEW);
        let seen = turned.project(center.as_vec3(), VIEW).expect("in front");
        prop_assert!(seen.distance(vec2(x, y)) < 0.1, "{seen}");
        prop_assert!((turned.distance - camera.distance).abs() < 1e-9 * camera.distance);
    }

    /// Free turns go over the poles, about the picture's own axes, and back.
    #[test]
    fn free_turns_can_be_undone(camera in camera(), by in prop::array::uniform2(-500.0_f32..500.0)) {
        let by = Vec2::from(by);
        let mut turned = camera;
        turned.turn(Rotation::Trackball, None, by, VIEW);
        let angle = by.as_dvec2().length() * std::f64::consts::PI / 600.0;
        let [_, _, before] = camera.axes();
        let [right, up, after] = turned.axes();
        prop_assert!((before.dot(after) - angle.cos()).abs() < 1e-9, "by the angle of the drag");
        prop_assert!(right.dot(up).abs() < 1e-12 && right.cross(up).distance(-after) < 1e-12);
        turned.turn(Rotation::Trackball, None, -by, VIEW);
        prop_assert!(differs(&turned, &camera) < 1e-6);
    }

    /// A camera that looks along a direction has the up axis upright.
    #[test]
    fn looking_along_a_direction(camera in camera(), way in prop::array::uniform3(-1.0_f64..1.0), z in any::<bool>()) {
        let way = DVec3::from(way);
        prop_assume!(way.length() > 0.1);
        let mut camera = Camera { roll: 1.0, up: if z { UpAxis::Z } else { UpAxis::Y }, ..camera };
        camera.look_along(way);
        let [right, _, forward] = camera.axes();
        prop_assert!(forward.distance(way.normalize()) < 1e-6);
        prop_assert!(right.dot(camera.up.to_scene(DVec3::Y)).abs() < 1e-9);
    }
}

#[test]
fn small_free_turns_are_like_those_of_a_turntable_at_the_horizon() {
    let start = Camera { pitch: 0.0, ..Camera::default() };
    for by in [vec2(3.0, 0.0), vec2(0.0, -3.0)] {
        let (mut free, mut table) = (start, start);
        free.turn(Rotation::Trackball, None, by, VIEW);
        table.turn(Rotation::Turntable, None, by, VIEW);
        assert!(differs(&free, &table) < 1e-9, "{by}");
        assert!(differs(&free, &start) > 1e-3);
    }
}
