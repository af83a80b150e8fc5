//! The drawing of curves, control points and the construction over the picture.

use crate::bezier::{self, ControlPoint, Drawn, Player, active};
use crate::theme;
use crate::view::View;
use editor::{Bezier, Editor};
use egui::epaint::Hsva;
use egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, Ui, vec2};
use glam::Vec3;
use surface::bezier::{Curve, Patch};

/// The largest number of control points that are labelled with their indices.
const MAX_NUMBERED_POINTS: usize = 24;

/// With more control points than this, those of other patches than the chosen one are drawn small.
const MAX_LARGE_POINTS: usize = 64;

/// With more control points than this, those of a curve are drawn small.
const MAX_LARGE_CURVE_POINTS: usize = 500;

/// The painter, with the mapping from the scene to the page.
struct Pen<'a> {
    view: &'a View,
    player: &'a Player,
    painter: Painter,
    dark: bool,
}

impl Pen<'_> {
    fn at(&self, point: Vec3) -> Option<Pos2> {
        self.view.project(point)
    }

    /// A polyline, with gaps where it passes behind the eye.
    fn line(&self, points: &[Vec3], stroke: Stroke) {
        let mut run = Vec::with_capacity(points.len());
        let draw = |run: &mut Vec<Pos2>| {
            if run.len() > 1 {
                self.painter.add(Shape::line(std::mem::take(run), stroke));
            }
            run.clear();
        };
        for &point in points {
            match self.at(point) {
                Some(at) => run.push(at),
                None => draw(&mut run),
            }
        }
        draw(&mut run);
    }

    fn dot(&self, point: Vec3, radius: f32, color: Color32) {
        if let Some(at) = self.at(point) {
            self.painter.circle_filled(at, radius, color);
        }
    }

    /// The colour of a level: from blue via violet to red for the last one.
    fn level_color(&self, level: usize, last: usize) -> Color32 {
        let along = level as f32 / last.max(1) as f32;
        let brightness = if self.dark { 0.95 } else { 0.72 };
        Hsva::new(0.58 + 0.42 * along, 0.7, brightness, 1.0).into()
    }

    /// The levels from the second on; the first consists of the points that the construction starts from.
    /// The last level drawn is emphasised.
    fn levels(&self, levels: &[Vec<Vec3>], shown: usize, first: usize, last: usize) {
        for (at, points) in levels.iter().enumerate().skip(1).take(shown) {
            self.level(points, self.level_color(first + at, last), at == shown);
        }
    }

    fn level(&self, points: &[Vec3], color: Color32, strong: bool) {
        self.line(points, Stroke::new(if strong { 2.0 } else { 1.25 }, color));
        for &point in points {
            self.dot(point, if points.len() == 1 { 5.0 } else { 3.0 }, color);
        }
    }
}

/// Draws the curves of all visible objects, and the player of the active one.
pub(super) fn paint(ui: &Ui, rect: Rect, editor: &Editor, view: &View, player: &mut Player) {
    if player.advance(ui.input(|input| input.stable_dt.min(0.1))) {
        ui.ctx().request_repaint();
    }
    let player = &*player;
    let dark = ui.visuals().dark_mode;
    let pen = Pen { view, player, painter: ui.painter().with_clip_rect(rect), dark };
    let strong = ui.visuals().strong_text_color();
    let weak = ui.visuals().weak_text_color();
    let own = active(editor).filter(|(object, _)| object.visible());
    for object in editor.document().objects().iter().filter(|object| object.visible()) {
        let is_own = own.is_some_and(|(own, _)| own.id() == object.id());
        let Some(points) = player.lines.get(&object.id()) else { continue };
        if !is_own {
            pen.line(points, Stroke::new(1.5, weak));
        } else if player.controls.whole {
            pen.line(points, Stroke::new(2.5, strong));
        }
    }
    let Some((_, bezier)) = own else { return };
    match bezier {
        Bezier::Curve(curve) => pen.paint_curve(curve, strong, weak),
        Bezier::Surface(patches) => {
            let marked = if patches.len() > 1 { pen.marked(ui) } else { ui.visuals().hyperlink_color };
            pen.paint_surface(patches, marked, ui.visuals().hyperlink_color);
        }
    }
    pen.paint_points(ui, bezier);
}

impl Pen<'_> {
    fn paint_curve(&self, curve: &Curve, strong: Color32, weak: Color32) {
        let player = self.player;
        let drawn = Drawn::of(curve.points.len(), player.controls.level);
        self.line(&curve.level(0, 0.0, drawn.stride), Stroke::new(1.0, weak));
        let last = curve.points.len().saturating_sub(1);
        if player.controls.level == 0 || last == 0 {
            return;
        }
        if player.controls.level == last && !player.controls.whole {
            // The part of the curve up to the construction.
            self.line(&curve.polyline(player.controls.t), Stroke::new(2.5, strong));
        }
        let first = Curve { points: curve.level(drawn.level, player.controls.t, drawn.level_stride) };
        for (at, points) in (drawn.level..=player.controls.level).zip(first.levels(player.controls.t)) {
            self.level(&points, self.level_color(at, last), at == player.controls.level);
        }
    }

    /// The colour of what is chosen.
    fn marked(&self, ui: &Ui) -> Color32 {
        let [r, g, b] = theme::viewport(ui.visuals()).selected.0;
        Color32::from_rgb(r, g, b)
    }

    /// The control nets, that of the chosen patch over the others in `marked`, and the construction.
    fn paint_surface(&self, patches: &[Patch], marked: Color32, plain: Color32) {
        let player = self.player;
        let mut nets: Vec<(usize, &Patch)> = player.nets(patches).collect();
        nets.sort_by_key(|(at, _)| *at == player.controls.patch);
        for (at, patch) in nets {
            let stroke = if at == player.controls.patch {
                Stroke::new(2.0, marked)
            } else {
                Stroke::new(1.0, plain.gamma_multiply(0.7))
            };
            let [first, second, third, fourth] = patch.rows;
            for (((a, b), c), d) in first.into_iter().zip(second).zip(third).zip(fourth) {
                self.line(&[a, b, c, d], stroke);
            }
            for row in &patch.rows {
                self.line(row, stroke);
            }
        }
        let Some(patch) = patches.get(player.controls.patch).filter(|_| player.controls.level > 0) else {
            return;
        };
        let (rows, down) = (player.controls.level.min(3), player.controls.level.saturating_sub(3));
        let construction = patch.construction(player.controls.t, player.controls.v);
        for levels in &construction.rows {
            self.levels(levels, rows, 0, bezier::SURFACE_LEVELS);
        }
        if rows == 3 {
            // The curve over the surface whose control points are the results of the rows.
            let column = Curve { points: construction.column.first().cloned().unwrap_or_default() };
            let color = self.level_color(3, bezier::SURFACE_LEVELS);
            self.line(&column.points, Stroke::new(1.25, color));
            self.line(&column.polyline(1.0), Stroke::new(2.5, color));
        }
        self.levels(&construction.column, down, 3, bezier::SURFACE_LEVELS);
    }

    fn paint_points(&self, ui: &Ui, bezier: &Bezier) {
        let player = self.player;
        let selected = self.marked(ui);
        let points = player.points(bezier);
        let crowded = points.len() > MAX_LARGE_POINTS;
        let large = points.len() <= MAX_LARGE_CURVE_POINTS;
        let numbered = points.len() <= MAX_NUMBERED_POINTS && bezier.curve().is_some();
        let plain = ui.visuals().hyperlink_color;
        for (point, position) in points {
            let Some(at) = self.at(position) else { continue };
            let chosen = player.controls.chosen == Some(point);
            let stands_out =
                player.hovered == Some(point) || (player.is_on_patch(point) && (large || chosen));
            if crowded && !stands_out {
                self.painter.circle_filled(at, 2.0, plain.gamma_multiply(0.7));
                continue;
            }
            let radius = if chosen || player.hovered == Some(point) { 6.0 } else { 4.5 };
            let color = if chosen { selected } else { plain };
            self.painter.circle(at, radius, color, Stroke::new(1.0, ui.visuals().panel_fill));
            if let (true, ControlPoint::Curve(number)) = (numbered, point) {
                let font = FontId::proportional(12.0);
                let color = ui.visuals().text_color();
                self.painter.text(at + vec2(8.0, -6.0), Align2::LEFT_BOTTOM, number.to_string(), font, color);
            }
        }
    }
}
