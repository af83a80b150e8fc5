//! The lists of vertices, edges, half-edges and faces.

use editor::{Changes, Editor, ObjectChange, ObjectId, SelectMode};
use egui::{Button, Key, RichText, Ui, vec2};
use halfedge::{Budget, Element};

use crate::input::actions::{self, Action};
use crate::input::keys;
use crate::lists::columns::{columns, counted, element_name, plural, row};
use crate::lists::index::{RowIndex, Source};
use crate::lists::row_list::{Picked, RowContent, RowList, RowListState};
use crate::page_view::Page;
use crate::panels::hidden_bar::reveal_button;
use crate::panels::menu_bar::menu_item;
use crate::request::{Request, Requests};
use crate::theme;
use crate::widgets::controls::text_field;
use halfedge::words::thousands;

/// The lists of the active object.
#[derive(Default)]
pub(crate) struct Lists {
    go_to: String,
    /// Move the keyboard focus to the "Go to id" field in the next frame.
    pub focus_go_to: bool,
    indices: ByKind<RowIndex>,
    states: ByKind<RowListState>,
    /// A selected element to scroll to.
    reveal: Option<u32>,
    /// Whether the next change of the selection comes from the list itself, where the element is in view.
    ignore_next_reveal: bool,
    /// The object that the rows belong to.
    object: Option<ObjectId>,
}

/// One value for each kind of element.
#[derive(Default)]
struct ByKind<T> {
    vertex: T,
    edge: T,
    halfedge: T,
    face: T,
}

impl<T> ByKind<T> {
    fn of(&self, kind: Element) -> &T {
        match kind {
            Element::Vertex => &self.vertex,
            Element::Edge => &self.edge,
            Element::Halfedge => &self.halfedge,
            Element::Face => &self.face,
        }
    }

    fn of_mut(&mut self, kind: Element) -> &mut T {
        match kind {
            Element::Vertex => &mut self.vertex,
            Element::Edge => &mut self.edge,
            Element::Halfedge => &mut self.halfedge,
            Element::Face => &mut self.face,
        }
    }
}

impl Lists {
    /// The rows of a kind.
    fn index(&self, kind: Element) -> &RowIndex {
        self.indices.of(kind)
    }

    /// Updates the lists to the document; returns whether they now show another object.
    pub fn follow(&mut self, editor: &Editor, changes: &Changes) -> bool {
        let active = editor.document().active().map(editor::Object::id);
        let is_other = active != self.object;
        if is_other {
            self.object = active;
            self.states = Default::default();
            self.follow_mesh(editor, None);
        } else if let Some(change) = active.and_then(|id| changes.of(id)) {
            self.follow_mesh(editor, Some(change));
        }
        if changes.hidden.iter().any(|(id, _)| Some(*id) == active) {
            self.follow_mesh(editor, None);
        }
        if changes.selection && !std::mem::take(&mut self.ignore_next_reveal) {
            self.reveal = editor.selection().latest();
        }
        is_other
    }

    fn follow_mesh(&mut self, editor: &Editor, change: Option<&ObjectChange>) {
        let Some(object) = editor.document().active() else {
            self.indices = Default::default();
            return;
        };
        for kind in Element::ALL {
            let source = Source { mesh: object.mesh(), kind, hidden: object.hidden() };
            let index = self.indices.of_mut(kind);
            match change {
                Some(ObjectChange::Touched(touched)) => index.follow(source, touched),
                _ => {
                    index.restart(source);
                    // At once in meshes of which that takes no longer than drawing them.
                    index.step(source, &mut Budget::new(MAX_ROWS_INDEXED_AT_ONCE));
                }
            }
        }
    }

    /// Finds more of the rows, those of the shown kind first; returns whether there are any left.
    pub fn step(&mut self, editor: &Editor, shown: Element, budget: &mut Budget) -> bool {
        let Some(object) = editor.document().active() else { return false };
        let mut is_left = false;
        for kind in std::iter::once(shown).chain(Element::ALL) {
            let source = Source { mesh: object.mesh(), kind, hidden: object.hidden() };
            is_left |= self.indices.of_mut(kind).step(source, budget);
        }
        is_left
    }

    /// The id in the row after or before an element's, see [`RowIndex::beside`].
    pub fn beside(&self, kind: Element, id: Option<u32>, forward: bool) -> Option<u32> {
        self.index(kind).beside(id, forward)
    }
}

/// The rows of fewer elements than this are found at once.
const MAX_ROWS_INDEXED_AT_ONCE: usize = 10_000;

pub(crate) fn show(ui: &mut Ui, page: &Page<'_>, own: &mut Lists, out: &mut Requests) {
    // In a narrow window the toggles over the viewport are near enough.
    if !page.shown.narrow {
        kind_tabs(ui, page, own, out);
    }
    list_bar(ui, page, own, out);
    hidden_count(ui, page, own, out);
    element_list(ui, page, own, out);
}

/// The tabs, one for each kind, with counts.
fn kind_tabs(ui: &mut Ui, page: &Page<'_>, own: &mut Lists, out: &mut Requests) {
    ui.add_space(4.0);
    ui.horizontal(|ui| {
        ui.ctx().accesskit_node_builder(ui.unique_id(), |node| {
            node.set_role(egui::Role::TabList);
            node.set_label("Kinds of element");
        });
        ui.spacing_mut().item_spacing.x = 2.0;
        let width = ((ui.available_width() - 3.0 * 2.0) / 4.0).floor();
        for kind in Element::ALL {
            let on = page.shown.kind == kind;
            let count = own.index(kind).len();
            let button = Button::selectable(on, plural(kind)).min_size(vec2(width, 0.0));
            let tab = ui.add_sized(vec2(width, ui.spacing().interact_size.y), button);
            ui.ctx().accesskit_node_builder(tab.id, |node| {
                node.set_role(egui::Role::Tab);
                node.set_selected(on);
                node.set_value(count.to_string());
            });
            let entry = actions::describe(Action::Show(kind));
            let all = page.editor.mesh().map_or(0, |mesh| mesh.count(kind));
            let shown = if count < all { format!("{} of ", thousands(count)) } else { String::new() };
            let tooltip = format!("{shown}{} in this object. {}", thousands(all), entry.description);
            if tab.on_hover_text(keys::tooltip(ui.ctx(), &tooltip, entry.action)).clicked() {
                let expands = ui.input(|input| input.modifiers.command);
                out.act(if expands { Action::Expand(kind) } else { Action::Show(kind) });
            }
        }
    });
}

/// The "Go to id" field and the filter.
fn list_bar(ui: &mut Ui, page: &Page<'_>, own: &mut Lists, out: &mut Requests) {
    let kind = page.shown.kind;
    ui.horizontal(|ui| {
        let hint = format!("Go to {kind} id");
        let field = text_field(&mut own.go_to).hint_text(hint.as_str()).desired_width(118.0);
        let field = ui.add(field).accessible_name("Go to id");
        let field = field.on_hover_text(keys::tooltip(
            ui.ctx(),
            "Type a number and press Enter to select that element.",
            Action::GoToId,
        ));
        if std::mem::take(&mut own.focus_go_to) {
            field.request_focus();
        }
        if field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter)) {
            go_to(page, own, out);
        }
        let mut only = page.shown.only_selected;
        let entry = actions::describe(Action::OnlySelected);
        let check = ui.checkbox(&mut only, "Only selected");
        if check.on_hover_text(keys::tooltip(ui.ctx(), entry.description, entry.action)).clicked() {
            out.act(Action::OnlySelected);
        }
        let selection = page.editor.selection();
        if selection.kind() == kind && !selection.is_empty() {
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                ui.label(RichText::new(format!("{} selected", thousands(selection.len()))).small().weak());
            });
        }
    });
}

/// How many elements have rows where some are hidden, and a button that shows those.
fn hidden_count(ui: &mut Ui, page: &Page<'_>, own: &Lists, out: &mut Requests) {
    let kind = page.shown.kind;
    let (shown, all) = (own.index(kind).len(), page.editor.mesh().map_or(0, |mesh| mesh.count(kind)));
    let hides = page.editor.document().active().is_some_and(|object| !object.hidden().is_empty());
    if !hides || shown >= all {
        return;
    }
    ui.horizontal(|ui| {
        let text =
            format!("{} of {}, {} hidden", thousands(shown), counted(kind, all), thousands(all - shown));
        ui.label(RichText::new(text).small());
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| reveal_button(ui, out));
    });
}

/// Selects the element with the typed id.
fn go_to(page: &Page<'_>, own: &mut Lists, out: &mut Requests) {
    let kind = page.shown.kind;
    let text = own.go_to.trim().trim_start_matches('#').replace([' ', ','], "");
    let found =
        text.parse::<u32>().ok().filter(|&id| page.editor.mesh().is_some_and(|mesh| mesh.exists(kind, id)));
    let is_hidden = |id: u32| {
        let object = page.editor.document().active();
        object.is_some_and(|object| {
            surface::selecting::is_hidden(object.mesh(), kind, id as usize, object.hidden())
        })
    };
    match found {
        Some(id) if is_hidden(id) => {
            out.push(Request::Warn(format!("{} is hidden: reveal it first.", element_name(kind, id))));
        }
        Some(id) => {
            own.go_to.clear();
            out.select(kind, [id], SelectMode::Replace);
            // Selecting the same element again changes nothing, but the list should still scroll to it.
            own.reveal = Some(id);
        }
        None => {
            let capacity = page.editor.mesh().map_or(0, |mesh| mesh.capacity(kind));
            let range = match capacity {
                0 => format!("the mesh has no {}", plural(kind).to_lowercase()),
                n => format!("ids go from 0 to {}", thousands(n - 1)),
            };
            let typed = own.go_to.trim().to_owned();
            out.push(Request::Warn(format!("There is no {kind} “{typed}”: {range}.")));
        }
    }
}

fn element_list(ui: &mut Ui, page: &Page<'_>, own: &mut Lists, out: &mut Requests) {
    let kind = page.shown.kind;
    let selection = page.editor.selection();
    let is_kind = selection.kind() == kind;
    let only = page.shown.only_selected;
    let rows = if only { if is_kind { selection.len() } else { 0 } } else { own.index(kind).len() };
    if rows == 0 {
        empty_list(ui, page, kind, only);
        return;
    }
    if let Some(id) = own.reveal.take().filter(|_| is_kind) {
        let row = if only { Some(selection.rank(id)) } else { own.index(kind).row_of(id) };
        if let Some(row) = row {
            own.states.of_mut(kind).reveal(row);
        }
    }
    let Some(mesh) = page.editor.mesh() else { return };
    let mut state = std::mem::take(own.states.of_mut(kind));
    let index = own.index(kind);
    let id_of = |at: usize| if only { selection.nth(at) } else { index.id_of(at) };
    let hovered = page.view.hovered.filter(|(hovered, _)| *hovered == kind).map(|(_, id)| id);
    let offset = page.editor.document().offset();
    let label = plural(kind);
    let list = RowList {
        label,
        columns: columns(kind),
        rows,
        row_height: if page.shown.touch { theme::TOUCH_TARGET } else { 20.0 },
    };
    let output = list.show(ui, &mut state, |at| {
        let id = id_of(at)?;
        let row = row(mesh, kind, id, offset)?;
        Some(RowContent {
            name: element_name(kind, id),
            value: row.value(kind),
            selected: is_kind && selection.contains(kind, id),
            hovered: hovered == Some(id),
            row,
        })
    });
    let picked = output.picked.and_then(|picked| Some((picked, id_of(picked.row)?)));
    let under_pointer = output.hovered.and_then(id_of);
    let context = output.context.and_then(id_of);
    *own.states.of_mut(kind) = state;
    if let Some(id) = under_pointer {
        out.push(Request::Hover(kind, id));
    }
    // The pick of the last frame has been handled by now, if it changed the selection.
    own.ignore_next_reveal = picked.is_some();
    if let Some((picked, id)) = picked {
        // The row is in view already, as the user clicked it.
        pick_row(page, kind, picked, id, out);
    }
    if let Some(id) = context.filter(|&id| !page.editor.selection().contains(kind, id)) {
        out.select(kind, [id], SelectMode::Replace);
    }
    output.response.context_menu(|ui| menu(ui, page, out));
}

fn pick_row(page: &Page<'_>, kind: Element, picked: Picked, id: u32, out: &mut Requests) {
    if picked.extend && page.editor.selection().kind() == kind && page.editor.selection().latest().is_some() {
        // If the list shows only the selection, every row in between is selected already.
        out.push(Request::SelectRange { kind, to: id });
    } else {
        let mode = if picked.toggle || page.shown.adds { SelectMode::Toggle } else { SelectMode::Replace };
        // In a list of the selection, a plain click would empty the list under the pointer.
        if page.shown.only_selected && mode == SelectMode::Replace {
            out.select(kind, [id], SelectMode::Extend);
        } else {
            out.select(kind, [id], mode);
        }
    }
}

fn empty_list(ui: &mut Ui, page: &Page<'_>, kind: Element, only: bool) {
    ui.add_space(24.0);
    let all = page.editor.mesh().map_or(0, |mesh| mesh.count(kind));
    ui.vertical_centered(|ui| {
        let (title, hint) = if only {
            (
                format!("No {kind} is selected"),
                "Click one in the viewport, or turn off “Only selected” to see all.".to_owned(),
            )
        } else if all > 0 {
            (
                format!("All {} are hidden", plural(kind).to_lowercase()),
                "Reveal them to see them here again.".to_owned(),
            )
        } else if crate::bezier::active(&page.editor).is_some() {
            (
                format!("A curve has no {}", plural(kind).to_lowercase()),
                "Its control points are listed in the inspector.".to_owned(),
            )
        } else if page.editor.document().objects().is_empty() {
            (
                "No mesh".to_owned(),
                "Drop an OBJ file on the page, paste its text, or create a shape.".to_owned(),
            )
        } else {
            (
                format!("This mesh has no {}", plural(kind).to_lowercase()),
                "Open another file, or undo.".to_owned(),
            )
        };
        ui.label(RichText::new(title).strong());
        ui.label(RichText::new(hint).weak());
    });
    ui.take_available_space();
}

/// The context menu of elements: the operations that apply to them.
pub(crate) fn menu(ui: &mut Ui, page: &Page<'_>, out: &mut Requests) {
    ui.set_min_width(200.0);
    let kind = page.editor.selection().kind();
    for id in actions::edits_of(kind) {
        menu_item(ui, page, &actions::of_operation(id), out);
    }
    ui.separator();
    for id in actions::hiding() {
        menu_item(ui, page, &actions::of_operation(id), out);
    }
    ui.separator();
    for action in [Action::Frame, Action::SelectAll, Action::SelectNone, Action::SelectInverse] {
        menu_item(ui, page, &actions::describe(action), out);
    }
}
