//! The operations panel: choose an operation, fill in its fields, apply it.

use std::collections::HashMap;

use editor::{Facts, OpId, Scope};
use egui::{ComboBox, Grid, RichText, Ui, vec2};
use serde_json::Value;

use crate::input::actions::{self, Action};
use crate::input::keys;
use crate::page_view::Page;
use crate::panels::adjust::{self, Adjusting};
use crate::panels::estimate::{self, Tried};
use crate::panels::fields;
use crate::panels::preview::{self, Previews};
use crate::request::{Request, Requests};
use crate::session::form::{self, Filled};
use crate::widgets::controls::primary_button;

/// The field of remeshing that the keys for the target edge length change.
pub(crate) const EDGE_LENGTH: &str = "edge_length";

/// The values of all forms on the page.
#[derive(Default)]
pub(crate) struct Forms {
    chosen: Option<OpId>,
    filled: HashMap<OpId, Filled>,
    /// The result of a trial run.
    pub tried: Option<Tried>,
    pub previews: Previews,
    adjusting: Adjusting,
}

impl Forms {
    /// Shows an operation's form.
    pub fn choose(&mut self, id: OpId) {
        self.chosen = Some(id);
        self.previews.ask();
    }

    /// The values of an operation's form, once the form was shown or a key changed a value.
    pub fn filled(&self, id: OpId) -> Option<&Filled> {
        self.filled.get(&id)
    }

    /// Fills in one field.
    pub fn fill(&mut self, id: OpId, facts: &Facts, field: &str, value: Value) {
        let filled = self.filled.entry(id).or_insert_with(|| form::initial(id.spec(), facts));
        filled.insert(field.to_owned(), value);
    }

    /// The target edge length of resampling, if it was set.
    pub fn target_edge(&self) -> Option<f64> {
        self.filled(OpId::Remesh)?.get(EDGE_LENGTH)?.as_f64()
    }

    /// Forgets lengths, which are meaningless for another mesh.
    pub fn forget_lengths(&mut self) {
        self.filled.retain(|id, _| !form::needs_measures(id.spec()));
    }
}

pub(crate) fn show(ui: &mut Ui, page: &Page<'_>, own: &mut Forms, out: &mut Requests) {
    adjust::show(ui, page, &mut own.adjusting, out);
    ui.add_space(2.0);
    ui.label(RichText::new("Operations").strong());
    let id = own.chosen.unwrap_or(OpId::New);
    let chosen = id.spec();
    let combo = ComboBox::from_id_salt("operation")
        .selected_text(chosen.label)
        .width(ui.available_width() - 8.0)
        .height(420.0);
    let combo = combo.show_ui(ui, |ui| {
        // Whole-mesh operations come first, as they are the ones that people fill in forms for.
        let of_scope = |scope| actions::mesh_operations().filter(move |other| other.spec().scope == scope);
        for other in of_scope(Scope::Meshes).chain(of_scope(Scope::Elements)) {
            let spec = other.spec();
            if ui.selectable_label(other == id, spec.label).on_hover_text(spec.description).clicked() {
                own.choose(other);
            }
        }
    });
    combo.response.accessible_name("Operation").on_hover_text("The operation to fill in and apply");
    ui.add(egui::Label::new(RichText::new(chosen.description).weak()).wrap());

    let facts = page.facts(id);
    let mut filled = own.filled.remove(&id).unwrap_or_else(|| form::initial(chosen, &facts));
    let before = filled.clone();
    Grid::new(("form", chosen.name)).num_columns(2).spacing(vec2(10.0, 6.0)).show(ui, |ui| {
        fields::rows(ui, chosen, &mut filled, &facts, |_| true);
    });
    let preview_is_coming = preview::row(ui, page, &mut own.previews, id, &filled, filled != before, out);
    if let Some(estimate) = estimate::show(page, &mut own.tried, id, &filled, &facts, preview_is_coming) {
        ui.label(RichText::new(estimate).small().weak());
    }
    apply_button(ui, page, id, &filled, out);
    own.filled.insert(id, filled);
}

fn apply_button(ui: &mut Ui, page: &Page<'_>, id: OpId, filled: &Filled, out: &mut Requests) {
    let (spec, action) = (id.spec(), Action::Operation(id));
    let why_not = page.why_not(action);
    let button = primary_button(ui, spec.label).min_size(vec2(ui.available_width(), 28.0));
    let response = ui.vertical_centered_justified(|ui| ui.add_enabled(why_not.is_none(), button)).inner;
    let tooltip = keys::tooltip(ui.ctx(), spec.description, action);
    let reason = why_not.clone().unwrap_or_default();
    if response.on_hover_text(tooltip).on_disabled_hover_text(reason).clicked() {
        out.push(Request::Apply(id, filled.clone()));
    }
    if let Some(reason) = why_not {
        ui.add(egui::Label::new(RichText::new(reason).small().color(ui.visuals().warn_fg_color)).wrap());
    }
}
