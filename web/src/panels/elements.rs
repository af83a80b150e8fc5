//! The lists of vertices, edges, half-edges and faces.

use editor::SelectMode;
use egui::{Button, Key, RichText, TextEdit, Ui, vec2};
use halfedge::Element;

use crate::actions::{self, Action};
use crate::app::{App, ShownKind, slot};
use crate::lists::columns::{columns, element_name, plural, row, thousands};
use crate::lists::row_list::{Picked, RowContent, RowList};
use crate::{keys, theme};

impl App {
    pub(crate) fn elements(&mut self, ui: &mut Ui) {
        self.kind_tabs(ui);
        self.list_bar(ui);
        self.element_list(ui);
    }

    /// The tabs, one per kind, each with its count.
    fn kind_tabs(&mut self, ui: &mut Ui) {
        ui.add_space(4.0);
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 2.0;
            let width = ((ui.available_width() - 3.0 * 2.0) / 4.0).floor();
            for kind in Element::ALL {
                let on = self.lists.kind.0 == kind;
                let count = self.lists.index(kind).len();
                let button = Button::selectable(on, plural(kind)).min_size(vec2(width, 0.0));
                let tab = ui.add_sized(vec2(width, ui.spacing().interact_size.y), button);
                ui.ctx().accesskit_node_builder(tab.id, |node| {
                    node.set_role(egui::Role::Tab);
                    node.set_selected(on);
                    node.set_value(count.to_string());
                });
                let entry = actions::describe(Action::Show(kind));
                let tooltip = format!("{} in this object. {}", thousands(count), entry.description);
                if tab.on_hover_text(keys::tooltip(ui.ctx(), &tooltip, entry.action)).clicked() {
                    self.lists.kind = ShownKind(kind);
                }
            }
        });
    }

    /// "Go to id" and the filter.
    fn list_bar(&mut self, ui: &mut Ui) {
        let kind = self.lists.kind.0;
        ui.horizontal(|ui| {
            let hint = format!("Go to {kind} id");
            let field =
                TextEdit::singleline(&mut self.lists.go_to).hint_text(hint.as_str()).desired_width(118.0);
            let field = ui.add(field).accessible_name("Go to id");
            let field = field.on_hover_text(keys::tooltip(
                ui.ctx(),
                "Type a number and press Enter to select that element.",
                Action::GoToId,
            ));
            if std::mem::take(&mut self.lists.focus_go_to) {
                field.request_focus();
            }
            if field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter)) {
                self.go_to();
            }
            let mut only = self.lists.only_selected;
            let entry = actions::describe(Action::OnlySelected);
            let check = ui.checkbox(&mut only, "Only selected");
            if check.on_hover_text(keys::tooltip(ui.ctx(), entry.description, entry.action)).clicked() {
                self.act(Action::OnlySelected);
            }
            let selection = self.editor.selection();
            if selection.kind() == kind && !selection.is_empty() {
                ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                    ui.label(
                        RichText::new(format!("{} selected", thousands(selection.len()))).small().weak(),
                    );
                });
            }
        });
    }

    /// Selects the element whose number was typed.
    fn go_to(&mut self) {
        let kind = self.lists.kind.0;
        let text = self.lists.go_to.trim().trim_start_matches('#').replace([' ', ','], "");
        let found = text
            .parse::<u32>()
            .ok()
            .filter(|&id| self.editor.mesh().is_some_and(|mesh| mesh.exists(kind, id)));
        match found {
            Some(id) => {
                self.lists.go_to.clear();
                self.select(kind, [id], SelectMode::Replace);
                // Selecting the same again changes nothing, but the list should still go there.
                self.lists.reveal = true;
            }
            None => {
                let capacity = self.editor.mesh().map_or(0, |mesh| mesh.capacity(kind));
                let range = match capacity {
                    0 => format!("the mesh has no {}", plural(kind).to_lowercase()),
                    n => format!("ids go from 0 to {}", thousands(n - 1)),
                };
                let typed = self.lists.go_to.trim().to_owned();
                self.toast(
                    editor::MessageKind::Warning,
                    format!("There is no {kind} “{typed}”: {range}."),
                    Vec::new(),
                );
            }
        }
    }

    fn element_list(&mut self, ui: &mut Ui) {
        let kind = self.lists.kind.0;
        let selection = self.editor.selection();
        let own = selection.kind() == kind;
        let only = self.lists.only_selected;
        let rows = if only { if own { selection.len() } else { 0 } } else { self.lists.index(kind).len() };
        if rows == 0 {
            self.empty_list(ui, kind, only);
            return;
        }
        if std::mem::take(&mut self.lists.reveal)
            && let Some(id) = selection.latest().filter(|_| own)
        {
            let row = if only { Some(selection.rank(id)) } else { self.lists.index(kind).row_of(id) };
            if let Some(row) = row {
                self.lists.states[slot(kind)].reveal(row);
            }
        }
        let Some(mesh) = self.editor.mesh() else { return };
        let mut state = std::mem::take(&mut self.lists.states[slot(kind)]);
        let index = self.lists.index(kind);
        let id_of = |at: usize| if only { selection.nth(at) } else { index.id_of(at) };
        let hovered = self.view.hovered().filter(|(hovered, _)| *hovered == kind).map(|(_, id)| id);
        let label = plural(kind);
        let list = RowList {
            label,
            columns: columns(kind),
            rows,
            row_height: if ui.spacing().interact_size.y >= theme::TOUCH_TARGET { 30.0 } else { 20.0 },
        };
        let output = list.show(ui, &mut state, |at| {
            let id = id_of(at)?;
            let row = row(mesh, kind, id)?;
            Some(RowContent {
                name: element_name(kind, id),
                value: row.value(kind),
                selected: own && selection.contains(kind, id),
                hovered: hovered == Some(id),
                row,
            })
        });
        let picked = output.picked.and_then(|picked| Some((picked, id_of(picked.row)?)));
        let under_pointer = output.hovered.and_then(id_of);
        let context = output.context.and_then(id_of);
        self.lists.states[slot(kind)] = state;
        self.view.hover_from_list(under_pointer.map(|id| (kind, id)));
        if let Some((picked, id)) = picked {
            self.pick_row(kind, picked, id);
        }
        if let Some(id) = context.filter(|&id| !self.editor.selection().contains(kind, id)) {
            self.select(kind, [id], SelectMode::Replace);
            self.lists.reveal = false;
        }
        output.response.context_menu(|ui| self.element_menu(ui));
    }

    fn pick_row(&mut self, kind: Element, picked: Picked, id: u32) {
        if picked.extend
            && self.editor.selection().kind() == kind
            && self.editor.selection().latest().is_some()
        {
            // With the selection alone in the list there is nothing between that isn't selected.
            if self.editor.select_range(kind, id).is_ok() {
                self.follow();
            }
        } else {
            let mode = if picked.toggle { SelectMode::Toggle } else { SelectMode::Replace };
            // In a list of the selection a plain click would empty the list under the pointer.
            if self.lists.only_selected && mode == SelectMode::Replace {
                self.select(kind, [id], SelectMode::Extend);
            } else {
                self.select(kind, [id], mode);
            }
        }
        // The row is where the person clicked: it is in view already.
        self.lists.reveal = false;
    }

    fn empty_list(&self, ui: &mut Ui, kind: Element, only: bool) {
        ui.add_space(24.0);
        ui.vertical_centered(|ui| {
            let (title, hint) = if only {
                (
                    format!("No {kind} is selected"),
                    "Click one in the viewport, or turn off “Only selected” to see all.".to_owned(),
                )
            } else if crate::bezier::active(&self.editor).is_some() {
                (
                    format!("A curve has no {}", plural(kind).to_lowercase()),
                    "It has control points, which the inspector lists.".to_owned(),
                )
            } else if self.editor.document().objects().is_empty() {
                (
                    "No mesh".to_owned(),
                    "Drop an OBJ file on the page, paste its text, or make a shape.".to_owned(),
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

    /// What a right click on elements offers: what applies to them.
    pub(crate) fn element_menu(&mut self, ui: &mut Ui) {
        ui.set_min_width(200.0);
        let kind = self.editor.selection().kind();
        for id in actions::mesh_operations().filter(|id| id.spec().applies_to(kind)) {
            self.menu_item(ui, &actions::of_operation(id));
        }
        ui.separator();
        for action in [Action::Frame, Action::SelectAll, Action::SelectNone, Action::SelectInverse] {
            self.menu_item(ui, &actions::describe(action));
        }
    }
}
