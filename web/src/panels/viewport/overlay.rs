//! The overlays on the picture: the info overlay, what to do if there is nothing to see, and the mark of a flight.

use egui::{Align2, Color32, FontId, Pos2, Rect, RichText, Role, Sense, Stroke, Ui, Vec2, WidgetInfo, vec2};
use halfedge::Element;

use crate::input::actions::Action;
use crate::input::keys;
use crate::lists::columns::{counted, element_name, row};
use crate::page_view::Page;
use crate::panels::fields::selection_words;
use crate::theme;
use halfedge::words::thousands;

/// From the middle of the view to the ends of the mark, and to where it begins, in points.
const MARK_POINTS: f32 = 9.0;
const MARK_GAP_POINTS: f32 = 3.0;

/// Draws the overlays.
pub(super) fn paint(ui: &mut Ui, rect: Rect, page: &Page<'_>) {
    if page.view.picture.is_none() {
        say_in_middle(
            ui,
            rect,
            "No graphics",
            "The viewport can't draw here; lists and inspector still work.",
        );
    } else if page.shown.is_opening {
        say_in_middle(ui, rect, "Opening your last document…", "");
    } else if page.editor.document().objects().is_empty() {
        let open = keys::how_to(ui.ctx(), Action::Open);
        let hint = format!("Drop an OBJ file here, {open}, paste OBJ text, or create a shape.");
        say_in_middle(ui, rect, "Nothing to see yet", &hint);
    }
    if page.view.picture.is_some() && is_emptied(page) {
        let undo = keys::how_to(ui.ctx(), Action::Undo);
        let hint = format!("To bring it back, {undo}. You can also open a file or create a shape.");
        say_in_middle(ui, rect, "Nothing is left of the model", &hint);
    }
    let free = page.view.free_area();
    if page.shown.overlay {
        info(ui, free, page);
    }
}

/// Marks the middle of the view, which the eye flies towards.
pub(super) fn mark_flight(ui: &Ui, page: &Page<'_>) {
    if page.view.flight.is_none() {
        return;
    }
    let middle = page.view.rect.center();
    let painter = ui.painter().with_clip_rect(page.view.rect);
    // The dark lines behind show on a light background.
    let dark = Stroke::new(3.0, Color32::from_black_alpha(110));
    for stroke in [dark, Stroke::new(1.0, Color32::WHITE)] {
        for way in [Vec2::X, -Vec2::X, Vec2::Y, -Vec2::Y] {
            painter.line_segment([middle + way * MARK_GAP_POINTS, middle + way * MARK_POINTS], stroke);
        }
    }
}

/// Whether there are objects, but nothing of them is left to see.
fn is_emptied(page: &Page<'_>) -> bool {
    let objects = page.editor.document().objects();
    !objects.is_empty()
        && objects.iter().all(|object| object.mesh().vertex_count() == 0 && object.bezier().is_none())
}

fn say_in_middle(ui: &mut Ui, rect: Rect, title: &str, hint: &str) {
    let area = Rect::from_center_size(rect.center(), vec2(rect.width().min(360.0), 90.0));
    ui.scope_builder(egui::UiBuilder::new().max_rect(area), |ui| {
        ui.vertical_centered(|ui| {
            // Clicks and drags go to the viewport beneath.
            ui.add(egui::Label::new(RichText::new(title).heading()).selectable(false));
            ui.add(egui::Label::new(RichText::new(hint).weak()).wrap().selectable(false));
        });
    });
}

/// Describes the element under the pointer, the selection and the view.
fn info(ui: &Ui, rect: Rect, page: &Page<'_>) {
    let mut lines = Vec::new();
    let mesh = page.editor.mesh();
    if let Some((kind, id)) = page.view.hovered
        && let Some(row) = mesh.and_then(|mesh| row(mesh, kind, id, page.editor.document().offset()))
    {
        lines.push(format!("{}: {}", element_name(kind, id), row.value(kind)));
    }
    let selection = page.editor.selection();
    lines.push(selection_words(selection.kind(), selection.len(), selection.latest()));
    if let Some(mesh) = mesh {
        let found = page.survey.found();
        let number = |value: Option<usize>| value.map_or_else(|| "…".to_owned(), thousands);
        lines.push(format!(
            "{}, Euler characteristic {}, boundary loops {}, components {}",
            counted(Element::Face, mesh.face_count()),
            mesh.euler_characteristic(),
            number(found.map(|found| found.boundary_loops)),
            number(found.map(|found| found.components)),
        ));
    }
    let camera = &page.view.camera;
    let projection = if camera.orthographic { "parallel" } else { "perspective" };
    lines.push(format!(
        "View: {projection}, turn {:.0}°, height {:.0}°, distance {:.3}",
        camera.yaw.to_degrees(),
        camera.pitch.to_degrees(),
        camera.distance
    ));
    lines.push(format!(
        "Frame: {:.1} ms, at most {:.1} ms{}",
        page.frames.median(),
        page.frames.worst(),
        match page.platform.device().renderer.as_str() {
            "webgpu" => ", WebGPU",
            "webgl2" => ", WebGL2",
            _ => "",
        }
    ));
    let text = lines.join("\n");
    let area = label(ui, rect.left_top() + vec2(12.0, 12.0), Align2::LEFT_TOP, &text);
    let id = ui.scope_id().with("info overlay");
    let response = ui.interact(area, id, Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, &text));
}

/// Text on a background plate that is readable over any picture; returns where the plate is.
fn label(ui: &Ui, at: Pos2, anchor: Align2, text: &str) -> Rect {
    let font = FontId::proportional(12.0);
    let width = ui.max_rect().width() - 32.0;
    let galley = ui.painter().layout(text.to_owned(), font, ui.visuals().text_color(), width);
    let area = anchor.anchor_size(at, galley.size() + vec2(16.0, 10.0));
    ui.painter().rect_filled(area, 6.0, theme::palette(ui.visuals()).overlay);
    ui.painter().galley(area.min + vec2(8.0, 5.0), galley, ui.visuals().text_color());
    area
}
