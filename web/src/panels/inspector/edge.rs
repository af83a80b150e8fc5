//! The inspector of an edge: its ends, length and faces, and where to split it.

use super::table::InspectorState;
use super::table::{fact, facts, measured, pointer};
use crate::input::actions::{self, Action};
use crate::page_view::Page;
use crate::panels::menu_bar::explain;
use crate::request::Requests;
use editor::OpId;
use editor::ops::{Connect, SplitEdge};
use egui::{ComboBox, Slider, Ui};
use halfedge::{Element, HalfedgeId, keys};

pub(super) fn show(ui: &mut Ui, page: &Page<'_>, id: u32, own: &mut InspectorState, out: &mut Requests) {
    let Some((mesh, e)) = page.editor.mesh().and_then(|mesh| Some((mesh, mesh.edge(id)?))) else {
        return;
    };
    let [a, b] = mesh.ends(e);
    let length = mesh.position(a).distance(mesh.position(b));
    let sides = e.halfedges().map(HalfedgeId::raw);
    let faces = e.halfedges().map(|h| mesh.face_of(h).map(|f| (Element::Face, f.raw())));
    let boundary = mesh.is_boundary_edge(e);
    let crease = mesh.get(keys::EDGE_CREASE, e.index());
    facts(ui, "edge facts", |ui| {
        pointer(
            ui,
            out,
            "From",
            Some((Element::Vertex, a.raw())),
            "",
            "Where the edge's first half-edge starts",
        );
        pointer(ui, out, "To", Some((Element::Vertex, b.raw())), "", "Where the edge's first half-edge ends");
        fact(ui, "Length", measured(length), "The distance between the edge's ends");
        for (name, side) in ["Half-edge", "Twin"].into_iter().zip(sides) {
            pointer(
                ui,
                out,
                name,
                Some((Element::Halfedge, side)),
                "",
                "One of the edge's two directed sides",
            );
        }
        for (name, face) in ["Left face", "Right face"].into_iter().zip(faces) {
            pointer(ui, out, name, face, "boundary", "The face on this side of the edge");
        }
        fact(ui, "Boundary", if boundary { "yes" } else { "no" }, "Whether one side of the edge has no face");
        if crease > 0.0 {
            fact(ui, "Crease", measured(crease), "The sharpness in subdivision; 10 is fully sharp");
        }
    });
    split_form(ui, page, own, out);
}

/// The form for splitting all selected edges: where, and how to cut the faces.
pub(super) fn split_form(ui: &mut Ui, page: &Page<'_>, own: &mut InspectorState, out: &mut Requests) {
    let id = OpId::SplitEdge;
    let action = Action::Operation(id);
    ui.add_space(6.0);
    let mut t = own.t.unwrap_or(0.5);
    let mut connect = own.connect.unwrap_or_default();
    ui.horizontal(|ui| {
        ui.spacing_mut().slider_width = (ui.available_width() - 124.0).max(60.0);
        let label = ui.label("Split at");
        let slider = Slider::new(&mut t, 0.01..=0.99).max_decimals(3);
        ui.add(slider)
            .labelled_by(label.id)
            .on_hover_text("The position of the new vertex, as a fraction of the edge's length");
    });
    let why_not = page.why_not(action);
    ui.horizontal(|ui| {
        let combo =
            ComboBox::from_id_salt("connect").selected_text(connect.label()).width(140.0).show_ui(ui, |ui| {
                for other in Connect::ALL {
                    if ui.selectable_label(connect == *other, other.label()).clicked() {
                        connect = *other;
                    }
                }
            });
        combo
            .response
            .accessible_name("Cut")
            .on_hover_text("The faces beside the edge to cut from the new vertex");
        let button = ui.add_enabled(why_not.is_none(), egui::Button::new(id.spec().label));
        if explain(button, ui, &actions::of_operation(id), why_not.as_deref()).clicked() {
            out.run(SplitEdge::at(t, connect));
        }
    });
    own.t = Some(t);
    own.connect = Some(connect);
}
