//! A vertex: its position in spin boxes, its half-edge, its neighbours.

use super::facts;
use crate::app::App;
use crate::theme;
use editor::ops::{SetVertexPosition, VertexRef};
use egui::{DragValue, RichText, Ui, vec2};
use halfedge::{Element, HalfedgeId};

impl App {
    pub(super) fn inspect_vertex(&mut self, ui: &mut Ui, id: u32) {
        let Some((mesh, v)) = self.editor.mesh().and_then(|mesh| Some((mesh, mesh.vertex(id)?))) else {
            return;
        };
        let position = mesh.position(v).to_array();
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

        let offset = self.editor.document().offset();
        self.position_boxes(ui, id, position);
        facts(ui, "vertex facts", |ui| {
            if offset != glam::DVec3::ZERO {
                let place = offset.to_array().map(|x| x.to_string()).join(", ");
                self.fact(
                    ui,
                    "Counted from",
                    place,
                    "The file lies far from the origin: coordinates are shown, and given to commands, from this \
                     place, and saved in full",
                );
            }
            self.pointer(
                ui,
                "Half-edge",
                halfedge,
                "none",
                "A half-edge that leaves the vertex, a boundary one if there is one",
            );
            self.fact(ui, "Valence", valence.to_string(), "How many edges the vertex has");
            self.fact(ui, "Boundary", boundary, "Whether the vertex is on a boundary loop");
        });
        self.links(ui, "Outgoing half-edges", Element::Halfedge, &outgoing);
        self.links(ui, "Neighbours", Element::Vertex, &neighbors);
        self.links(ui, "Faces", Element::Face, &faces);
    }

    /// x, y and z. A drag or a typed number is one undo step.
    fn position_boxes(&mut self, ui: &mut Ui, id: u32, position: [f32; 3]) {
        let speed = self.view.drag_speed();
        let mut moved = position;
        let (mut changed, mut done) = (false, false);
        let width = (ui.available_width() - 2.0 * ui.spacing().item_spacing.x - 3.0 * 16.0) / 3.0;
        ui.horizontal(|ui| {
            let colors = theme::palette(ui.visuals()).axes;
            for ((axis, value), color) in ["x", "y", "z"].into_iter().zip(&mut moved).zip(colors) {
                ui.spacing_mut().item_spacing.x = 4.0;
                ui.label(RichText::new(axis).strong().color(color));
                let drag = DragValue::new(value)
                    .speed(speed)
                    .range(f32::MIN..=f32::MAX)
                    .max_decimals(6)
                    .update_while_editing(false);
                let spin = ui.add_sized(vec2(width.max(40.0), ui.spacing().interact_size.y), drag);
                let spin = spin.accessible_name(format!("Position {axis}"));
                changed |= spin.changed();
                // Typed numbers, and steps of assistive tools, are whole edits of their own.
                done |= spin.drag_stopped() || (spin.changed() && !spin.dragged());
                spin.on_hover_text(format!("Position along {axis}: drag, or click to type"));
            }
        });
        if changed && moved.iter().all(|value| value.is_finite()) {
            self.preview(SetVertexPosition { vertex: Some(VertexRef(id)), position: moved });
        }
        if done {
            self.commit_preview();
        }
    }
}
