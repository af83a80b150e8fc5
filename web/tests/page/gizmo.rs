//! Every handle of the gizmo: what a drag of it does, and to which coordinates.

use crate::axes::{choose, mean, picture_axes};
use crate::page::Page;
use egui::{Key, Modifiers, Pos2};
use glam::{Quat, Vec3};
use halfedge::VertexId;

/// The length of an arrow on the screen, as the gizmo draws it.
const ARROW_POINTS: f32 = 84.0;
/// The middle of the square that moves in a plane and the radius of a ring, in arrows.
const SQUARE_MIDDLE_ARROWS: f32 = 0.42;
const RING_RADIUS_ARROWS: f32 = 0.9;
/// The radius of the ring about the direction of view.
const VIEW_RING_RADIUS_ARROWS: f32 = 1.15;
/// A drag that begins nearer to the middle than this would scale too fast if twice as far were twice as large.
const MIN_RADIUS_POINTS: f32 = 24.0;
/// How exactly a drag of some points is followed, in mesh units.
const TOLERANCE: f32 = 2e-3;

/// How far what moves may be from where the pointer took it, in points.
const MAX_MISSED_POINTS: f32 = 0.5;

/// Vertices that lie in no plane.
const FIVE: [u32; 5] = [0, 1, 2, 3, 4];

const AXES: [Vec3; 3] = [Vec3::X, Vec3::Y, Vec3::Z];

/// A page with the gizmo at some vertices of the cube.
struct Handles {
    page: Page,
    ids: Vec<u32>,
    /// Where the gizmo is.
    anchor: Vec3,
    /// The length of an arrow in mesh units.
    arrow: f32,
    towards_viewer: Vec3,
}

impl Handles {
    fn new(gizmo: &str, ids: &[u32]) -> Self {
        let mut page = Page::new();
        page.select("vertex", ids);
        let ids = ids.to_vec();
        choose(&mut page, "Gizmo", gizmo);
        let anchor = mean(page.mesh(), &ids);
        let [right, up] = picture_axes(&mut page);
        let unit = page.at((anchor + right).to_array()).distance(page.at(anchor.to_array()));
        Self { page, ids, anchor, arrow: ARROW_POINTS / unit, towards_viewer: right.cross(up) }
    }

    /// Where a point of the gizmo is on the screen; its offset from the gizmo's middle is in arrows.
    fn at(&mut self, offset: Vec3) -> Pos2 {
        self.page.at((self.anchor + offset * self.arrow).to_array())
    }

    /// Drags from one place to another: what has become of the selected vertices, relative to the gizmo, before and after.
    /// Nothing else may have moved, and undo brings everything back.
    fn drag(&mut self, from: Pos2, to: Pos2) -> Vec<[Vec3; 2]> {
        let before = self.page.mesh().clone();
        let steps = self.page.undo_labels().len();
        self.page.drag(from, to);
        self.page.drop(to);
        let after = self.page.mesh().clone();
        let relative = |v: VertexId| [&before, &after].map(|mesh| mesh.position(v) - self.anchor);
        for v in before.vertices().filter(|v| !self.ids.contains(&v.raw())) {
            assert_eq!(before.position(v), after.position(v), "{v:?} is not selected");
        }
        let moved = self.ids.iter().map(|&id| relative(VertexId::new(id as usize))).collect();
        assert_eq!(self.page.undo_labels().len(), steps + 1, "a drag is one step");
        self.page.press_with(Modifiers::COMMAND, Key::Z);
        assert_eq!(self.page.mesh(), &before);
        moved
    }
}

/// The vertex of the cube that is nearest to the viewer, where every handle is in sight.
fn front_vertex() -> u32 {
    crate::viewport::nearest_vertex(&mut Page::new()).0
}

/// Drags a handle of the move gizmo from one of its points by a way, both in arrows; returns how the vertex has moved. On
/// the screen it has moved exactly as the pointer.
fn moves(handles: &mut Handles, on_handle: Vec3, way: Vec3) -> Vec3 {
    let (from, to) = (handles.at(on_handle), handles.at(on_handle + way));
    let middle = handles.at(Vec3::ZERO);
    let [before, after] = handles.drag(from, to)[0];
    assert_eq!(before, Vec3::ZERO, "the gizmo is at the vertex");
    let there = handles.at(after / handles.arrow);
    let missed = (there - middle - (to - from)).length();
    assert!(missed < MAX_MISSED_POINTS, "{way} from {on_handle}: {missed} points from the pointer");
    after
}

#[test]
fn each_arrow_moves_along_its_axis_with_the_pointer() {
    let mut handles = Handles::new("Move gizmo", &[front_vertex()]);
    for axis in AXES {
        for way in [1.0, -0.3] {
            let moved = moves(&mut handles, axis * 0.6, axis * way);
            assert_eq!(moved * (Vec3::ONE - axis), Vec3::ZERO, "along {axis} alone: {moved}");
            assert!(moved.dot(axis) * way > 0.0, "{moved}");
        }
    }
}

#[test]
fn each_square_moves_in_its_plane_with_the_pointer() {
    let mut handles = Handles::new("Move gizmo", &[front_vertex()]);
    for across in 0..3 {
        let (u, v) = (AXES[(across + 1) % 3], AXES[(across + 2) % 3]);
        let moved = moves(&mut handles, (u + v) * SQUARE_MIDDLE_ARROWS, u * 0.7 - v * 0.4);
        assert_eq!(moved[across], 0.0, "in the plane across {}: {moved}", AXES[across]);
        assert!(moved.dot(u) > 0.1 && moved.dot(v) < -0.05, "{moved}");
    }
}

#[test]
fn the_disc_in_the_middle_moves_in_the_plane_of_the_screen() {
    let mut handles = Handles::new("Move gizmo", &[front_vertex()]);
    let [right, up] = picture_axes(&mut handles.page);
    let way = right * 0.8 - up * 0.5;
    let moved = moves(&mut handles, Vec3::ZERO, way);
    assert!(moved.dot(handles.towards_viewer).abs() < 1e-4, "neither nearer nor farther: {moved}");
    assert!(moved.distance(way * handles.arrow) < TOLERANCE, "{moved}");
}

#[test]
fn each_ring_rotates_about_its_axis_by_the_angle_of_the_pointer() {
    let mut handles = Handles::new("Rotate gizmo", &FIVE);
    let towards_viewer = handles.towards_viewer;
    for axis in AXES {
        // The half of the ring in front, beside the place where it crosses others.
        let front = (towards_viewer - axis * towards_viewer.dot(axis)).normalize();
        let on_ring = Quat::from_axis_angle(axis, 0.35) * front * RING_RADIUS_ARROWS;
        rotates(&mut handles, axis, on_ring);
    }
    let [right, up] = picture_axes(&mut handles.page);
    rotates(&mut handles, towards_viewer, (right * 0.8 + up * 0.6) * VIEW_RING_RADIUS_ARROWS);
}

/// Drags a ring from a place on it by 30 degrees on the screen.
fn rotates(handles: &mut Handles, axis: Vec3, on_ring: Vec3) {
    let (middle, from) = (handles.at(Vec3::ZERO), handles.at(on_ring));
    // Against the clock is up to the right on a screen whose y points down.
    let to = middle + egui::emath::Rot2::from_angle(-30f32.to_radians()) * (from - middle);
    let way = if axis.dot(handles.towards_viewer) > 0.0 { 1.0 } else { -1.0 };
    let turn = Quat::from_axis_angle(axis, way * 30f32.to_radians());
    for [before, after] in handles.drag(from, to) {
        assert!(after.distance(turn * before) < TOLERANCE, "about {axis}: {before} goes to {after}");
    }
}

#[test]
fn each_box_scales_along_its_axis_and_each_square_in_its_plane() {
    let mut handles = Handles::new("Scale gizmo", &FIVE);
    let doubled = |handles: &mut Handles, on_handle: Vec3, along: Vec3| {
        // Twice as far from the middle is twice as large; nearby, less.
        let (middle, from) = (handles.at(Vec3::ZERO), handles.at(on_handle));
        let growth = (from.distance(middle) / MIN_RADIUS_POINTS).min(1.0);
        for [before, after] in handles.drag(from, middle + (from - middle) * 2.0) {
            let expected = before * (Vec3::ONE + along * growth);
            assert!(after.distance(expected) < TOLERANCE, "by {along}: {before} goes to {after}");
        }
    };
    for (at, axis) in AXES.into_iter().enumerate() {
        doubled(&mut handles, axis * 0.8, axis);
        let (u, v) = (AXES[(at + 1) % 3], AXES[(at + 2) % 3]);
        doubled(&mut handles, (u + v) * SQUARE_MIDDLE_ARROWS, u + v);
    }
    // Those in the middle begin at no distance: up and to the right enlarges, in every direction alike.
    let middle = handles.at(Vec3::ZERO);
    for (to, is_larger) in [(egui::vec2(40.0, -40.0), true), (egui::vec2(-40.0, 40.0), false)] {
        let scaled = handles.drag(middle, middle + to);
        let factors: Vec<f32> =
            scaled.iter().map(|[before, after]| after.length() / before.length()).collect();
        assert!(factors.iter().all(|factor| (factor - factors[0]).abs() < 1e-4), "alike: {factors:?}");
        assert!(if is_larger { factors[0] > 1.2 } else { factors[0] < 0.8 }, "{factors:?}");
    }
}
