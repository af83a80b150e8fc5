//! The lines between the views of a split viewport, which can be dragged.

use egui::{
    CursorIcon, EventFilter, Key, Modifiers, PointerButton, Pos2, Rect, Response, Role, Sense, Ui, Vec2, vec2,
};

use crate::view::View;
use crate::view::pane::{GAP_POINTS, MIDDLE, Split};

/// How far from a line a pointer takes it, in points.
const REACH_POINTS: f32 = 4.0;
/// How far an arrow key moves a line, in points.
const STEP_POINTS: f32 = 16.0;

/// A line, or the place where two meet: it moves along the axes that are 1.
struct Divider {
    name: &'static str,
    moves: Vec2,
    cursor: CursorIcon,
}

const SIDEWAYS: Divider = Divider {
    name: "Line between the views on the left and on the right",
    moves: Vec2::X,
    cursor: CursorIcon::ResizeHorizontal,
};
const UP_AND_DOWN: Divider = Divider {
    name: "Line between the views above and below",
    moves: Vec2::Y,
    cursor: CursorIcon::ResizeVertical,
};
const BOTH: Divider =
    Divider { name: "Where the views meet", moves: Vec2::splat(1.0), cursor: CursorIcon::Move };

/// Draws the lines and moves them.
pub(super) fn show(ui: &Ui, view: &mut View) {
    let dividers: &[Divider] = match view.panes.split {
        Split::One => return,
        Split::Two => &[SIDEWAYS],
        // The last one lies over the others.
        Split::Four => &[SIDEWAYS, UP_AND_DOWN, BOTH],
    };
    for divider in dividers {
        let response = divider.respond(ui, view);
        if let Some(to) = divider.moved_to(ui, &response, view) {
            view.divide_at(to);
            ui.ctx().request_repaint();
        }
        if response.hovered() || response.dragged() || response.has_focus() {
            for line in divider.lines(view) {
                ui.painter().rect_filled(line.expand(1.0), 1.0, ui.visuals().hyperlink_color);
            }
        }
    }
}

impl Divider {
    /// The lines that move, across the whole viewport.
    fn lines(&self, view: &View) -> Vec<Rect> {
        let (area, at) = (view.area, view.meeting_point());
        let upright = Rect::from_center_size(at, vec2(GAP_POINTS, 0.0)).with_min_y(area.top());
        let level = Rect::from_center_size(at, vec2(0.0, GAP_POINTS)).with_min_x(area.left());
        let both = [
            (self.moves.x, upright.with_max_y(area.bottom())),
            (self.moves.y, level.with_max_x(area.right())),
        ];
        both.into_iter().filter(|(moves, _)| *moves > 0.0).map(|(_, line)| line).collect()
    }

    fn respond(&self, ui: &Ui, view: &View) -> Response {
        let reach = if let [line] = self.lines(view).as_slice() {
            line.expand2(Vec2::splat(REACH_POINTS - GAP_POINTS / 2.0) * self.moves)
        } else {
            Rect::from_center_size(view.meeting_point(), Vec2::splat(3.0 * REACH_POINTS))
        };
        let response = ui.interact(reach, ui.scope_id().with(self.name), Sense::click_and_drag());
        let parts = view.meeting_point() - view.area.min;
        let share = (parts / view.area.size()).dot(self.moves) / (self.moves.x + self.moves.y);
        let percent = (share * 100.0).round();
        response.widget_info(|| egui::WidgetInfo::labeled(Role::Splitter, true, self.name));
        ui.ctx().accesskit_node_builder(response.id, |node| {
            node.set_numeric_value(percent.into());
            node.set_min_numeric_value(0.0);
            node.set_max_numeric_value(100.0);
        });
        let text = "Drag to resize the views. Double-click to make them the same size";
        response.on_hover_cursor(self.cursor).on_hover_text(text)
    }

    /// Where the views meet after what the pointer and the keys do, as parts of the viewport; none if it stays.
    fn moved_to(&self, ui: &Ui, response: &Response, view: &View) -> Option<Vec2> {
        let divide = view.panes.divide;
        let meet_at = |at: Pos2| {
            let part = (at - view.area.min) / view.area.size();
            let part = part.clamp(Vec2::ZERO, Vec2::splat(1.0));
            Some(divide + (part - divide) * self.moves).filter(|to| *to != divide)
        };
        let by_key = response.clicked() && !response.clicked_by(PointerButton::Primary);
        if response.double_clicked() || by_key {
            // The other axis stays.
            return Some(divide + (MIDDLE - divide) * self.moves);
        }
        if response.dragged() {
            let at = response.interact_pointer_pos()?;
            ui.ctx().set_cursor_icon(self.cursor);
            return meet_at(at);
        }
        if !response.has_focus() {
            return None;
        }
        let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, arrows));
        let ways = [
            (Key::ArrowLeft, -Vec2::X),
            (Key::ArrowRight, Vec2::X),
            (Key::ArrowUp, -Vec2::Y),
            (Key::ArrowDown, Vec2::Y),
        ];
        let by = ways.map(|(key, way)| {
            way * ui.input_mut(|input| input.count_and_consume_key(Modifiers::NONE, key)) as f32
        });
        let by = by.into_iter().fold(Vec2::ZERO, |sum, way| sum + way) * STEP_POINTS;
        if by * self.moves == Vec2::ZERO { None } else { meet_at(view.meeting_point() + by) }
    }
}
