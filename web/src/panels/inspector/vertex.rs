//! The inspector of a vertex: its position in spin boxes, its half-edge and its neighbours.

use super::table::{fact, facts, links, pointer};
use crate::page_view::Page;
use crate::request::{Request, Requests};
use crate::theme;
use crate::units::Measure;
use crate::widgets::number_box::number_box;
use editor::ops::{SetVertexPosition, VertexRef};
use egui::{RichText, Ui, vec2};
use glam::{DVec3, Vec3};
use halfedge::{Element, HalfedgeId};

pub(super) fn show(ui: &mut Ui, page: &Page<'_>, id: u32, out: &mut Requests) {
    let Some((mesh, v)) = page.editor.mesh().and_then(|mesh| Some((mesh, mesh.vertex(id)?))) else {
        return;
    };
    let offset = page.editor.document().offset();
    let position = mesh.position(v);
    let halfedge = mesh.halfedge_from(v).map(|h| (Element::Halfedge, h.raw()));
    let valence = mesh.valence(v);
    let boundary = match (halfedge, mesh.is_boundary_vertex(v)) {
        (None, _) => "isolated",
        (_, true) => "yes",
        _ => "no",
    };
    let outgoing: Vec<u32> = mesh.outgoing(v).map(HalfedgeId::raw).collect();
    let neighbors: Vec<u32> = mesh.neighbors(v).map(|w| w.raw()).collect();
    let faces: Vec<u32> = mesh.vertex_faces(v).map(|f| f.raw()).collect();

    position_boxes(ui, page, id, position, out);
    facts(ui, "vertex facts", |ui| {
        if offset != DVec3::ZERO {
            let place = offset.to_array().map(|x| x.to_string()).join(", ");
            fact(
                ui,
                "Offset",
                place,
                "The model lies far from the origin. Coordinates are those of the file; commands count them from \
                 this place",
            );
        }
        pointer(
            ui,
            out,
            "Half-edge",
            halfedge,
            "none",
            "A half-edge that leaves the vertex, a boundary one if there is one",
        );
        fact(ui, "Valence", valence.to_string(), "The number of the vertex's edges");
        fact(ui, "Boundary", boundary, "Whether the vertex is on a boundary loop");
    });
    links(ui, out, "Outgoing half-edges", Element::Halfedge, &outgoing);
    links(ui, out, "Neighbours", Element::Vertex, &neighbors);
    links(ui, out, "Faces", Element::Face, &faces);
}

/// The spin boxes for x, y and z as in the file. A drag or a typed number is one undo step.
fn position_boxes(ui: &mut Ui, page: &Page<'_>, id: u32, position: Vec3, out: &mut Requests) {
    let speed = page.view.drag_speed();
    let offset = page.editor.document().offset();
    let mut moved = (position.as_dvec3() + offset).to_array();
    let (mut changed, mut done) = (false, false);
    let width = (ui.available_width() - 2.0 * ui.spacing().item_spacing.x - 3.0 * 16.0) / 3.0;
    ui.horizontal(|ui| {
        let colors = theme::palette(ui.visuals()).axes;
        for ((axis, value), color) in ["x", "y", "z"].into_iter().zip(&mut moved).zip(colors) {
            ui.spacing_mut().item_spacing.x = 4.0;
            ui.label(RichText::new(axis).strong().color(color));
            let drag = number_box(ui, value, Measure::Length)
                .speed(speed)
                .range(f64::from(f32::MIN)..=f64::from(f32::MAX))
                .max_decimals(6);
            let spin = ui.add_sized(vec2(width.max(40.0), ui.spacing().interact_size.y), drag);
            let spin = spin.accessible_name(format!("Position {axis}"));
            changed |= spin.changed();
            // A typed number, or a step by an assistive tool, is an edit of its own.
            done |= spin.drag_stopped() || (spin.changed() && !spin.dragged());
            spin.on_hover_text(format!("Position along {axis}: drag, or click to type"));
        }
    });
    let to = (DVec3::from(moved) - offset).as_vec3();
    if changed && to.is_finite() {
        out.update_edit(SetVertexPosition { vertex: Some(VertexRef(id)), position: to.to_array() });
    }
    if done {
        out.push(Request::CommitEdit);
    }
}
