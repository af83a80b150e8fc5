//! The inspector of a face: its corners, area, normal and colour.

use super::table::{fact, facts, links, measured, pointer};
use crate::page_view::Page;
use crate::request::{Request, Requests};
use crate::widgets::color_button::color_button;
use editor::ops::SetFaceColor;
use egui::{RichText, Ui};
use glam::Vec3;
use halfedge::geometry::face_area_vector;
use halfedge::{Color, Element, HalfedgeId, keys};

pub(super) fn show(ui: &mut Ui, page: &Page<'_>, id: u32, out: &mut Requests) {
    let Some((mesh, f)) = page.editor.mesh().and_then(|mesh| Some((mesh, mesh.face(id)?))) else {
        return;
    };
    let first = mesh.halfedge_of(f).raw();
    let corners: Vec<u32> = mesh.face_vertices(f).map(|v| v.raw()).collect();
    let sides: Vec<u32> = mesh.face_halfedges(f).map(HalfedgeId::raw).collect();
    let area = face_area_vector(mesh, f);
    let normal = area.normalize_or_zero().as_vec3();
    let color = mesh.get(keys::FACE_COLOR, f.index());
    let label = |key, name| {
        let at = mesh.get(key, f.index()) as usize;
        mesh.column(Element::Face, name).and_then(|column| column.labels.get(at)).cloned()
    };
    let group = label(keys::FACE_GROUP, keys::FACE_GROUP.name);
    let material = label(keys::FACE_MATERIAL, keys::FACE_MATERIAL.name);

    face_color(ui, page, color, out);
    facts(ui, "face facts", |ui| {
        fact(ui, "Area", measured(area.length() as f32), "The area of the polygon, in square mesh units");
        fact(ui, "Normal", direction(normal), "The direction the face points in");
        fact(ui, "Corners", corners.len().to_string(), "The number of the face's corners");
        let meaning = "The face's first half-edge, which leaves its first corner";
        pointer(ui, out, "Half-edge", Some((Element::Halfedge, first)), "", meaning);
        if let Some(group) = group {
            fact(ui, "Group", group, "The group or object name in the file");
        }
        if let Some(material) = material {
            fact(ui, "Material", material, "The material in the file");
        }
    });
    links(ui, out, "Vertices", Element::Vertex, &corners);
    links(ui, out, "Half-edges", Element::Halfedge, &sides);
}

/// The colour of all selected faces. Picking shows a preview until the button is released.
fn face_color(ui: &mut Ui, page: &Page<'_>, color: Color, out: &mut Requests) {
    ui.horizontal(|ui| {
        ui.label(RichText::new("Colour").weak());
        let mut rgb = color.0;
        let (button, changed) = color_button(ui, "Face colour", &mut rgb);
        if changed {
            out.update_edit(SetFaceColor { faces: None, color: Color(rgb).to_hex() });
            out.push(Request::CommitEditOnRelease);
        }
        let many = page.editor.selection().len() > 1;
        button.on_hover_text(if many { "Paint all selected faces" } else { "Paint the face" });
        ui.label(RichText::new(color.to_hex()).monospace().weak());
    });
}

fn direction(normal: Vec3) -> String {
    let [x, y, z] = normal.to_array().map(|c| if c == 0.0 { 0.0 } else { c });
    format!("{x:.3} {y:.3} {z:.3}")
}
