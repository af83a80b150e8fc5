//! A row of a list of commands: an icon, a name and a key, as wide as the list.

use editor::OpId;
use egui::{
    Align2, Color32, FontId, Rect, Response, Role, Sense, TextStyle, Ui, Vec2, WidgetInfo, pos2, vec2,
};

use super::operation_icons;

/// The least height of a row; fingers get more.
const MIN_HEIGHT: f32 = 28.0;
/// The width of the column of icons.
const ICON_COLUMN: f32 = 32.0;

/// A row that can be clicked, with an operation's icon. Its name in the accessibility tree is `name`.
pub fn operation_row(ui: &mut Ui, id: OpId, name: &str, key: &str) -> Response {
    let height = ui.spacing().interact_size.y.max(MIN_HEIGHT);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, ui.is_enabled(), name));
    if !ui.is_rect_visible(rect) {
        return response;
    }
    let visuals = ui.style().interact(&response);
    if ui.is_enabled() && (response.hovered() || response.has_focus() || response.is_pointer_button_down_on())
    {
        ui.painter().rect_filled(rect, 4.0, visuals.weak_bg_fill);
        if response.has_focus() {
            let stroke = egui::Stroke::new(1.5, ui.visuals().hyperlink_color);
            ui.painter().rect_stroke(rect, 4.0, stroke, egui::StrokeKind::Inside);
        }
    }
    let weak = ui.visuals().weak_text_color();
    let faded = |color: Color32| if ui.is_enabled() { color } else { color.gamma_multiply(0.6) };
    let icon = Rect::from_min_size(rect.min, vec2(ICON_COLUMN, height));
    let second = faded(ui.visuals().hyperlink_color);
    operation_icons::paint(id, ui.painter(), icon, faded(weak), second);
    let key_font = FontId::proportional(TextStyle::Small.resolve(ui.style()).size);
    let at = pos2(rect.right() - 8.0, rect.center().y);
    let key = ui.painter().text(at, Align2::RIGHT_CENTER, key, key_font, faded(weak));
    let text = if ui.is_enabled() { visuals.text_color() } else { weak };
    let left = rect.left() + ICON_COLUMN;
    let font = TextStyle::Body.resolve(ui.style());
    let galley = ui.painter().layout_no_wrap(name.to_owned(), font, text);
    let room = Rect::from_min_max(pos2(left, rect.top()), pos2(key.left() - 8.0, rect.bottom()));
    let place = pos2(left, rect.center().y) - Vec2::new(0.0, galley.size().y / 2.0);
    ui.painter().with_clip_rect(room.intersect(ui.clip_rect())).galley(place, galley, text);
    response
}
