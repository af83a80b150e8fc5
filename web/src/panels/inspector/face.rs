//! A face: its corners, area, normal and colour.

use super::{facts, measured};
use crate::app::App;
use crate::panels::color_button::color_button;
use editor::ops::SetFaceColor;
use egui::{RichText, Ui};
use glam::Vec3;
use halfedge::geometry::face_area_vector;
use halfedge::{Color, Element, HalfedgeId, keys};

impl App {
    pub(super) fn inspect_face(&mut self, ui: &mut Ui, id: u32) {
        let Some((mesh, f)) = self.editor.mesh().and_then(|mesh| Some((mesh, mesh.face(id)?))) else {
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

        self.face_color(ui, color);
        facts(ui, "face facts", |ui| {
            self.fact(
                ui,
                "Area",
                measured(area.length() as f32),
                "The area of the polygon, in square mesh units",
            );
            self.fact(ui, "Normal", direction(normal), "The direction the face looks in");
            self.fact(ui, "Corners", corners.len().to_string(), "How many corners the face has");
            let meaning = "The face's first half-edge, which leaves its first corner";
            self.pointer(ui, "Half-edge", Some((Element::Halfedge, first)), "", meaning);
            if let Some(group) = group {
                self.fact(ui, "Group", group, "The group or object name in the file");
            }
            if let Some(material) = material {
                self.fact(ui, "Material", material, "The material in the file");
            }
        });
        self.links(ui, "Vertices", Element::Vertex, &corners);
        self.links(ui, "Half-edges", Element::Halfedge, &sides);
    }

    /// The colour of all selected faces. Picking is a preview until the button is let go.
    fn face_color(&mut self, ui: &mut Ui, color: Color) {
        ui.horizontal(|ui| {
            ui.label(RichText::new("Colour").weak());
            let mut rgb = color.0;
            let (button, changed) = color_button(ui, "Face colour", &mut rgb);
            if changed {
                self.preview(SetFaceColor { faces: None, color: Color(rgb).to_hex() });
                self.forms.painting = true;
            }
            let many = self.editor.selection().len() > 1;
            button.on_hover_text(if many { "Paint all selected faces" } else { "Paint the face" });
            ui.label(RichText::new(color.to_hex()).monospace().weak());
        });
    }
}

fn direction(normal: Vec3) -> String {
    let [x, y, z] = normal.to_array().map(|c| if c == 0.0 { 0.0 } else { c });
    format!("{x:.3} {y:.3} {z:.3}")
}
