//! The inspector: the properties of the element that was selected last, or of the document if nothing is selected.

mod edge;
mod face;
mod halfedge;
mod table;
mod vertex;

pub(crate) use table::InspectorState;

use ::halfedge::Element;
use egui::{RichText, Ui};

use crate::lists::columns::element_name;
use crate::page_view::Page;
use crate::panels::bezier as bezier_panel;
use crate::panels::{document, fields};
use crate::request::Requests;

pub(crate) fn show(ui: &mut Ui, page: &Page<'_>, own: &mut InspectorState, out: &mut Requests) {
    bezier_panel::show(ui, page, &mut own.tessellation, out);
    let selection = page.editor.selection();
    let (kind, count) = (selection.kind(), selection.len());
    let latest = selection.latest();
    let Some(id) = latest else {
        if crate::bezier::active(&page.editor).is_none() {
            document::show(ui, page, out);
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
}
