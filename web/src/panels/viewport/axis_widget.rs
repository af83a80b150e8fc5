//! The axis widget in the viewport's lower right corner: the axes as the camera sees them. A click on a ball looks along
//! its axis, another one from the opposite side, and a drag turns the view.

use egui::{
    Align2, Color32, CursorIcon, FontId, Id, PointerButton, Pos2, Rect, Response, Role, Sense, Stroke,
    StrokeKind, Ui, Vec2, WidgetInfo, vec2,
};
use viewport::{Camera, Side};

use crate::input::actions::Action;
use crate::input::keys;
use crate::request::{Request, Requests};
use crate::shown::Shown;
use crate::theme;
use crate::view::View;

/// In a smaller part of the viewport, in points, there is no widget.
const MIN_ROOM: Vec2 = vec2(160.0, 140.0);
/// The distance from the edges of the viewport, in points.
const GAP_POINTS: f32 = 8.0;

/// The sizes of the widget, in points.
struct Sizes {
    /// From the middle to the middle of a ball at most.
    arm: f32,
    ball: f32,
}

const MOUSE: Sizes = Sizes { arm: 30.0, ball: 9.0 };
const TOUCH: Sizes = Sizes { arm: 36.0, ball: 11.0 };

/// The end of an axis.
struct Ball {
    side: Side,
    at: Pos2,
    /// Its distance behind the middle, from -1 to 1.
    depth: f64,
    /// The axis and whether it is its positive end.
    axis: usize,
    positive: bool,
}

/// Draws the widget in the active view, in the part of the viewport that no bar covers, and turns the view as it says.
pub(super) fn show(ui: &Ui, room: Rect, shown: &Shown, view: &mut View, out: &mut Requests) {
    let current = view.panes.current;
    view.go_to(view.panes.active);
    show_in_current(ui, room, shown, view, out);
    view.go_to(current);
}

fn show_in_current(ui: &Ui, room: Rect, shown: &Shown, view: &mut View, out: &mut Requests) {
    let free = view.free_rect().intersect(room);
    if free.width() < MIN_ROOM.x || free.height() < MIN_ROOM.y || shown.welcome {
        return;
    }
    let sizes = if shown.touch { TOUCH } else { MOUSE };
    let radius = sizes.arm + sizes.ball + 4.0;
    let center = free.right_bottom() - Vec2::splat(radius + GAP_POINTS);
    let id = ui.scope_id().with("axis widget");
    let whole = Rect::from_center_size(center, Vec2::splat(2.0 * radius));
    // Not focusable: its balls are.
    let back = ui.interact(whole, id, Sense::CLICK | Sense::DRAG);
    let balls = balls(&view.camera, center, &sizes);
    let size = if shown.touch { theme::TOUCH_TARGET } else { 2.0 * sizes.ball };
    let responses: Vec<Response> = balls.iter().map(|ball| ball.respond(ui, id, size)).collect();

    let turns = responses.iter().chain([&back]).find(|response| response.dragged());
    let turned_by = turns.map(Response::drag_delta);
    if let Some(by) = turned_by {
        view.turning.center = None;
        view.turn(glam::vec2(by.x, by.y));
        ui.ctx().set_cursor_icon(CursorIcon::Grabbing);
    }
    // A click means the nearest ball, wherever it is: those for fingers overlap.
    let nearest = |at: Pos2| {
        let distance = |ball: &&Ball| ball.at.distance(at) + 0.1 * ball.depth as f32;
        balls.iter().min_by(|a, b| distance(a).total_cmp(&distance(b)))
    };
    let mut all = responses.iter().chain([&back]);
    let clicked = all.find(|response| response.clicked_by(PointerButton::Primary));
    let by_pointer = clicked.and_then(Response::interact_pointer_pos).and_then(nearest);
    let is_by_key = |response: &Response| response.clicked() && clicked.is_none();
    let by_key = balls.iter().zip(&responses).find(|(_, response)| is_by_key(response));
    if let Some(ball) = by_pointer.or(by_key.map(|(ball, _)| ball)) {
        out.push(Request::ActivateView(view.panes.active));
        out.act(Action::LookFrom(looked_from(&view.camera, ball.side)));
    }

    let pointer = ui.input(|input| input.pointer.hover_pos());
    let over = responses.iter().chain([&back]).find(|response| response.hovered());
    if over.is_some() || turned_by.is_some() {
        let fill = theme::palette(ui.visuals()).overlay.gamma_multiply(0.6);
        ui.painter().circle_filled(center, radius, fill);
    }
    let meant = pointer.filter(|_| over.is_some() && turned_by.is_none()).and_then(nearest);
    for ball in &balls {
        let is_meant = meant.is_some_and(|meant| meant.side == ball.side);
        ball.paint(ui, center, &sizes, is_meant);
    }
    if let (Some(ball), Some(over)) = (meant, over) {
        let side = looked_from(&view.camera, ball.side);
        let text = keys::tooltip(ui.ctx(), words(side), Action::LookFrom(side));
        over.clone().on_hover_cursor(CursorIcon::PointingHand).on_hover_text(text);
    }
}

/// The balls, the farthest first.
fn balls(camera: &Camera, center: Pos2, sizes: &Sizes) -> Vec<Ball> {
    let [right, up, forward] = camera.axes();
    let mut balls: Vec<Ball> = Side::ALL
        .into_iter()
        .map(|side| {
            let out = camera.direction_of(side);
            let axis = out.abs().to_array().iter().position(|part| *part > 0.5).unwrap_or(0);
            let at = center + vec2(out.dot(right) as f32, -out.dot(up) as f32) * sizes.arm;
            Ball { side, at, depth: out.dot(forward), axis, positive: out.element_sum() > 0.0 }
        })
        .collect();
    balls.sort_by(|a, b| b.depth.total_cmp(&a.depth));
    balls
}

/// The side from which a click on a side's ball looks.
fn looked_from(camera: &Camera, side: Side) -> Side {
    if camera.is_from(side) { side.opposite() } else { side }
}

impl Ball {
    fn respond(&self, ui: &Ui, widget: Id, size: f32) -> Response {
        let rect = Rect::from_center_size(self.at, Vec2::splat(size));
        let response = ui.interact(rect, widget.with(words(self.side)), Sense::click_and_drag());
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, words(self.side)));
        response
    }

    fn paint(&self, ui: &Ui, center: Pos2, sizes: &Sizes, hovered: bool) {
        let palette = theme::palette(ui.visuals());
        let Some(&color) = palette.axes.get(self.axis) else { return };
        let painter = ui.painter();
        // What points away is nearer to the background.
        let faded = if self.depth > 0.1 { color.gamma_multiply(0.75) } else { color };
        if self.positive {
            let way = (self.at - center).normalized();
            let end = self.at - way * sizes.ball;
            if (end - center).dot(way) > 0.0 {
                painter.line_segment([center, end], Stroke::new(2.0, faded));
            }
        }
        let on_ball =
            if ui.visuals().dark_mode { Color32::from_rgb(0x12, 0x14, 0x18) } else { Color32::WHITE };
        let ring = if hovered {
            Stroke::new(2.0, ui.visuals().strong_text_color())
        } else {
            Stroke::new(1.5, color)
        };
        let rect = Rect::from_center_size(self.at, Vec2::splat(2.0 * sizes.ball));
        let disc = |fill| painter.rect(rect, sizes.ball, fill, ring, StrokeKind::Middle);
        let text = if self.positive {
            disc(color);
            on_ball
        } else {
            // Opaque, so that what is behind it doesn't show through.
            disc(palette.bar.lerp_to_gamma(color, 0.25));
            ui.visuals().strong_text_color()
        };
        if self.positive || hovered {
            let name = ["x", "y", "z"].get(self.axis).copied().unwrap_or_default();
            let name = if self.positive { name.to_owned() } else { format!("−{name}") };
            let font = FontId::proportional(if self.positive { 13.0 } else { 11.0 });
            painter.text(self.at, Align2::CENTER_CENTER, name, font, text);
        }
    }
}

/// What a view from a side is called.
fn words(side: Side) -> &'static str {
    match side {
        Side::Front => "View from the front",
        Side::Back => "View from the back",
        Side::Right => "View from the right",
        Side::Left => "View from the left",
        Side::Top => "View from above",
        Side::Bottom => "View from below",
    }
}
