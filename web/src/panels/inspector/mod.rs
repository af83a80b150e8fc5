//! The inspector: the properties of the selected element, and the operations on it.

mod edge;
mod face;
mod halfedge;
mod table;
mod vertex;

pub(crate) use table::InspectorState;

use ::halfedge::Element;
use editor::OpId;
use egui::{Button, Label, RichText, Ui};

use crate::input::actions::{self, Action};
use crate::input::availability::opens_form;
use crate::lists::columns::element_name;
use crate::page_view::Page;
use crate::panels::bezier as bezier_panel;
use crate::panels::fields;
use crate::panels::menu_bar::explain;
use crate::request::Requests;

/// Operations that have their own controls higher up in the inspector.
const SHOWN_ALREADY: [OpId; 3] = [OpId::SetVertexPosition, OpId::SetFaceColor, OpId::SplitEdge];

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
            let more = format!("and {} more", ::halfedge::words::thousands(count - 1));
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

/// A button for each operation on this kind of element. If the operation doesn't work on this element, the
/// button is greyed with the reason.
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
