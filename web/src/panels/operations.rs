//! The operations panel: choose one, fill in its fields, apply it.

use std::collections::HashMap;

use editor::ops::Connect;
use editor::{Facts, OpId, Scope};
use egui::{Button, ComboBox, Grid, RichText, Ui, vec2};
use serde_json::Value;

use crate::actions::{self, Action};
use crate::app::App;
use crate::keys;
use crate::panels::estimate::Tried;
use crate::panels::fields::{self, Filled};
use crate::panels::trial::Previews;

/// What is filled in, in all forms of the page.
#[derive(Default)]
pub(crate) struct Forms {
    chosen: Option<OpId>,
    filled: HashMap<OpId, Filled>,
    /// The object whose name is being typed.
    pub renaming: Option<(usize, String)>,
    pub focus_renaming: bool,
    /// A face colour is being picked, as a preview.
    pub painting: bool,
    /// Where along an edge the inspector's split button puts the vertex.
    pub split_t: Option<f32>,
    pub split_connect: Option<Connect>,
    /// How many quads lie along a side of each patch that the Bezier panel tessellates.
    pub tessellation: Option<u32>,
    /// What an operation that was tried out makes.
    pub tried: Option<Tried>,
    pub previews: Previews,
}

impl Forms {
    /// Shows an operation's form.
    pub fn choose(&mut self, id: OpId) {
        self.chosen = Some(id);
        self.previews.ask();
    }

    /// What is filled in for an operation, once its form was shown or a key changed it.
    pub fn filled(&self, id: OpId) -> Option<&Filled> {
        self.filled.get(&id)
    }

    /// Fills in one field.
    pub fn fill(&mut self, id: OpId, facts: &Facts, field: &str, value: Value) {
        let filled = self.filled.entry(id).or_insert_with(|| fields::initial(id.spec(), facts));
        filled.insert(field.to_owned(), value);
    }

    /// Leaves out again what was filled in for one mesh and means nothing for another.
    pub fn forget_lengths(&mut self) {
        self.filled.retain(|id, _| !fields::needs_measures(id.spec()));
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
        let id = self.forms.chosen.unwrap_or(OpId::New);
        let chosen = id.spec();
        let combo = ComboBox::from_id_salt("operation")
            .selected_text(chosen.label)
            .width(ui.available_width() - 8.0)
            .height(420.0);
        let combo = combo.show_ui(ui, |ui| {
            // Whole-mesh operations first: they are what people fill in forms for.
            let of_scope =
                |scope| actions::mesh_operations().filter(move |other| other.spec().scope == scope);
            for other in of_scope(Scope::Meshes).chain(of_scope(Scope::Elements)) {
                let spec = other.spec();
                if ui.selectable_label(other == id, spec.label).on_hover_text(spec.description).clicked() {
                    self.forms.choose(other);
                }
            }
        });
        combo.response.accessible_name("Operation").on_hover_text("Which operation to fill in and apply");
        ui.add(egui::Label::new(RichText::new(chosen.description).weak()).wrap());

        let facts = self.facts(id);
        let mut filled = self.forms.filled.remove(&id).unwrap_or_else(|| fields::initial(chosen, &facts));
        let before = filled.clone();
        Grid::new(("form", chosen.name)).num_columns(2).spacing(vec2(10.0, 6.0)).show(ui, |ui| {
            fields::rows(ui, chosen, &mut filled, &facts, |_| true);
        });
        self.preview_row(ui, id, &filled, filled != before);
        if let Some(estimate) = self.estimate(id, &filled, &facts) {
            ui.label(RichText::new(estimate).small().weak());
        }
        self.apply_button(ui, id, &filled);
        self.forms.filled.insert(id, filled);
    }

    fn apply_button(&mut self, ui: &mut Ui, id: OpId, filled: &Filled) {
        let (spec, action) = (id.spec(), Action::Operation(id));
        let why_not = self.why_not(action);
        let primary = ui.visuals().selection;
        let text = RichText::new(spec.label).color(primary.stroke.color);
        let button = Button::new(text).fill(primary.bg_fill).min_size(vec2(ui.available_width(), 28.0));
        let response = ui.vertical_centered_justified(|ui| ui.add_enabled(why_not.is_none(), button)).inner;
        let tooltip = keys::tooltip(ui.ctx(), spec.description, action);
        let reason = why_not.clone().unwrap_or_default();
        if response.on_hover_text(tooltip).on_disabled_hover_text(reason).clicked()
            && !self.apply_preview(id, filled)
        {
            match fields::command(id, filled) {
                Ok(command) => self.begin(command, None),
                Err(error) => self.refused(&error, None),
            }
        }
        if let Some(reason) = why_not {
            ui.add(egui::Label::new(RichText::new(reason).small().color(ui.visuals().warn_fg_color)).wrap());
        }
    }

    /// The facts that an operation's form needs, about the mesh without what is only previewed.
    pub(crate) fn facts(&mut self, id: OpId) -> Facts {
        let measures = fields::needs_measures(id.spec());
        self.facts_before_preview()
            .unwrap_or_else(|| self.measured.facts(&self.editor, &self.survey, measures))
    }

    /// All facts about the mesh without what is only previewed.
    pub(crate) fn measured_facts(&mut self) -> Facts {
        self.facts_before_preview().unwrap_or_else(|| self.measured.facts(&self.editor, &self.survey, true))
    }
}
