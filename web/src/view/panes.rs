//! The views that the viewport is split into. Each has a camera and a rectangle. Those of the current view, in which the
//! pointer and the keys act, are the [`View`]'s own.

use egui::{Context, Event, Order, Pos2, Rect, Vec2, vec2};
use viewport::{Camera, Side};

use super::pane::{MIDDLE, Pane, Split};
use super::{Gesture, View};

/// The least width and height of a view beside another one, in points, where the viewport has room for it.
const MIN_PANE_POINTS: f32 = 96.0;

/// A view that isn't the current one.
#[derive(Clone, Copy, Debug)]
struct Aside {
    pane: Pane,
    camera: Camera,
    rect: Rect,
}

/// Which views there are.
#[derive(Clone, Debug)]
pub(crate) struct Panes {
    pub split: Split,
    /// Where the views meet, as parts of the viewport's width and height.
    pub divide: Vec2,
    /// The view in which the pointer and the keys act.
    pub current: Pane,
    /// The view that was last clicked: the current one while the pointer is outside of the viewport.
    pub active: Pane,
    others: Vec<Aside>,
}

impl Default for Panes {
    fn default() -> Self {
        Self {
            split: Split::One,
            divide: MIDDLE,
            current: Pane::Free,
            active: Pane::Free,
            others: Vec::new(),
        }
    }
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

    /// The camera of each view that is shown.
    pub fn cameras(&self) -> Vec<(Pane, Camera)> {
        self.panes().into_iter().map(|pane| (pane, *self.seen_in(pane).0)).collect()
    }

    /// Gives views other cameras; returns those that they had.
    pub fn replace_cameras(&mut self, cameras: Vec<(Pane, Camera)>) -> Vec<(Pane, Camera)> {
        let replaced = cameras.into_iter().map(|(pane, camera)| {
            let other = self.panes.others.iter_mut().find(|other| other.pane == pane);
            let held = other.map_or(&mut self.camera, |other| &mut other.camera);
            (pane, std::mem::replace(held, camera))
        });
        replaced.collect()
    }

    /// The place where the views meet.
    pub fn meeting_point(&self) -> Pos2 {
        let size = self.area.size();
        // Not nearer to an edge than this, and in the middle where there is no room.
        let least = (Vec2::splat(MIN_PANE_POINTS) / size.max(Vec2::splat(1.0))).min(MIDDLE);
        let part = self.panes.divide.max(least).min(vec2(1.0, 1.0) - least);
        (self.area.min + size * part).round()
    }

    /// Makes the views meet at this part of the viewport's width and height. Parallel views keep their scale, so that
    /// what they show stays as large as before.
    pub fn divide_at(&mut self, divide: Vec2) {
        let mut scales = Vec::new();
        self.in_each(|view| scales.push(view.camera.units_per_pixel(view.size())));
        self.panes.divide = divide;
        self.lay_out_panes();
        let mut scales = scales.into_iter();
        self.in_each(|view| {
            if let Some(scale) = scales.next().filter(|_| view.camera.orthographic) {
                view.camera.set_units_per_pixel(scale, view.size());
            }
        });
    }

    /// Gives each view its rectangle.
    fn lay_out_panes(&mut self) {
        let (split, area, middle) = (self.panes.split, self.area, self.meeting_point());
        self.in_each(|view| view.rect = view.panes.current.rect(split, area, middle));
        self.set_covered(self.covered);
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
        self.lay_out_panes();
        if is_new {
            // What was shown stays as it was.
            let (current, camera) = (self.panes.current, self.camera);
            self.in_each(|view| {
                if view.panes.current != current {
                    view.frame_all();
                }
            });
            self.camera = camera;
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

    /// Makes the view under the pointer the current one, while no drag goes on.
    pub fn follow_pointer(&mut self, ctx: &Context) {
        let is_busy = self.gesture != Gesture::None || self.flight.is_some();
        if self.panes.split == Split::One || is_busy {
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
    use super::super::pane::GAP_POINTS;
    use super::*;
    use egui::pos2;

    #[test]
    fn views_keep_a_least_size_and_parallel_ones_their_scale() {
        let mut view = View::new(None);
        view.lay_out(Rect::from_min_size(pos2(20.0, 10.0), vec2(800.0, 600.0)), Split::Four);
        let scale = |view: &View, pane| {
            let (camera, rect) = view.seen_in(pane);
            camera.units_per_pixel(glam::vec2(rect.width(), rect.height()))
        };
        let before = [Pane::Top, Pane::Front].map(|pane| scale(&view, pane));
        view.divide_at(vec2(0.25, 0.75));
        assert_eq!(view.meeting_point(), pos2(220.0, 460.0));
        assert_eq!(view.seen_in(Pane::Front).1.height(), 150.0 - GAP_POINTS / 2.0);
        for (pane, before) in [Pane::Top, Pane::Front].into_iter().zip(before) {
            assert!((scale(&view, pane) / before - 1.0).abs() < 1e-9, "{pane:?}");
        }
        view.divide_at(vec2(-3.0, 7.0));
        assert_eq!(view.meeting_point(), pos2(20.0 + MIN_PANE_POINTS, 610.0 - MIN_PANE_POINTS));
        view.lay_out(Rect::from_min_size(pos2(20.0, 10.0), vec2(100.0, 100.0)), Split::Four);
        assert_eq!(view.meeting_point(), pos2(70.0, 60.0), "no room: in the middle");
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
