//! The buttons of the bars over the viewport: an icon, with its label beside it, below it, or nowhere.

use egui::{
    Align2, Color32, FontId, Response, Role, Sense, StrokeKind, TextStyle, Ui, Vec2, WidgetInfo, vec2,
};

use crate::widgets::icons::Icon;

/// The size of a bar's icons, in points.
const ICON_POINTS: f32 = 20.0;

/// Where a button shows its label.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Label {
    /// Nowhere: the tooltip has it.
    Hidden,
    /// Beside the icon.
    Beside,
    /// Below the icon, in small text.
    Below,
}

/// The space between a label and the end of its button, in points.
const LABEL_MARGIN_POINTS: f32 = 12.0;

/// The width of a button of this height with its label beside the icon.
pub fn width_beside(ui: &Ui, label: &str, height: f32) -> f32 {
    let font = TextStyle::Button.resolve(ui.style());
    let text = ui.painter().layout_no_wrap(label.to_owned(), font, Color32::PLACEHOLDER);
    (height + text.size().x + LABEL_MARGIN_POINTS).ceil()
}

/// A toggle or a tool of a bar. `name` is its name in the accessibility tree.
pub fn tool_button(
    ui: &mut Ui,
    icon: Icon,
    (label, place): (&str, Label),
    name: &str,
    on: bool,
    size: Vec2,
) -> Response {
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| WidgetInfo::selected(Role::Button, ui.is_enabled(), on, name));
    if !ui.is_rect_visible(rect) {
        return response;
    }
    let visuals = ui.style().interact_selectable(&response, on);
    if on || response.hovered() || response.has_focus() {
        let stroke = if response.has_focus() { visuals.bg_stroke } else { egui::Stroke::NONE };
        ui.painter().rect(rect, visuals.corner_radius, visuals.weak_bg_fill, stroke, StrokeKind::Inside);
    }
    let color = visuals.text_color();
    let text = |anchor, at, style: TextStyle, color: Color32| {
        let font: FontId = style.resolve(ui.style());
        ui.painter().text(at, anchor, label, font, color);
    };
    let mut square = rect;
    match place {
        Label::Hidden => {}
        Label::Beside => {
            square.set_width(rect.height());
            text(Align2::LEFT_CENTER, square.right_center(), TextStyle::Button, color);
        }
        Label::Below => {
            square.set_height(rect.height() - 14.0);
            text(Align2::CENTER_BOTTOM, rect.center_bottom() - vec2(0.0, 4.0), TextStyle::Small, color);
        }
    }
    icon.paint_sized(ui.painter(), square, ICON_POINTS, color);
    response
}
