//! The operations panel: choose one, fill in its fields, apply it.

use std::collections::HashMap;

use editor::{OperationKind, Spec};
use egui::{Button, ComboBox, Grid, RichText, Ui, vec2};
use serde_json::{Map, Value};

use crate::actions::{self, Action};
use crate::app::App;
use crate::keys;
use crate::panels::estimate::Tried;
use crate::panels::fields::{self, Filled, Hints};
use crate::panels::new_shape;
use crate::panels::trial::Previews;

/// What is filled in, in all forms of the page.
#[derive(Default)]
pub(crate) struct Forms {
    chosen: Option<&'static str>,
    filled: HashMap<&'static str, Filled>,
    /// The object whose name is being typed.
    pub renaming: Option<(usize, String)>,
    pub focus_renaming: bool,
    /// A face colour is being picked, as a preview.
    pub painting: bool,
    /// Where along an edge the inspector's split button puts the vertex.
    pub split_t: Option<f32>,
    pub split_connect: Option<&'static str>,
    /// How many quads lie along a side of each patch that the Bezier panel tessellates.
    pub tessellation: Option<u32>,
    /// What an operation that was tried out makes.
    pub tried: Option<Tried>,
    pub previews: Previews,
}

impl Forms {
    /// Shows an operation's form.
    pub fn choose(&mut self, name: &'static str) {
        self.chosen = Some(name);
        self.previews.ask();
    }

    /// What is filled in for an operation, once its form was shown or a key changed it.
    pub fn filled(&self, name: &str) -> Option<&Filled> {
        self.filled.get(name)
    }

    /// Fills in one field.
    pub fn fill(&mut self, spec: &'static Spec, hints: &Hints, field: &str, value: Value) {
        let filled = self.filled.entry(spec.name).or_insert_with(|| fields::initial(spec, hints));
        filled.insert(field.to_owned(), value);
    }

    /// Leaves out again what was filled in for one mesh and means nothing for another.
    pub fn forget_lengths(&mut self) {
        self.filled.retain(|op, _| !fields::suggests_lengths(op));
    }
}

impl App {
    /// The panel on the right: the inspector, and the operations below it.
    pub(crate) fn right_panel(&mut self, ui: &mut Ui) {
        egui::ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
            self.inspector(ui);
            ui.add_space(6.0);
            ui.separator();
            self.operations(ui);
        });
    }

    pub(crate) fn operations(&mut self, ui: &mut Ui) {
        self.adjust_panel(ui);
        ui.add_space(2.0);
        ui.label(RichText::new("Operations").strong());
        let Some(chosen) = self.forms.chosen.and_then(actions::operation).or_else(first_operation) else {
            return;
        };
        let combo = ComboBox::from_id_salt("operation")
            .selected_text(chosen.label)
            .width(ui.available_width() - 8.0)
            .height(420.0);
        let combo = combo.show_ui(ui, |ui| {
            // Whole-mesh operations first: they are what people fill in forms for.
            let of_kind = |kind| actions::mesh_operations().filter(move |spec| spec.kind == kind);
            for spec in of_kind(OperationKind::WholeMesh).chain(of_kind(OperationKind::Local)) {
                if ui
                    .selectable_label(spec.name == chosen.name, spec.label)
                    .on_hover_text(spec.description)
                    .clicked()
                {
                    self.forms.choose(spec.name);
                }
            }
        });
        combo.response.accessible_name("Operation").on_hover_text("Which operation to fill in and apply");
        ui.add(egui::Label::new(RichText::new(chosen.description).weak()).wrap());

        let hints = self.hints(chosen.name);
        let mut filled =
            self.forms.filled.remove(chosen.name).unwrap_or_else(|| fields::initial(chosen, &hints));
        let before = filled.clone();
        Grid::new(("form", chosen.name)).num_columns(2).spacing(vec2(10.0, 6.0)).show(ui, |ui| {
            if chosen.name == "new" {
                new_shape::form(ui, &mut filled);
                return;
            }
            fields::rows(ui, chosen, &mut filled, &hints, |_| true);
        });
        self.preview_row(ui, chosen, &filled, filled != before);
        if let Some(estimate) = self.estimate(chosen.name, &filled, &hints) {
            ui.label(RichText::new(estimate).small().weak());
        }
        self.apply_button(ui, chosen, &filled);
        self.forms.filled.insert(chosen.name, filled);
    }

    fn apply_button(&mut self, ui: &mut Ui, spec: &'static Spec, filled: &Filled) {
        let action = Action::Operation(spec.name);
        let why_not = self.why_not(action);
        let primary = ui.visuals().selection;
        let text = RichText::new(spec.label).color(primary.stroke.color);
        let button = Button::new(text).fill(primary.bg_fill).min_size(vec2(ui.available_width(), 28.0));
        let response = ui.vertical_centered_justified(|ui| ui.add_enabled(why_not.is_none(), button)).inner;
        let tooltip = keys::tooltip(ui.ctx(), spec.description, action);
        let reason = why_not.clone().unwrap_or_default();
        if response.on_hover_text(tooltip).on_disabled_hover_text(reason).clicked()
            && !self.apply_preview(spec.name, filled)
        {
            let mut command: Map<String, Value> = filled.clone();
            command.insert("op".into(), spec.name.into());
            self.send(command.into());
        }
        if let Some(reason) = why_not {
            ui.add(egui::Label::new(RichText::new(reason).small().color(ui.visuals().warn_fg_color)).wrap());
        }
    }

    /// What an operation's form should know of the mesh, as it is without what is only previewed.
    pub(crate) fn hints(&mut self, op: &str) -> Hints {
        if let Some(hints) = self.hints_before_preview() {
            return hints;
        }
        let measures = if fields::suggests_lengths(op) { self.measured.get(&self.editor) } else { None };
        let Some(mesh) = self.editor.mesh() else { return Hints::default() };
        let boundary = self.survey.found().map(|found| found.boundary_halfedges);
        Hints {
            measures,
            vertices: mesh.vertex_count(),
            faces: mesh.face_count(),
            corners: boundary.map(|boundary| mesh.halfedge_count() - boundary),
        }
    }
}

fn first_operation() -> Option<&'static Spec> {
    let mut whole = actions::mesh_operations().filter(|spec| spec.kind == OperationKind::WholeMesh);
    actions::operation("new").or_else(|| whole.next()).or_else(|| actions::mesh_operations().next())
}
