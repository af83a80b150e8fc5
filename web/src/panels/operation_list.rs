//! The list of operations: grouped by what they work on, those for the selection first, and those that can't be
//! done now at the end, each with the reason.

use std::collections::HashMap;

use editor::ops::{Field, Fill};
use editor::{OpId, Scope};
use egui::{CollapsingHeader, Key, Label, RichText, Ui};
use halfedge::Element;

use crate::input::actions::{self, Action};
use crate::input::availability::{follows_pointer, opens_form};
use crate::input::keys;
use crate::lists::columns::plural;
use crate::page_view::Page;
use crate::panels::document::selection_title;
use crate::panels::menu_bar::explain;
use crate::panels::palette;
use crate::request::{Request, Requests};
use crate::widgets::controls::text_field;
use crate::widgets::icon_button::icon_button;
use crate::widgets::icons::Icon;
use crate::widgets::list_row::operation_row;

/// The state of the list.
#[derive(Default)]
pub(crate) struct ListState {
    /// What is typed into the filter.
    filter: String,
    /// Why operations can't be done, as last asked.
    answers: HashMap<OpId, Answer>,
}

struct Answer {
    why_not: Option<String>,
    /// The frame in which the editor was asked.
    frame: u64,
}

/// The time per frame for asking the editor what can be done. Answers that are not asked again in time are those
/// of an earlier frame.
const MAX_SECONDS_ASKING: f64 = 0.004;

/// What the operations of a group work on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Group {
    Selection,
    Meshes,
    Elements(Element),
    Objects,
}

/// The groups in the order of the list.
const GROUPS: [Group; 6] = [
    Group::Selection,
    Group::Meshes,
    Group::Elements(Element::Vertex),
    Group::Elements(Element::Edge),
    Group::Elements(Element::Face),
    Group::Objects,
];

pub(crate) fn show(ui: &mut Ui, page: &Page<'_>, own: &mut ListState, out: &mut Requests) {
    ui.label(RichText::new("Operations").strong());
    let entered = filter(ui, own);
    own.ask(ui, page);
    let found: Vec<OpId> = match own.filter.trim() {
        "" => listed().collect(),
        text => found(&text.to_lowercase()),
    };
    let (can, cannot): (Vec<OpId>, Vec<OpId>) = found.iter().partition(|id| own.why_not(**id).is_none());
    if own.filter.trim().is_empty() {
        for group in GROUPS {
            rows(ui, page, group, &can, out);
        }
        let count = cannot.len();
        if count > 0 {
            ui.add_space(8.0);
            let title = RichText::new(format!("Not now ({count})")).small().strong();
            CollapsingHeader::new(title).id_salt("not now").show(ui, |ui| {
                for group in GROUPS {
                    for id in in_group(page, &cannot, group) {
                        refused_row(ui, own, id);
                    }
                }
            });
        }
        return;
    }
    ui.add_space(4.0);
    for &id in &can {
        row(ui, id, out);
    }
    for &id in &cannot {
        refused_row(ui, own, id);
    }
    if found.is_empty() {
        ui.add(Label::new(RichText::new("No operation matches.").weak()).wrap());
    }
    if let Some(&first) = can.first().filter(|_| entered) {
        start(first, out);
    }
}

/// Only the operations on the selection, for the inspector's sheet.
pub(crate) fn of_selection(ui: &mut Ui, page: &Page<'_>, own: &mut ListState, out: &mut Requests) {
    own.ask(ui, page);
    let can: Vec<OpId> = listed().filter(|id| own.why_not(*id).is_none()).collect();
    rows(ui, page, Group::Selection, &can, out);
}

impl ListState {
    /// Asks the editor what can be done, those first whose answer is the oldest. During a drag the answers stay.
    fn ask(&mut self, ui: &Ui, page: &Page<'_>) {
        let frame = ui.ctx().cumulative_frame_nr();
        if page.editor.is_editing() && !self.answers.is_empty() {
            return;
        }
        let started = page.platform.now();
        let mut all: Vec<OpId> = listed().collect();
        all.sort_by_key(|id| self.answers.get(id).map_or(0, |answer| answer.frame));
        for id in all {
            if page.platform.now() - started > MAX_SECONDS_ASKING && self.answers.contains_key(&id) {
                ui.ctx().request_repaint();
                return;
            }
            let why_not = page.why_not(Action::Operation(id));
            self.answers.insert(id, Answer { why_not, frame });
        }
    }

    fn why_not(&self, id: OpId) -> Option<&str> {
        self.answers.get(&id)?.why_not.as_deref()
    }
}

/// The field that filters the list; returns whether Enter was pressed in it.
fn filter(ui: &mut Ui, own: &mut ListState) -> bool {
    ui.horizontal(|ui| {
        let clear = if own.filter.is_empty() { 0.0 } else { ui.spacing().interact_size.y + 8.0 };
        let field = text_field(&mut own.filter)
            .hint_text("Filter operations")
            .desired_width((ui.available_width() - clear - 8.0).max(0.0));
        let field = ui.add(field).accessible_name("Filter operations");
        let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        if clear > 0.0 && icon_button(ui, Icon::Close, "Clear the filter", false).clicked() {
            own.filter.clear();
        }
        entered
    })
    .inner
}

/// The operations that the list offers.
fn listed() -> impl Iterator<Item = OpId> {
    actions::mesh_operations().chain([OpId::New])
}

/// The operations that fit a text, as the palette finds them, the best first.
fn found(text: &str) -> Vec<OpId> {
    let rank = |id| Some((palette::rank(&actions::describe(Action::Operation(id)), text)?, id));
    let mut found: Vec<(usize, OpId)> = listed().filter_map(rank).collect();
    found.sort_by_key(|(rank, _)| *rank);
    found.into_iter().map(|(_, id)| id).collect()
}

/// Those of the operations that belong to a group, by use.
fn in_group(page: &Page<'_>, ids: &[OpId], group: Group) -> Vec<OpId> {
    let mut ids: Vec<OpId> = ids.iter().copied().filter(|id| group_of(page, *id) == group).collect();
    actions::sort_by_use(&mut ids);
    ids
}

fn group_of(page: &Page<'_>, id: OpId) -> Group {
    /// Operations on whole meshes that change which objects there are.
    const OF_OBJECTS: [OpId; 4] = [OpId::New, OpId::JoinObjects, OpId::Separate, OpId::RepairImport];
    let selection = page.editor.selection();
    let spec = id.spec();
    match spec.scope {
        _ if !selection.is_empty() && spec.applies_to(selection.kind()) => Group::Selection,
        _ if OF_OBJECTS.contains(&id) => Group::Objects,
        Scope::Elements => Group::Elements(spec.element().unwrap_or(Element::Face)),
        _ => Group::Meshes,
    }
}

fn title(page: &Page<'_>, group: Group) -> String {
    let selection = page.editor.selection();
    match group {
        Group::Selection => selection_title(selection.kind(), selection.len()),
        Group::Meshes => "Whole mesh".to_owned(),
        Group::Elements(kind) => format!("On {}", plural(kind).to_lowercase()),
        Group::Objects => "Shapes and objects".to_owned(),
    }
}

/// A group's heading and its rows; nothing if there are none.
fn rows(ui: &mut Ui, page: &Page<'_>, group: Group, can: &[OpId], out: &mut Requests) {
    /// Operations that have their own controls in the inspector.
    const IN_INSPECTOR: [OpId; 3] = [OpId::SetVertexPosition, OpId::SetFaceColor, OpId::SplitEdge];
    let mut ids = in_group(page, can, group);
    ids.retain(|id| group != Group::Selection || !IN_INSPECTOR.contains(id));
    if ids.is_empty() {
        return;
    }
    ui.add_space(8.0);
    ui.label(RichText::new(title(page, group)).small().strong());
    ui.scope(|ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        for id in ids {
            row(ui, id, out);
        }
    });
}

fn row(ui: &mut Ui, id: OpId, out: &mut Requests) {
    let entry = actions::describe(Action::Operation(id));
    let name = if fills_form(id) { format!("{}…", entry.label) } else { entry.label.to_owned() };
    let response = operation_row(ui, id, &name, &keys::text(ui.ctx(), entry.action));
    if explain(response, ui, &entry, None).clicked() {
        start(id, out);
    }
}

/// A greyed row with its reason below it.
fn refused_row(ui: &mut Ui, own: &ListState, id: OpId) {
    let entry = actions::describe(Action::Operation(id));
    let reason = own.why_not(id).unwrap_or_default();
    ui.spacing_mut().item_spacing.y = 0.0;
    let row = ui.add_enabled_ui(false, |ui| operation_row(ui, id, entry.label, "")).inner;
    explain(row, ui, &entry, Some(reason));
    ui.indent(("reason", entry.label), |ui| {
        ui.add(Label::new(RichText::new(reason).small().weak()).wrap());
    });
}

/// Starts an operation: opens its form if there is something to fill in that can't be adjusted as well afterwards.
fn start(id: OpId, out: &mut Requests) {
    if fills_form(id) {
        out.push(Request::OpenForm(id));
    } else {
        out.act(Action::Operation(id));
    }
}

/// Whether the list opens an operation's form. Operations on a few elements act at once or follow the pointer;
/// their fields are in "Adjust last operation".
fn fills_form(id: OpId) -> bool {
    let spec = id.spec();
    let is_filled_in = |field: &Field| !matches!(field.fill, Fill::Selection(_) | Fill::Optional(_));
    match spec.scope {
        Scope::Meshes => spec.fields.iter().any(is_filled_in),
        _ => opens_form(id) && !follows_pointer(id),
    }
}
