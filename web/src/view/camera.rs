//! Moving the current view's camera: framing, zooming, aligning and turning it.

use editor::Editor;
use surface::selecting::vertices;
use viewport::Bounds;

use super::pane::{Pane, Split};
use super::{FRAMES_UNTIL_PANELS_SETTLE, View};
use crate::live::place::SelectionPlace;

/// Where the welcome view leaves a smaller share of the viewport's height, it counts as covering nothing.
const MIN_FREE_SHARE: f32 = 0.2;

/// Whether a point is in a box, or this near to it.
fn is_near(bounds: &Bounds, point: glam::Vec3, reach: f64) -> bool {
    f64::from(point.distance(point.clamp(bounds.min, bounds.max))) < reach
}

impl View {
    /// Restores the direction from which the current view looks at first.
    pub(super) fn restart(&mut self) {
        let pane = if self.panes.split == Split::One { Pane::Free } else { self.panes.current };
        self.camera = pane.start(&self.camera);
    }

    /// Frames everything once the viewport has a size.
    pub fn frame_when_seen(&mut self) {
        self.frame_due = FRAMES_UNTIL_PANELS_SETTLE;
    }

    /// Frames everything from the same direction.
    pub fn frame_all(&mut self) {
        match self.camera.scene() {
            Some(scene) if self.rect.is_positive() => self.frame(scene),
            _ => self.frame_due = FRAMES_UNTIL_PANELS_SETTLE,
        }
    }

    /// Frames bounds from the same direction. Of several views, all parallel ones frame them at one scale, so that what is
    /// beside or below in another one is as long there.
    fn frame(&mut self, bounds: Bounds) {
        if self.panes.split == Split::One || !self.camera.orthographic {
            return self.camera.frame(bounds, self.aspect());
        }
        let mut scale: f64 = 0.0;
        self.in_each(|view| {
            if view.camera.orthographic {
                view.camera.frame(bounds, view.aspect());
                scale = scale.max(view.camera.units_per_pixel(view.size()));
            }
        });
        self.in_each(|view| {
            if view.camera.orthographic {
                view.camera.set_units_per_pixel(scale, view.size());
            }
        });
    }

    /// Frames everything in the part of the viewport that bars and the welcome view leave free.
    pub fn frame_start(&mut self) {
        self.in_each(Self::frame_all);
        if self.panes.split != Split::One {
            return;
        }
        let (size, below) = (self.size(), self.covered_below);
        let free = 1.0 - (self.covered.top + below) / size.y;
        if below > 0.0 && free > MIN_FREE_SHARE {
            self.camera.zoom(f64::from(free), size * 0.5, size);
            self.camera.pan(glam::vec2(0.0, 0.5 * (self.covered.top - below)), size);
        }
    }

    /// Frames the selection, or everything if nothing is selected.
    pub fn frame_selection(&mut self, editor: &Editor) {
        let selection = editor.selection();
        let Some(mesh) = editor.mesh().filter(|_| !selection.is_empty()) else { return self.frame_all() };
        let mut points = Vec::new();
        for id in selection.ids() {
            vertices(mesh, selection.kind(), id as usize, |v| points.push(mesh.position(v)));
        }
        if let Some(bounds) = Bounds::of(points) {
            self.frame(bounds);
        }
    }

    /// Makes each view show surfaces that are closer to the eye than usual, as in a flight.
    pub fn keep_surfaces_in_sight(&mut self, editor: &Editor) {
        self.in_each(|view| {
            view.camera.surface_distance = view.distance_to_surface(editor);
        });
    }

    /// The distance from the eye to the nearest surface, where that may be in front of the near plane.
    fn distance_to_surface(&mut self, editor: &Editor) -> Option<f64> {
        let (eye, reach) = (self.camera.eye().as_vec3(), self.camera.clear_distance());
        let is_inside = self.camera.scene().is_some_and(|scene| is_near(&scene, eye, reach));
        if self.camera.orthographic || !is_inside {
            return None;
        }
        let mut nearest: Option<f64> = None;
        for object in editor.document().objects().iter().filter(|object| object.visible()) {
            let bounds = self.bounds.get(&object.id()).copied().flatten();
            // The tree of a large mesh takes several frames.
            if bounds.is_some_and(|bounds| is_near(&bounds, eye, reach)) && self.build_tree_step(object) {
                let found = self.tree(object).closest_point(object.mesh(), eye);
                nearest = [nearest, found.map(|hit| hit.distance)].into_iter().flatten().reduce(f64::min);
            }
        }
        nearest.filter(|distance| *distance < reach)
    }

    /// Zooms by a factor, to the middle.
    pub fn zoom_step(&mut self, factor: f64) {
        let size = self.size();
        self.camera.zoom(factor, size * 0.5, size);
    }

    /// Looks at the selection against its normal; returns whether it has one.
    pub fn align(&mut self, editor: &Editor) -> bool {
        let place = SelectionPlace::of_selection(editor).filter(|place| place.normal.length_squared() > 0.0);
        let Some(place) = place else { return false };
        self.camera.look_along(-place.normal.as_dvec3());
        self.camera.target = place.middle.as_dvec3();
        true
    }

    /// Restores the initial view.
    pub fn reset(&mut self) {
        let aspect = self.aspect();
        self.camera.reset(aspect);
        self.restart();
        if let Some(scene) = self.camera.scene() {
            self.frame(scene);
        }
    }

    /// Turns the view for a drag of so many points.
    pub fn turn(&mut self, by: glam::Vec2) {
        let size = self.size();
        self.camera.turn(self.turning.rotation, self.turning.center, by, size);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::{DVec3, Vec3};

    #[test]
    fn surfaces_close_to_the_eye_are_in_sight() {
        let editor =
            Editor::with_mesh("Cube", surface::Shape::named("cube").expect("it").build().expect("it"));
        let mut view = View::new(None);
        view.rect = egui::Rect::from_min_size(egui::Pos2::ZERO, egui::vec2(800.0, 600.0));
        view.bounds.insert(editor.document().objects()[0].id(), Bounds::of([Vec3::NEG_ONE, Vec3::ONE]));
        view.camera.set_scene(Bounds::of([Vec3::NEG_ONE, Vec3::ONE]));
        view.camera.look_from(viewport::Side::Front);
        let size = glam::vec2(800.0, 600.0);
        for distance in [1e-3, 0.05, 0.5, 3.0] {
            view.camera.target = DVec3::Z * (1.0 + distance - view.camera.distance);
            view.keep_surfaces_in_sight(&editor);
            assert!(view.camera.project(Vec3::Z, size).is_some(), "{distance}");
            let is_close = view.camera.surface_distance.is_some();
            assert_eq!(is_close, distance < view.camera.clear_distance(), "{distance}");
        }
        // In a hidden object there is nothing to see.
        view.camera.target = DVec3::Z * (1.05 - view.camera.distance);
        view.bounds.clear();
        view.keep_surfaces_in_sight(&editor);
        assert_eq!(view.camera.project(Vec3::Z, size), None);
    }
}
