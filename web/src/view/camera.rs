//! Moving the current view's camera: framing, zooming, aligning and turning it.

use editor::Editor;
use surface::selecting::vertices;
use viewport::Bounds;

use super::pane::{Pane, Split};
use super::{FRAMES_UNTIL_PANELS_SETTLE, View};
use crate::live::place::SelectionPlace;

/// Where the welcome view leaves a smaller share of the viewport's height, it counts as covering nothing.
const MIN_FREE_SHARE: f32 = 0.2;

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
