//! The narrow layout: the panels as a sheet at the bottom with tabs, the viewport above it.

use egui::{Button, Panel, Ui, vec2};

use crate::app::App;
use crate::theme;

/// What the sheet shows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Tab {
    /// The lists.
    #[default]
    Lists,
    /// The inspector.
    Inspector,
    /// The operations.
    Operations,
}

/// The sheet: which tab, and whether it is pulled up.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Sheet {
    pub tab: Tab,
    pub closed: bool,
}

impl Sheet {
    pub fn show_lists(&mut self) {
        *self = Self { tab: Tab::Lists, closed: false };
    }

    pub fn show_operations(&mut self) {
        *self = Self { tab: Tab::Operations, closed: false };
    }
}

impl App {
    pub(crate) fn sheet(&mut self, ui: &mut Ui) {
        let tall = ui.available_height() * 0.46;
        let panel = Panel::bottom("sheet").resizable(false);
        let panel = if self.shown.sheet.closed { panel } else { panel.exact_size(tall) };
        panel.show(ui, |ui| {
            theme::for_fingers(ui);
            self.sheet_tabs(ui);
            if self.shown.sheet.closed {
                return;
            }
            match self.shown.sheet.tab {
                Tab::Lists => {
                    self.objects(ui);
                    self.elements(ui);
                }
                Tab::Inspector => {
                    egui::ScrollArea::vertical()
                        .id_salt("sheet inspector")
                        .auto_shrink([false, false])
                        .show(ui, |ui| self.inspector(ui));
                }
                Tab::Operations => {
                    egui::ScrollArea::vertical()
                        .id_salt("sheet operations")
                        .auto_shrink([false, false])
                        .show(ui, |ui| self.operations(ui));
                }
            }
        });
    }

    fn sheet_tabs(&mut self, ui: &mut Ui) {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 2.0;
            let width = (ui.available_width() - 3.0 * 2.0) / 3.0;
            for (tab, label, hint) in [
                (Tab::Lists, "Elements", "Vertices, edges, half-edges and faces"),
                (Tab::Inspector, "Inspector", "The selected element"),
                (Tab::Operations, "Operations", "New shapes, subdivision and more"),
            ] {
                let on = self.shown.sheet.tab == tab && !self.shown.sheet.closed;
                let button = Button::selectable(on, label);
                let response = ui.add_sized(vec2(width, theme::TOUCH_TARGET), button);
                ui.ctx().accesskit_node_builder(response.id, |node| {
                    node.set_role(egui::Role::Tab);
                    node.set_selected(on);
                });
                if response.on_hover_text(hint).clicked() {
                    // The open tab's own button puts the sheet away, so that the viewport has the room.
                    self.shown.sheet = Sheet { tab, closed: on };
                }
            }
        });
    }
}
