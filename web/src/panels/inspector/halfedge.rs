//! The inspector of a half-edge, with links for all its pointers.

use super::table::InspectorState;
use super::table::{fact, facts, measured, pointer};
use crate::input::actions::{self, Action};
use crate::page_view::Page;
use crate::panels::menu_bar::explain;
use crate::request::Requests;
use egui::{Button, Ui};
use halfedge::Element;

pub(super) fn show(ui: &mut Ui, page: &Page<'_>, id: u32, own: &mut InspectorState, out: &mut Requests) {
    let Some((mesh, h)) = page.editor.mesh().and_then(|mesh| Some((mesh, mesh.halfedge(id)?))) else {
        return;
    };
    let (next, prev, twin) = (mesh.next(h).raw(), mesh.prev(h).raw(), h.twin().raw());
    let (from, to, edge) = (mesh.from(h), mesh.to(h), h.edge().raw());
    let face = mesh.face_of(h).map(|f| (Element::Face, f.raw()));
    let length = mesh.position(from).distance(mesh.position(to));
    facts(ui, "half-edge facts", |ui| {
        let half = |id| Some((Element::Halfedge, id));
        let vertex = |id| Some((Element::Vertex, id));
        pointer(ui, out, "Next", half(next), "", "The next half-edge around the face, or along the boundary");
        pointer(
            ui,
            out,
            "Previous",
            half(prev),
            "",
            "The previous one around the face, or along the boundary",
        );
        pointer(ui, out, "Twin", half(twin), "", "The opposite half-edge of the same edge");
        pointer(ui, out, "Vertex", vertex(to.raw()), "", "The vertex it points to");
        pointer(ui, out, "From", vertex(from.raw()), "", "The vertex it leaves");
        pointer(ui, out, "Edge", Some((Element::Edge, edge)), "", "The edge that it belongs to");
        pointer(ui, out, "Face", face, "none (boundary)", "The face to its left");
        fact(ui, "Length", measured(length), "The length of its edge");
    });
    ui.add_space(4.0);
    ui.horizontal(|ui| {
        for action in [Action::Next, Action::Twin] {
            let entry = actions::describe(action);
            let why_not = page.why_not(action);
            let button = ui.add_enabled(why_not.is_none(), Button::new(entry.label));
            if explain(button, ui, &entry, why_not.as_deref()).clicked() {
                out.act(action);
            }
        }
    });
    super::edge::split_form(ui, page, own, out);
}
