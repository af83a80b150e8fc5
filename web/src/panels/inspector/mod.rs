//! The inspector: everything about the selected element, and what can be done with it.

mod edge;
mod face;
mod halfedge;
mod vertex;

use ::halfedge::Element;
use editor::ops::Connect;
use editor::{OpId, SelectMode};
use egui::{Button, Grid, Label, RichText, Ui, vec2};

use crate::input::actions::{self, Action};
use crate::input::availability::opens_form;
use crate::lists::columns::element_name;
use crate::page_view::Page;
use crate::panels::bezier as bezier_panel;
use crate::panels::fields;
use crate::panels::menu_bar::explain;
use crate::request::{Request, Requests};
use crate::theme::TOUCH_TARGET;

/// Operations that the inspector has controls of its own for, further up.
const SHOWN_ALREADY: [OpId; 3] = [OpId::SetVertexPosition, OpId::SetFaceColor, OpId::SplitEdge];

/// What is filled in in the inspector.
#[derive(Default)]
pub(crate) struct InspectorState {
    /// Where along an edge the split button puts the vertex.
    t: Option<f32>,
    connect: Option<Connect>,
    /// How many quads lie along a side of each patch that the Bezier panel tessellates.
    tessellation: Option<u32>,
}

pub(crate) fn show(ui: &mut Ui, page: &Page<'_>, own: &mut InspectorState, out: &mut Requests) {
    ui.add_space(4.0);
    bezier_panel::show(ui, page, &mut own.tessellation, out);
    let selection = page.editor.selection();
    let (kind, count) = (selection.kind(), selection.len());
    let latest = selection.latest();
    let Some(id) = latest else {
        if crate::bezier::active(&page.editor).is_none() {
            empty_inspector(ui, page);
        }
        return;
    };
    ui.horizontal(|ui| {
        ui.label(RichText::new(element_name(kind, id)).heading());
        if count > 1 {
            let more = format!("and {} more", crate::lists::columns::thousands(count - 1));
            ui.label(RichText::new(more).weak()).on_hover_text(fields::selection_words(kind, count, latest));
        }
    });
    ui.add_space(2.0);
    match kind {
        Element::Vertex => vertex::show(ui, page, id, out),
        Element::Edge => edge::show(ui, page, id, own, out),
        Element::Halfedge => halfedge::show(ui, page, id, own, out),
        Element::Face => face::show(ui, page, id, out),
    }
    ui.add_space(6.0);
    edit_buttons(ui, page, kind, out);
}

fn empty_inspector(ui: &mut Ui, page: &Page<'_>) {
    ui.label(RichText::new("Inspector").heading());
    let hint = if page.editor.document().objects().is_empty() {
        "Drop an OBJ file on the page, press Ctrl+O, or make a shape below."
    } else {
        "Nothing is selected. Click an element in the viewport or in a list to see and edit its numbers."
    };
    ui.add(Label::new(RichText::new(hint).weak()).wrap());
}

/// One button for each operation that works on this kind, greyed with the reason where this
/// element is none it works on.
fn edit_buttons(ui: &mut Ui, page: &Page<'_>, kind: Element, out: &mut Requests) {
    let ids: Vec<OpId> = actions::mesh_operations()
        .filter(|id| id.spec().applies_to(kind) && !SHOWN_ALREADY.contains(id))
        .collect();
    if ids.is_empty() {
        return;
    }
    ui.horizontal_wrapped(|ui| {
        for id in ids {
            let action = Action::Operation(id);
            let why_not = page.why_not(action);
            let label = id.spec().label;
            let label = if opens_form(id) { format!("{label}…") } else { label.to_owned() };
            let button = ui.add_enabled(why_not.is_none(), Button::new(label));
            if explain(button, ui, &actions::of_operation(id), why_not.as_deref()).clicked() {
                out.act(action);
            }
        }
    });
}

/// A name and a value in the inspector's table.
fn fact(ui: &mut Ui, name: &str, value: impl Into<String>, meaning: &str) {
    ui.label(RichText::new(name).weak()).on_hover_text(meaning);
    ui.add(Label::new(RichText::new(value).monospace()).selectable(true));
    ui.end_row();
}

/// A name and a link that selects what it points to.
fn pointer(
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

/// A link that selects an element; the viewport shows it while the pointer is over the link.
fn link(ui: &mut Ui, out: &mut Requests, name: &str, kind: Element, id: u32) {
    let text = element_name(kind, id);
    let link = ui.link(&text).on_hover_text(format!("Select {}", text.to_lowercase()));
    link.clone().accessible_name(format!("{name}: {text}"));
    if link.hovered() {
        out.push(Request::Hover(kind, id));
    }
    if link.clicked() {
        out.select(kind, [id], SelectMode::Replace);
    }
}

/// Links to several elements, in lines as wide as the panel.
fn links(ui: &mut Ui, out: &mut Requests, name: &str, kind: Element, ids: &[u32]) {
    /// More would push everything else off the panel.
    const MOST: usize = 24;
    ui.label(RichText::new(format!("{name} ({})", ids.len())).weak());
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(6.0, 2.0);
        for &id in ids.iter().take(MOST) {
            let link = ui.link(RichText::new(id.to_string()).monospace());
            link.clone().accessible_name(element_name(kind, id));
            if link.hovered() {
                out.push(Request::Hover(kind, id));
            }
            if link.on_hover_text(format!("Select {kind} {id}")).clicked() {
                out.select(kind, [id], SelectMode::Replace);
            }
        }
        if ids.len() > MOST {
            ui.label(RichText::new("…").weak());
        }
    });
}

/// The table of the inspector.
fn facts(ui: &mut Ui, name: &str, add: impl FnOnce(&mut Ui)) {
    let row = if ui.spacing().interact_size.y < TOUCH_TARGET { 18.0 } else { 28.0 };
    Grid::new(name)
        .num_columns(2)
        .spacing(vec2(14.0, 4.0))
        .min_col_width(76.0)
        .min_row_height(row)
        .show(ui, add);
}

/// A measured number with as many digits as are worth reading.
fn measured(value: f32) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-4..1e7).contains(&size) { format!("{value:.5e}") } else { format!("{value:.6}") }
}
