//! The inspector: everything about the selected element, and what can be done with it.

mod edge;
mod face;
mod halfedge;
mod vertex;

use ::halfedge::Element;
use editor::{OpId, SelectMode};
use egui::{Button, Grid, Label, RichText, Ui, vec2};

use crate::actions::{self, Action};
use crate::app::App;
use crate::availability::opens_form;
use crate::lists::columns::element_name;
use crate::panels::fields;
use crate::panels::menu_bar::explain;
use crate::theme::TOUCH_TARGET;

/// Operations that the inspector has controls of its own for, further up.
const SHOWN_ALREADY: [OpId; 3] = [OpId::SetVertexPosition, OpId::SetFaceColor, OpId::SplitEdge];

impl App {
    pub(crate) fn inspector(&mut self, ui: &mut Ui) {
        ui.add_space(4.0);
        self.bezier_panel(ui);
        let selection = self.editor.selection();
        let (kind, count) = (selection.kind(), selection.len());
        let latest = selection.latest();
        let Some(id) = latest else {
            if crate::bezier::active(&self.editor).is_none() {
                self.empty_inspector(ui);
            }
            return;
        };
        ui.horizontal(|ui| {
            ui.label(RichText::new(element_name(kind, id)).heading());
            if count > 1 {
                let more = format!("and {} more", crate::lists::columns::thousands(count - 1));
                ui.label(RichText::new(more).weak())
                    .on_hover_text(fields::selection_words(kind, count, latest));
            }
        });
        ui.add_space(2.0);
        match kind {
            Element::Vertex => self.inspect_vertex(ui, id),
            Element::Edge => self.inspect_edge(ui, id),
            Element::Halfedge => self.inspect_halfedge(ui, id),
            Element::Face => self.inspect_face(ui, id),
        }
        ui.add_space(6.0);
        self.edit_buttons(ui, kind);
    }

    fn empty_inspector(&self, ui: &mut Ui) {
        ui.label(RichText::new("Inspector").heading());
        let hint = if self.editor.document().objects().is_empty() {
            "Drop an OBJ file on the page, press Ctrl+O, or make a shape below."
        } else {
            "Nothing is selected. Click an element in the viewport or in a list to see and edit its numbers."
        };
        ui.add(Label::new(RichText::new(hint).weak()).wrap());
    }

    /// One button for each operation that works on this kind, greyed with the reason where this
    /// element is none it works on.
    fn edit_buttons(&mut self, ui: &mut Ui, kind: Element) {
        let ids: Vec<OpId> = actions::mesh_operations()
            .filter(|id| id.spec().applies_to(kind) && !SHOWN_ALREADY.contains(id))
            .collect();
        if ids.is_empty() {
            return;
        }
        ui.horizontal_wrapped(|ui| {
            for id in ids {
                let action = Action::Operation(id);
                let why_not = self.why_not(action);
                let label = id.spec().label;
                let label = if opens_form(id) { format!("{label}…") } else { label.to_owned() };
                let button = ui.add_enabled(why_not.is_none(), Button::new(label));
                if explain(button, ui, &actions::of_operation(id), why_not.as_deref()).clicked() {
                    self.act(action);
                }
            }
        });
    }

    /// A name and a value in the inspector's table.
    fn fact(&self, ui: &mut Ui, name: &str, value: impl Into<String>, meaning: &str) {
        ui.label(RichText::new(name).weak()).on_hover_text(meaning);
        ui.add(Label::new(RichText::new(value).monospace()).selectable(true));
        ui.end_row();
    }

    /// A name and a link that selects what it points to.
    fn pointer(&mut self, ui: &mut Ui, name: &str, to: Option<(Element, u32)>, none: &str, meaning: &str) {
        ui.label(RichText::new(name).weak()).on_hover_text(meaning);
        match to {
            Some((kind, id)) => self.link(ui, name, kind, id),
            None => {
                ui.label(RichText::new(none).weak());
            }
        }
        ui.end_row();
    }

    /// A link that selects an element; the viewport shows it while the pointer is over the link.
    fn link(&mut self, ui: &mut Ui, name: &str, kind: Element, id: u32) {
        let text = element_name(kind, id);
        let link = ui.link(&text).on_hover_text(format!("Select {}", text.to_lowercase()));
        link.clone().accessible_name(format!("{name}: {text}"));
        if link.hovered() {
            self.view.hover_from_list(Some((kind, id)));
        }
        if link.clicked() {
            self.select(kind, [id], SelectMode::Replace);
        }
    }

    /// Links to several elements, in lines as wide as the panel.
    fn links(&mut self, ui: &mut Ui, name: &str, kind: Element, ids: &[u32]) {
        /// More would push everything else off the panel.
        const MOST: usize = 24;
        ui.label(RichText::new(format!("{name} ({})", ids.len())).weak());
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = vec2(6.0, 2.0);
            for &id in ids.iter().take(MOST) {
                let link = ui.link(RichText::new(id.to_string()).monospace());
                link.clone().accessible_name(element_name(kind, id));
                if link.hovered() {
                    self.view.hover_from_list(Some((kind, id)));
                }
                if link.on_hover_text(format!("Select {kind} {id}")).clicked() {
                    self.select(kind, [id], SelectMode::Replace);
                }
            }
            if ids.len() > MOST {
                ui.label(RichText::new("…").weak());
            }
        });
    }
}

/// The table of the inspector.
fn facts(ui: &mut Ui, name: &str, add: impl FnOnce(&mut Ui)) {
    let row = if ui.spacing().interact_size.y < TOUCH_TARGET { 18.0 } else { 28.0 };
    Grid::new(name)
        .num_columns(2)
        .spacing(vec2(14.0, 4.0))
        .min_col_width(76.0)
        .min_row_height(row)
        .show(ui, add);
}

/// A measured number with as many digits as are worth reading.
fn measured(value: f32) -> String {
    let size = value.abs();
    if size != 0.0 && !(1e-4..1e7).contains(&size) { format!("{value:.5e}") } else { format!("{value:.6}") }
}
