//! Scrolling of a row list: by wheel, trackpad or finger, and by its bar.

use egui::{
    CornerRadius, CursorIcon, Id, Rect, Response, Role, Sense, TouchPhase, Ui, WidgetInfo, pos2, vec2,
};

use super::row_list::{RowList, RowListState};

/// The least length of the scroll bar's handle, in points.
const MIN_HANDLE_POINTS: f32 = 24.0;

impl RowList<'_> {
    /// Scrolls with the wheel, a trackpad or a finger.
    pub(super) fn scroll(&self, ui: &Ui, list: &Response, body: Rect, state: &mut RowListState) {
        let height = f64::from(self.row_height);
        if ui.rect_contains_pointer(body) {
            let delta = ui.input_mut(|input| std::mem::take(&mut input.smooth_scroll_delta.y));
            state.top -= f64::from(delta) / height;
        }
        let touch = ui.input(|input| {
            input.any_touches()
                || input.events.iter().any(|e| {
                    matches!(e, egui::Event::Touch { phase: TouchPhase::End | TouchPhase::Cancel, .. })
                })
        });
        if list.dragged() && touch {
            state.top -= f64::from(list.drag_delta().y) / height;
            state.glide = -f64::from(ui.input(|input| input.pointer.velocity().y)) / height;
        } else if state.glide != 0.0 {
            let dt = ui.input(|input| input.stable_dt.min(0.1));
            state.top += state.glide * f64::from(dt);
            state.glide *= (-4.0 * f64::from(dt)).exp();
            if state.glide.abs() < 1.0 || list.is_pointer_button_down_on() {
                state.glide = 0.0;
            } else {
                ui.ctx().request_repaint();
            }
        }
    }

    pub(super) fn scroll_bar(
        &self,
        ui: &Ui,
        bar: Rect,
        id: Id,
        state: &mut RowListState,
        in_view: f64,
        furthest: f64,
    ) {
        let response = ui.interact(bar, id.with("bar"), Sense::CLICK | Sense::DRAG);
        response.widget_info(|| WidgetInfo {
            value: Some(state.top),
            ..WidgetInfo::labeled(Role::ScrollBar, true, format!("Scroll {}", self.label.to_lowercase()))
        });
        ui.ctx().accesskit_node_builder(response.id, |node| {
            node.set_numeric_value(state.top);
            node.set_min_numeric_value(0.0);
            node.set_max_numeric_value(furthest);
        });
        if furthest <= 0.0 {
            return;
        }
        let length = (bar.height() * (in_view / self.rows as f64) as f32)
            .clamp(MIN_HANDLE_POINTS.min(bar.height()), bar.height());
        let travel = (bar.height() - length).max(1.0);
        let top = state.top.clamp(0.0, furthest);
        let handle_y = bar.min.y + travel * (top / furthest) as f32;
        let handle = Rect::from_min_size(pos2(bar.min.x, handle_y), vec2(bar.width(), length));
        if let Some(pointer) =
            response.interact_pointer_pos().filter(|_| response.is_pointer_button_down_on())
        {
            let grip = id.with("grip");
            if ui.input(|input| input.pointer.primary_pressed()) {
                // A press beside the handle moves the handle there.
                let offset = if handle.contains(pointer) { pointer.y - handle.min.y } else { length / 2.0 };
                ui.data_mut(|data| data.insert_temp(grip, offset));
            }
            let offset = ui.data(|data| data.get_temp(grip)).unwrap_or(length / 2.0);
            let along = ((pointer.y - offset - bar.min.y) / travel).clamp(0.0, 1.0);
            state.top = f64::from(along) * furthest;
        }
        let visuals = ui.style().interact(&response);
        let painted =
            handle.shrink2(vec2(if response.hovered() || response.dragged() { 1.5 } else { 3.0 }, 1.0));
        let color = if response.hovered() || response.dragged() {
            visuals.fg_stroke.color.gamma_multiply(0.6)
        } else {
            ui.visuals().weak_text_color().gamma_multiply(0.5)
        };
        ui.painter().rect_filled(painted, CornerRadius::same(4), color);
        response.on_hover_cursor(CursorIcon::Default);
    }
}
