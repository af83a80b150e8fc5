//! The views that the viewport is split into. Each has a camera and a rectangle. Those of the current view, in which the
//! pointer and the keys act, are the [`View`]'s own. What frames and turns the view acts in the current one.

use editor::Editor;
use egui::{Context, Event, Order, Pos2, Rect};
use serde::{Deserialize, Serialize};
use surface::selecting::vertices;
use viewport::{Bounds, Camera, Side};

use super::{FRAMES_UNTIL_PANELS_SETTLE, Gesture, MIN_FREE_SHARE, Tool, View};
use crate::live::place::Place;

/// The room between views, in points.
const GAP_POINTS: f32 = 2.0;

/// How the viewport is split.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub enum Split {
    /// It is not.
    #[default]
    One,
    /// Into two views side by side: in perspective, and from the front.
    Two,
    /// Into four: from above and in perspective, below from the front and from the right.
    Four,
}

/// A view, named after where it looks from at first.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub(crate) enum Pane {
    Top,
    /// In perspective.
    #[default]
    Free,
    Front,
    Right,
}

impl Pane {
    /// Row by row.
    const ALL: [Self; 4] = [Self::Top, Self::Free, Self::Front, Self::Right];

    /// The side from which it looks at first, without perspective.
    fn side(self) -> Option<Side> {
        match self {
            Self::Top => Some(Side::Top),
            Self::Front => Some(Side::Front),
            Self::Right => Some(Side::Right),
            Self::Free => None,
        }
    }

    /// Its part of the viewport.
    fn rect(self, split: Split, area: Rect) -> Rect {
        let middle = area.center().round();
        let (left, right) = area.split_left_right_at_x(middle.x);
        let half = match (self, split) {
            (_, Split::One) => return area,
            (Self::Free | Self::Right, Split::Four) | (Self::Front, Split::Two) => {
                right.with_min_x(right.left() + GAP_POINTS / 2.0)
            }
            _ => left.with_max_x(left.right() - GAP_POINTS / 2.0),
        };
        let (above, below) = half.split_top_bottom_at_y(middle.y);
        match (self, split) {
            (_, Split::One | Split::Two) => half,
            (Self::Top | Self::Free, _) => above.with_max_y(above.bottom() - GAP_POINTS / 2.0),
            (Self::Front | Self::Right, _) => below.with_min_y(below.top() + GAP_POINTS / 2.0),
        }
    }

    /// The camera that it begins with, before it frames anything.
    fn start(self, like: &Camera) -> Camera {
        let start = Camera::default();
        let mut camera =
            Camera { yaw: start.yaw, pitch: start.pitch, roll: 0.0, orthographic: false, ..*like };
        if let Some(side) = self.side() {
            camera.look_from(side);
            camera.orthographic = true;
        }
        camera
    }
}

/// A view that isn't the current one.
#[derive(Clone, Copy, Debug)]
struct Aside {
    pane: Pane,
    camera: Camera,
    rect: Rect,
}

/// Which views there are.
#[derive(Clone, Debug, Default)]
pub(crate) struct Panes {
    pub split: Split,
    /// The view in which the pointer and the keys act.
    pub current: Pane,
    /// The view that was last clicked: the current one while the pointer is outside of the viewport.
    pub active: Pane,
    others: Vec<Aside>,
}

impl View {
    /// The views that are shown.
    pub fn panes(&self) -> Vec<Pane> {
        match self.panes.split {
            Split::One => vec![self.panes.current],
            Split::Two => vec![Pane::Free, Pane::Front],
            Split::Four => Pane::ALL.to_vec(),
        }
    }

    /// The camera and the rectangle of a view.
    pub fn seen_in(&self, pane: Pane) -> (&Camera, Rect) {
        let other = self.panes.others.iter().find(|other| other.pane == pane);
        other.map_or((&self.camera, self.rect), |other| (&other.camera, other.rect))
    }

    /// Lays the views out in an area; returns whether anything about it changed.
    pub fn lay_out(&mut self, area: Rect, split: Split) -> bool {
        if (self.area, self.panes.split) == (area, split) {
            return false;
        }
        self.area = area;
        let is_new = split != Split::One && self.panes.others.is_empty();
        if is_new {
            let others = Pane::ALL.into_iter().filter(|pane| *pane != self.panes.current);
            let aside = |pane: Pane| Aside { pane, camera: pane.start(&self.camera), rect: area };
            self.panes.others = others.map(aside).collect();
        }
        if self.panes.split != split {
            // One view shows what was active.
            self.go_to(self.panes.active);
            self.panes.split = split;
            if !self.panes().contains(&self.panes.active) {
                self.activate(Pane::Free);
            }
        }
        self.in_each(|view| view.rect = view.panes.current.rect(split, area));
        self.set_covered(self.covered);
        if is_new {
            let current = self.panes.current;
            self.in_each(|view| {
                if view.panes.current != current {
                    view.frame_all();
                }
            });
        }
        true
    }

    /// Makes a view the current one.
    pub fn go_to(&mut self, pane: Pane) {
        if let Some(other) = self.panes.others.iter_mut().find(|other| other.pane == pane) {
            std::mem::swap(&mut other.camera, &mut self.camera);
            std::mem::swap(&mut other.rect, &mut self.rect);
            std::mem::swap(&mut other.pane, &mut self.panes.current);
        }
    }

    /// Makes a view the active one too.
    pub fn activate(&mut self, pane: Pane) {
        self.go_to(pane);
        self.panes.active = pane;
    }

    /// Does something in each view that is shown, as the current one.
    pub fn in_each(&mut self, mut act: impl FnMut(&mut Self)) {
        let current = self.panes.current;
        for pane in self.panes() {
            self.go_to(pane);
            act(self);
        }
        self.go_to(current);
    }

    /// Changes the cameras of all views, shown or not.
    pub fn change_cameras(&mut self, mut change: impl FnMut(&mut Camera)) {
        change(&mut self.camera);
        self.panes.others.iter_mut().for_each(|other| change(&mut other.camera));
    }

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
            Some(scene) if self.rect.is_positive() => self.camera.frame(scene, self.aspect()),
            _ => self.frame_due = FRAMES_UNTIL_PANELS_SETTLE,
        }
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
            self.camera.frame(bounds, self.aspect());
        }
    }

    /// Zooms by a factor, to the middle.
    pub fn zoom_step(&mut self, factor: f64) {
        let size = self.size();
        self.camera.zoom(factor, size * 0.5, size);
    }

    /// Looks at the selection against its normal; returns whether it has one.
    pub fn align(&mut self, editor: &Editor) -> bool {
        let place = Place::of_selection(editor).filter(|place| place.normal.length_squared() > 0.0);
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
            self.camera.frame(scene, aspect);
        }
    }

    /// Cancels the drag in progress; returns whether there was one.
    pub fn cancel_gesture(&mut self) -> bool {
        let going = !matches!(
            self.gesture,
            Gesture::None
                | Gesture::Live { .. }
                | Gesture::Orbit
                | Gesture::Pan
                | Gesture::Zoom
                | Gesture::Ended
        );
        if going {
            self.gesture = Gesture::Ended;
        }
        let was_looking = !self.regions.is_empty();
        self.regions.clear();
        was_looking || going
    }

    /// Takes a tool, or puts it away.
    pub fn switch_tool(&mut self, tool: Tool) {
        self.tool = if self.tool == tool { Tool::Orbit } else { tool };
        self.ring.typed = 0;
    }

    /// Turns the view for a drag of so many points.
    pub fn turn(&mut self, by: glam::Vec2) {
        let size = self.size();
        self.camera.turn(self.turning.rotation, self.turning.center, by, size);
    }

    pub fn local(&self, at: Pos2) -> glam::Vec2 {
        glam::vec2(at.x - self.rect.min.x, at.y - self.rect.min.y)
    }

    /// Makes the view under the pointer the current one, while no drag goes on.
    pub fn follow_pointer(&mut self, ctx: &Context) {
        if self.panes.split == Split::One || self.gesture != Gesture::None {
            return;
        }
        let (pressed, is_down, latest) = ctx.input(|input| {
            let press = input.events.iter().find_map(|event| match event {
                Event::PointerButton { pos, pressed: true, .. } => Some(*pos),
                _ => None,
            });
            (press, input.pointer.any_down(), input.pointer.latest_pos())
        });
        if is_down && pressed.is_none() {
            return;
        }
        let under = pressed.or(latest).and_then(|at| self.pane_at(ctx, at));
        self.go_to(under.unwrap_or(self.panes.active));
    }

    /// The view at a place on the page; none under windows and menus.
    fn pane_at(&self, ctx: &Context, at: Pos2) -> Option<Pane> {
        let is_free = ctx.layer_id_at(at).is_none_or(|layer| layer.order == Order::Background);
        let panes = self.panes();
        panes.into_iter().find(|pane| is_free && self.seen_in(*pane).1.contains(at))
    }
}

/// What a camera shows, in a few words.
pub(crate) fn name_of(camera: &Camera) -> &'static str {
    let side = Side::ALL.into_iter().find(|side| camera.is_from(*side));
    match (side, camera.orthographic) {
        (Some(Side::Top), true) => "Top",
        (Some(Side::Bottom), true) => "Bottom",
        (Some(Side::Front), true) => "Front",
        (Some(Side::Back), true) => "Back",
        (Some(Side::Right), true) => "Right",
        (Some(Side::Left), true) => "Left",
        (None, true) => "Parallel",
        (_, false) => "Perspective",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{pos2, vec2};

    #[test]
    fn views_fill_the_viewport_without_overlap() {
        let area = Rect::from_min_size(pos2(301.0, 40.0), vec2(641.0, 533.0));
        for (split, panes) in [
            (Split::One, &[Pane::Right][..]),
            (Split::Two, &[Pane::Free, Pane::Front]),
            (Split::Four, &Pane::ALL),
        ] {
            let rects: Vec<Rect> = panes.iter().map(|pane| pane.rect(split, area)).collect();
            let all = rects.iter().fold(Rect::NOTHING, |all, rect| all.union(*rect));
            assert_eq!(all, area, "{split:?}");
            let covered: f32 = rects.iter().map(|rect| rect.area()).sum();
            assert!(covered <= area.area() && covered > 0.99 * area.area(), "{split:?}");
            for (at, rect) in rects.iter().enumerate() {
                assert!(rects.iter().skip(at + 1).all(|other| !other.intersects(*rect)), "{split:?}");
            }
        }
    }

    #[test]
    fn going_from_view_to_view_keeps_each_camera() {
        let mut view = View::new(None);
        view.lay_out(Rect::from_min_size(Pos2::ZERO, vec2(800.0, 600.0)), Split::Four);
        let names = |view: &View| Pane::ALL.map(|pane| name_of(view.seen_in(pane).0));
        assert_eq!(names(&view), ["Top", "Perspective", "Front", "Right"]);
        view.go_to(Pane::Front);
        view.camera.look_from(Side::Left);
        view.go_to(Pane::Top);
        view.in_each(|view| view.camera.distance = 7.0);
        assert_eq!(view.panes.current, Pane::Top);
        assert_eq!(names(&view), ["Top", "Perspective", "Left", "Right"]);
        view.activate(Pane::Right);
        view.go_to(Pane::Front);
        view.lay_out(view.area, Split::One);
        assert_eq!((name_of(&view.camera), view.rect), ("Right", view.area), "one view shows the active one");
        view.lay_out(view.area, Split::Four);
        assert_eq!(names(&view), ["Top", "Perspective", "Left", "Right"]);
        view.activate(Pane::Top);
        view.lay_out(view.area, Split::Two);
        assert_eq!(view.panes.active, Pane::Free, "the view from above isn't shown");
    }
}
