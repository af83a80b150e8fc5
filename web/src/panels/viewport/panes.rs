//! The names of the views that the viewport is split into, and the frame of the active one.

use egui::{Rect, RichText, Stroke, StrokeKind, Ui, UiBuilder, Vec2, vec2};
use viewport::Side;

use crate::input::actions::{Action, describe};
use crate::page_view::Page;
use crate::request::{Request, Requests};
use crate::theme;
use crate::view::pane::{Pane, Split};
use crate::view::panes::name_of;

/// The distance of a name from the corner of its view, in points.
const GAP: Vec2 = vec2(8.0, 8.0);
/// The room for a name, in points.
const ROOM: Vec2 = vec2(140.0, 26.0);
/// The width of the active view's frame, in points.
const FRAME_POINTS: f32 = 2.0;

/// Draws names and frame. A name is a menu that chooses where its view looks from.
pub(super) fn show(ui: &mut Ui, page: &Page<'_>, out: &mut Requests) {
    if page.view.panes.split == Split::One {
        return;
    }
    let accent = ui.visuals().hyperlink_color;
    for pane in page.view.panes() {
        let (camera, rect) = page.view.seen_in(pane);
        let is_active = pane == page.view.panes.active;
        if is_active {
            ui.painter().rect_stroke(rect, 0.0, Stroke::new(FRAME_POINTS, accent), StrokeKind::Inside);
        }
        let corner = rect.intersect(page.view.free_area()).left_top();
        let area = Rect::from_min_size(corner + GAP, ROOM);
        ui.scope_builder(UiBuilder::new().max_rect(area).id_salt(pane), |ui| {
            let plate = theme::palette(ui.visuals()).overlay;
            ui.style_mut().visuals.widgets.inactive.weak_bg_fill = plate;
            let text = RichText::new(name_of(camera));
            let text = if is_active { text.strong() } else { text };
            let menu = ui.menu_button(text, |ui| choices(ui, pane, out));
            menu.response.on_hover_text("Choose where this view looks from");
        });
    }
}

/// The entries of a view's menu.
fn choices(ui: &mut Ui, pane: Pane, out: &mut Requests) {
    let sides = Side::ALL.map(Action::LookFrom);
    for action in sides.into_iter().chain([Action::Orthographic, Action::Frame, Action::FrameAll]) {
        let entry = describe(action);
        if ui.button(entry.label).on_hover_text(entry.description).clicked() {
            out.push(Request::ActivateView(pane));
            out.act(action);
            ui.close();
        }
    }
}
