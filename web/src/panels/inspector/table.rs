//! The tables of the inspector: names, values, and links to elements.

use editor::SelectMode;
use editor::ops::Connect;
use egui::{Button, Grid, Label, Response, RichText, Role, Ui, Vec2, vec2};
use halfedge::Element;

use crate::lists::columns::element_name;
use crate::request::{Request, Requests};
use crate::theme;

/// Values being entered in the inspector.
#[derive(Default)]
pub(crate) struct InspectorState {
    /// The position at which the split button adds the vertex, as a fraction of the edge.
    pub t: Option<f32>,
    pub connect: Option<Connect>,
    /// The number of quads along a side of each patch, for tessellation in the Bezier panel.
    pub tessellation: Option<u32>,
}

/// A name and a value in the inspector's table.
pub(super) fn fact(ui: &mut Ui, name: &str, value: impl Into<String>, meaning: &str) {
    ui.label(RichText::new(name).weak()).on_hover_text(meaning);
    ui.add(Label::new(RichText::new(value).monospace()).selectable(true));
    ui.end_row();
}

/// A name, and a link that selects the element pointed to.
pub(super) fn pointer(
    ui: &mut Ui,
    out: &mut Requests,
    name: &str,
    to: Option<(Element, u32)>,
    none: &str,
    meaning: &str,
) {
    ui.label(RichText::new(name).weak()).on_hover_text(meaning);
    match to {
        Some((kind, id)) => link(ui, out, name, kind, id),
        None => {
            ui.label(RichText::new(none).weak());
        }
    }
    ui.end_row();
}

/// A link that selects an element; the viewport highlights the element while the pointer is over the link.
pub(super) fn link(ui: &mut Ui, out: &mut Requests, name: &str, kind: Element, id: u32) {
    let text = element_name(kind, id);
    let link = link_button(ui, RichText::new(&text)).on_hover_text(format!("Select {}", text.to_lowercase()));
    link.clone().accessible_name(format!("{name}: {text}"));
    if link.hovered() {
        out.push(Request::Hover(kind, id));
    }
    if link.clicked() {
        out.select(kind, [id], SelectMode::Replace);
    }
}

/// A link, which is large enough for a finger on a touch screen.
fn link_button(ui: &mut Ui, text: RichText) -> Response {
    if !theme::is_for_touch(ui.ctx()) {
        return ui.link(text);
    }
    let text = text.color(ui.visuals().hyperlink_color);
    let button = Button::new(text).frame(false).min_size(Vec2::splat(theme::TOUCH_TARGET));
    let response = ui.add(button);
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_role(Role::Link));
    response
}

/// Links to several elements, in lines as wide as the panel.
pub(super) fn links(ui: &mut Ui, out: &mut Requests, name: &str, kind: Element, ids: &[u32]) {
    /// More links would push everything else out of the panel.
    const MAX_LINKS: usize = 24;
    ui.label(RichText::new(format!("{name} ({})", ids.len())).weak());
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(6.0, 2.0);
        for &id in ids.iter().take(MAX_LINKS) {
            let link = link_button(ui, RichText::new(id.to_string()).monospace());
            link.clone().accessible_name(element_name(kind, id));
            if link.hovered() {
                out.push(Request::Hover(kind, id));
            }
            if link.on_hover_text(format!("Select {kind} {id}")).clicked() {
                out.select(kind, [id], SelectMode::Replace);
            }
        }
        if ids.len() > MAX_LINKS {
            ui.label(RichText::new("…").weak());
        }
    });
}

/// The table of the inspector.
pub(super) fn facts(ui: &mut Ui, name: &str, add: impl FnOnce(&mut Ui)) {
    let row = if theme::is_for_touch(ui.ctx()) { 28.0 } else { 18.0 };
    Grid::new(name)
        .num_columns(2)
        .spacing(vec2(14.0, 4.0))
        .min_col_width(76.0)
        .min_row_height(row)
        .show(ui, add);
}

/// A measured number with a readable number of digits.
pub(super) fn measured(value: f32) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-4..1e7).contains(&size) { format!("{value:.5e}") } else { format!("{value:.6}") }
}
