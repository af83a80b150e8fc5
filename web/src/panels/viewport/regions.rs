//! Selecting in regions of the screen: the lasso, the circle, and what is drawn while the pointer is down.

use editor::SelectMode;
use egui::{
    Color32, CursorIcon, Event, PointerButton, Pos2, Rect, Response, Shape, Stroke, StrokeKind, Ui, pos2,
};
use viewport::{Region, RegionSelection};

use super::Viewport;
use super::pointer::modifiers_of_button;
use crate::input::brush_key;
use crate::page_view::Page;
use crate::request::{Request, Requests};
use crate::view::{Gesture, Selecting, Tool, View};

/// Points of a lasso are at least this far apart, in points of the screen.
const LASSO_STEP_POINTS: f32 = 2.0;
/// The lengths of the dashes of a lasso and of the gaps between them.
const DASH_POINTS: f32 = 6.0;
const DASH_GAP_POINTS: f32 = 4.0;
/// The height of the rows that a lasso is filled with.
const ROW_HEIGHT_POINTS: f32 = 2.0;
/// The radius of the mark at the point that the view turns about.
const CENTER_RADIUS_POINTS: f32 = 4.0;

impl Viewport<'_> {
    /// Begins to look for the elements of the listed kind in a region: those that are visible, or with x-ray all.
    pub(super) fn select_in(&mut self, region: Region, mode: SelectMode, stroke: Option<u64>) {
        let Some(object) = self.session.editor.document().active().filter(|object| object.visible()) else {
            return;
        };
        let (camera, size, visible_only) = (self.view.camera, self.view.size(), !self.view.style.x_ray);
        let region = RegionSelection::new(&camera, size, region, self.shown.kind, visible_only);
        self.view.regions.push_back(Selecting { object: object.id(), region, mode, stroke });
    }

    /// Continues to look for the elements in regions, as far as the frame's budget goes.
    pub(super) fn continue_regions(&mut self, ui: &Ui, out: &mut Requests) {
        while let Some(mut selecting) = self.view.regions.pop_front() {
            let active = self.session.editor.document().active();
            let Some(object) = active.filter(|object| object.id() == selecting.object) else { continue };
            let Some(ids) = self.view.step_region(object, &mut selecting.region) else {
                self.view.regions.push_front(selecting);
                ui.ctx().set_cursor_icon(CursorIcon::Progress);
                ui.ctx().request_repaint();
                return;
            };
            let Selecting { region, mode, stroke, .. } = selecting;
            match stroke {
                Some(_) if ids.is_empty() => {}
                Some(stroke) => {
                    out.push(Request::PaintSelection { kind: region.kind(), ids, mode, stroke });
                }
                None => out.select(region.kind(), ids, mode),
            }
        }
    }

    /// Adds the places that the pointer was at since the last frame to the lasso.
    pub(super) fn draw_lasso(&mut self, ui: &Ui) {
        let Gesture::Lasso { points, .. } = &mut self.view.gesture else { return };
        for at in path_of_pointer(ui) {
            if points.last().is_none_or(|last| last.distance(at) >= LASSO_STEP_POINTS) {
                points.push(at);
            }
        }
        ui.ctx().set_cursor_icon(CursorIcon::Crosshair);
    }

    /// Selects what a lasso goes around.
    pub(super) fn end_lasso(&mut self, points: Vec<Pos2>, mode: SelectMode) {
        let points = points.into_iter().map(|at| self.view.local(at)).collect();
        self.select_in(Region::lasso(points), mode, None);
    }

    /// Paints with the circle from the moment a button is pressed; returns whether it does.
    pub(super) fn paint(&mut self, ui: &Ui, response: &Response) -> bool {
        let goes_on = matches!(self.view.gesture, Gesture::Paint { .. });
        let is_brush = goes_on || has_brush(ui, self.view);
        if !is_brush || self.session.live.is_some() {
            return false;
        }
        let modifiers = modifiers_of_button(ui);
        // Even where the button is up again by the end of a slow frame.
        let is_here = response.is_pointer_button_down_on() || response.hovered();
        let pressed = |button| place_of_press(ui, button).filter(|at| is_here && response.rect.contains(*at));
        let middle = pressed(PointerButton::Middle);
        let begins = middle.or_else(|| pressed(PointerButton::Primary)).filter(|_| !modifiers.alt);
        if let Some(at) = begins
            && self.view.gesture == Gesture::None
        {
            let mode =
                if middle.is_some() || modifiers.command { SelectMode::Remove } else { SelectMode::Extend };
            self.view.strokes += 1;
            self.view.gesture = Gesture::Paint { at, mode, stroke: self.view.strokes };
            self.paint_to(at);
        }
        if !matches!(self.view.gesture, Gesture::Paint { .. }) {
            return false;
        }
        for at in path_of_pointer(ui) {
            self.paint_to(at);
        }
        if !ui.input(|input| input.pointer.any_down()) {
            self.view.gesture = Gesture::None;
        }
        true
    }

    /// Moves the circle to a place and selects or deselects what it covers on the way.
    fn paint_to(&mut self, to: Pos2) {
        let Gesture::Paint { at, mode, stroke } = &mut self.view.gesture else { return };
        let from = std::mem::replace(at, to);
        let (mode, stroke) = (*mode, *stroke);
        let region = Region::brush(self.view.local(from), self.view.local(to), self.view.circle_radius);
        self.select_in(region, mode, Some(stroke));
    }
}

/// Whether a drag paints with the circle.
fn has_brush(ui: &Ui, view: &View) -> bool {
    view.tool == Tool::Circle || brush_key::is_held(ui.ctx())
}

/// Where a button was pressed since the last frame.
fn place_of_press(ui: &Ui, wanted: PointerButton) -> Option<Pos2> {
    ui.input(|input| {
        input.events.iter().find_map(|event| match event {
            Event::PointerButton { pos, button, pressed: true, .. } if *button == wanted => Some(*pos),
            _ => None,
        })
    })
}

/// The places that the pointer was at since the last frame, however slow that was.
fn path_of_pointer(ui: &Ui) -> Vec<Pos2> {
    ui.input(|input| {
        let moves = input.events.iter().filter_map(|event| match event {
            Event::PointerMoved(at) => Some(*at),
            _ => None,
        });
        moves.collect()
    })
}

/// Draws the box, the lasso or the circle.
pub(super) fn show(ui: &Ui, rect: Rect, page: &Page<'_>) {
    paint_center(ui, page);
    let painter = ui.painter().with_clip_rect(rect);
    let accent = ui.visuals().hyperlink_color;
    let (fill, line) = (accent.gamma_multiply(0.15), Stroke::new(1.0, accent));
    let pointer = ui.input(|input| input.pointer.latest_pos());
    match (&page.view.gesture, pointer) {
        (Gesture::Box { from }, Some(to)) => {
            let area = Rect::from_two_pos(*from, to).intersect(rect);
            painter.rect(area, 0.0, fill, line, StrokeKind::Inside);
        }
        (Gesture::Lasso { points, .. }, _) => {
            painter.extend(lasso_fill(page.view, points, fill));
            let closed: Vec<Pos2> = points.iter().chain(points.first()).copied().collect();
            painter.extend(Shape::dashed_line(
                &closed,
                Stroke::new(1.5, accent),
                DASH_POINTS,
                DASH_GAP_POINTS,
            ));
        }
        (gesture, Some(at))
            if rect.contains(at)
                && (matches!(gesture, Gesture::Paint { .. }) || has_brush(ui, page.view)) =>
        {
            let radius = page.view.circle_radius;
            let is_painting = matches!(gesture, Gesture::Paint { .. });
            if is_painting {
                painter.circle_filled(at, radius, fill);
            }
            // A dark ring around the light one shows on any background.
            painter.circle_stroke(at, radius + 1.0, Stroke::new(1.0, Color32::from_black_alpha(110)));
            painter.circle_stroke(at, radius, Stroke::new(1.5, accent));
            if matches!(gesture, Gesture::Paint { mode: SelectMode::Remove, .. })
                || (!is_painting && ui.input(|input| input.modifiers.command))
            {
                painter.hline(at.x - 5.0..=at.x + 5.0, at.y, Stroke::new(2.0, accent));
            }
        }
        _ => {}
    }
}

/// The inside of a lasso, in rows: where it crosses itself too, it shows what will be selected.
fn lasso_fill(view: &View, points: &[Pos2], fill: Color32) -> Vec<Shape> {
    let region = Region::lasso(points.iter().map(|at| view.local(*at)).collect());
    let bounds = region.bounds();
    if !(bounds.max - bounds.min).is_finite() {
        return Vec::new();
    }
    let width = bounds.max.x - bounds.min.x;
    let rows = ((bounds.max.y - bounds.min.y) / ROW_HEIGHT_POINTS) as usize;
    let row = |i: usize| {
        let top = bounds.min.y + i as f32 * ROW_HEIGHT_POINTS;
        let middle = top + ROW_HEIGHT_POINTS * 0.5;
        let ends = [glam::vec2(bounds.min.x, middle), glam::vec2(bounds.max.x, middle)];
        region.clip(ends).into_iter().map(move |part| (top, part))
    };
    let corner = view.rect.min.to_vec2();
    let place = |x: f32, y: f32| pos2(bounds.min.x + width * x, y) + corner;
    (0..rows)
        .flat_map(row)
        .map(|(top, [from, to])| {
            Shape::rect_filled(
                Rect::from_min_max(place(from, top), place(to, top + ROW_HEIGHT_POINTS)),
                0.0,
                fill,
            )
        })
        .collect()
}

/// Marks the point that the view is being turned about.
fn paint_center(ui: &Ui, page: &Page<'_>) {
    let center = page.view.turning.center.filter(|_| page.view.gesture == Gesture::Orbit);
    let Some(at) = center.and_then(|center| page.view.project(center.as_vec3())) else { return };
    let painter = ui.painter().with_clip_rect(page.view.rect);
    // Two rings show on any background.
    painter.circle_stroke(at, CENTER_RADIUS_POINTS + 1.0, Stroke::new(1.0, Color32::from_black_alpha(160)));
    painter.circle_stroke(at, CENTER_RADIUS_POINTS, Stroke::new(1.5, ui.visuals().hyperlink_color));
}
