//! A square button with an icon.

use egui::{Response, Role, Sense, Ui, Vec2, WidgetInfo};

use super::icons::Icon;

/// A square button with an icon. `name` is its name in the accessibility tree.
pub fn icon_button(ui: &mut Ui, icon: Icon, name: &str, selected: bool) -> Response {
    let side = ui.spacing().interact_size.y.max(26.0);
    let (rect, response) = ui.allocate_exact_size(Vec2::splat(side), Sense::click());
    response.widget_info(|| {
        if selected {
            WidgetInfo::selected(Role::Button, ui.is_enabled(), true, name)
        } else {
            WidgetInfo::labeled(Role::Button, ui.is_enabled(), name)
        }
    });
    if ui.is_rect_visible(rect) {
        let visuals = ui.style().interact_selectable(&response, selected);
        if selected || response.hovered() || response.has_focus() {
            ui.painter().rect(
                rect,
                visuals.corner_radius,
                visuals.weak_bg_fill,
                visuals.bg_stroke,
                egui::StrokeKind::Inside,
            );
        }
        icon.paint(ui.painter(), rect, visuals.text_color());
    }
    response
}
