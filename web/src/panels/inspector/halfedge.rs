//! A half-edge: all its pointers as links.

use super::{facts, measured};
use crate::actions::{self, Action};
use crate::app::App;
use crate::panels::menu_bar::explain;
use egui::{Button, Ui};
use halfedge::Element;

impl App {
    pub(super) fn inspect_halfedge(&mut self, ui: &mut Ui, id: u32) {
        let Some((mesh, h)) = self.editor.mesh().and_then(|mesh| Some((mesh, mesh.halfedge(id)?))) else {
            return;
        };
        let (next, prev, twin) = (mesh.next(h).raw(), mesh.prev(h).raw(), h.twin().raw());
        let (from, to, edge) = (mesh.from(h), mesh.to(h), h.edge().raw());
        let face = mesh.face_of(h).map(|f| (Element::Face, f.raw()));
        let length = mesh.position(from).distance(mesh.position(to));
        facts(ui, "half-edge facts", |ui| {
            let half = |id| Some((Element::Halfedge, id));
            let vertex = |id| Some((Element::Vertex, id));
            self.pointer(
                ui,
                "Next",
                half(next),
                "",
                "The next half-edge around the face, or along the boundary",
            );
            self.pointer(ui, "Previous", half(prev), "", "The half-edge before it");
            self.pointer(ui, "Twin", half(twin), "", "The other side of the same edge, the other way");
            self.pointer(ui, "Vertex", vertex(to.raw()), "", "The vertex it points to");
            self.pointer(ui, "From", vertex(from.raw()), "", "The vertex it leaves");
            self.pointer(ui, "Edge", Some((Element::Edge, edge)), "", "The edge it is a side of");
            self.pointer(ui, "Face", face, "none (boundary)", "The face to its left");
            self.fact(ui, "Length", measured(length), "The length of its edge");
        });
        ui.add_space(4.0);
        ui.horizontal(|ui| {
            for action in [Action::Next, Action::Twin] {
                let entry = actions::describe(action);
                let why_not = self.why_not(action);
                let button = ui.add_enabled(why_not.is_none(), Button::new(entry.label));
                if explain(button, ui, &entry, why_not.as_deref()).clicked() {
                    self.act(action);
                }
            }
        });
        self.split_form(ui);
    }
}
