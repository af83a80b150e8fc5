//! The operations panel: the list of operations, and the form of the one that is being filled in.

use std::collections::HashMap;

use editor::{Facts, OpId};
use egui::{Button, Grid, RichText, ScrollArea, Ui, vec2};
use serde_json::{Value, json};

use crate::input::actions::{self, Action};
use crate::input::keys;
use crate::page_view::Page;
use crate::panels::adjust::{self, Adjusting};
use crate::panels::estimate::{self, Tried};
use crate::panels::fields;
use crate::panels::operation_list::{self, ListState};
use crate::panels::preview::{self, Previews};
use crate::request::{Request, Requests};
use crate::session::form::{self, Filled};
use crate::theme;
use crate::transforming::Pivot;
use crate::widgets::controls::primary_button;
use crate::widgets::icon_button::icon_button;
use crate::widgets::icons::Icon;

/// The field of remeshing that the keys for the target edge length change.
pub(crate) const EDGE_LENGTH: &str = "edge_length";

/// The field of a transform with the point that stays in place.
const PIVOT: &str = "pivot";

/// The values of all forms on the page.
#[derive(Default)]
pub(crate) struct Forms {
    /// The operation whose form is open.
    chosen: Option<OpId>,
    /// The height of the form's end in the last frame, in points.
    end_height: f32,
    list: ListState,
    filled: HashMap<OpId, Filled>,
    /// The result of a trial run.
    pub tried: Option<Tried>,
    pub previews: Previews,
    adjusting: Adjusting,
    /// The page's pivot that the form of a transform was last given.
    given_pivot: Option<Value>,
}

impl Forms {
    /// Shows an operation's form.
    pub fn open(&mut self, id: OpId) {
        self.chosen = Some(id);
        self.previews.ask();
    }

    /// Shows the list of operations again; what was filled in stays for the next time. Returns whether a form was
    /// open.
    pub fn close(&mut self) -> bool {
        self.chosen.take().is_some()
    }

    /// Moves the keyboard focus to the fields of the last operation.
    pub fn adjust_last(&mut self) {
        self.close();
        self.adjusting.take_focus();
    }

    /// The state of the list of operations.
    pub fn list(&mut self) -> &mut ListState {
        &mut self.list
    }

    /// Whether a form is open.
    pub fn is_open(&self) -> bool {
        self.chosen.is_some()
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

/// The last operation's fields, unless a form is open.
pub(crate) fn adjust(ui: &mut Ui, page: &Page<'_>, own: &mut Forms, out: &mut Requests) {
    if own.chosen.is_none() {
        adjust::show(ui, page, &mut own.adjusting, out);
    }
}

/// The panel: the form that is open, or else the list of operations.
pub(crate) fn show(ui: &mut Ui, page: &Page<'_>, own: &mut Forms, out: &mut Requests) {
    match own.chosen {
        Some(id) => form(ui, page, own, id, out),
        None => operation_list::show(ui, page, &mut own.list, out),
    }
}

fn form(ui: &mut Ui, page: &Page<'_>, own: &mut Forms, id: OpId, out: &mut Requests) {
    let spec = id.spec();
    let entry = actions::describe(Action::Operation(id));
    ui.horizontal(|ui| {
        let back = icon_button(ui, Icon::Back, "All operations", false);
        if back.on_hover_text("Back to all operations (Escape)").clicked() {
            out.push(Request::CloseForm);
        }
        ui.label(RichText::new(entry.label).heading());
    });
    let facts = page.facts(id);
    let mut filled = own.filled.remove(&id).unwrap_or_else(|| {
        own.given_pivot = None;
        form::initial(spec, &facts)
    });
    let before = filled.clone();
    if id == OpId::Transform {
        follow_pivot(page, &mut own.given_pivot, &mut filled);
    }
    let mut rows = |ui: &mut Ui| {
        ui.add(egui::Label::new(RichText::new(entry.description).weak()).wrap());
        ui.add_space(4.0);
        Grid::new(("form", spec.name)).num_columns(2).spacing(vec2(12.0, 8.0)).show(ui, |ui| {
            fields::rows(ui, spec, &mut filled, &facts, |field| !field.is_symmetry());
        });
    };
    if page.shown.narrow {
        // Only the fields scroll: the result and the buttons stay in sight.
        let height = (ui.available_height() - own.end_height).max(theme::TOUCH_TARGET);
        let area = ScrollArea::vertical().id_salt("fields").max_height(height).auto_shrink([false, true]);
        area.show(ui, |ui| rows(ui));
        let end = ui.scope(|ui| form_end(ui, page, own, id, &facts, (&filled, filled != before), out));
        let end_height = end.response.rect.height() + ui.spacing().item_spacing.y;
        if (end_height - own.end_height).abs() > 0.5 {
            own.end_height = end_height;
            ui.ctx().request_repaint();
        }
    } else {
        rows(ui);
        form_end(ui, page, own, id, &facts, (&filled, filled != before), out);
    }
    own.filled.insert(id, filled);
}

/// Fills in the page's pivot whenever it changes, where it is a place that doesn't depend on the selection.
fn follow_pivot(page: &Page<'_>, given: &mut Option<Value>, filled: &mut Filled) {
    let point = match page.live_settings.pivot {
        Pivot::Origin => Some(glam::Vec3::ZERO - page.editor.document().offset().as_vec3()),
        Pivot::Cursor => Some(page.view.cursor.in_scene(&page.editor)),
        Pivot::Middle | Pivot::Bounds | Pivot::Active | Pivot::Individual => None,
    };
    let now = point.map(|point| json!(point.to_array()));
    if now != *given {
        match &now {
            Some(point) => filled.insert(PIVOT.to_owned(), point.clone()),
            None => filled.remove(PIVOT),
        };
        *given = now;
    }
}

/// The end of a form: the preview, the size of the result, and the button that applies it. `filled` is what is filled
/// in, and whether that has changed.
fn form_end(
    ui: &mut Ui,
    page: &Page<'_>,
    own: &mut Forms,
    id: OpId,
    facts: &Facts,
    (filled, has_changed): (&Filled, bool),
    out: &mut Requests,
) {
    let preview_is_coming = preview::row(ui, page, &mut own.previews, id, filled, has_changed, out);
    if let Some(estimate) = estimate::show(page, &mut own.tried, id, filled, facts, preview_is_coming) {
        ui.label(RichText::new(estimate).small().weak());
    }
    ui.add_space(4.0);
    if page.shown.narrow {
        let width = ((ui.available_width() - ui.spacing().item_spacing.x) / 2.0).max(0.0);
        ui.horizontal_top(|ui| {
            let cancel = Button::new("Cancel").min_size(vec2(width, 0.0));
            // In a column as the other button is, which centres its text.
            let cancel = ui.vertical(|ui| ui.add(cancel)).inner;
            if cancel.on_hover_text("Close the form without applying it").clicked() {
                out.push(Request::CloseForm);
            }
            ui.vertical(|ui| apply_button(ui, page, id, filled, out));
        });
    } else {
        apply_button(ui, page, id, filled, out);
    }
}

fn apply_button(ui: &mut Ui, page: &Page<'_>, id: OpId, filled: &Filled, out: &mut Requests) {
    let action = Action::Operation(id);
    let entry = actions::describe(action);
    let why_not = page.why_not(action);
    let button = primary_button(ui, entry.label).min_size(vec2(ui.available_width(), 32.0));
    let response = ui.vertical_centered_justified(|ui| ui.add_enabled(why_not.is_none(), button)).inner;
    let tooltip = keys::tooltip(ui.ctx(), entry.description, action);
    let reason = why_not.clone().unwrap_or_default();
    if response.on_hover_text(tooltip).on_disabled_hover_text(reason).clicked() {
        out.push(Request::Apply(id, filled.clone()));
    }
    if let Some(reason) = why_not {
        ui.add(egui::Label::new(RichText::new(reason).small().color(ui.visuals().warn_fg_color)).wrap());
    }
}
