//! The narrow layout: the panels are tabs of a sheet at the bottom, below the viewport.

use egui::{Button, Panel, Ui, vec2};

use super::panels::Panels;
use crate::page_view::Page;
use crate::panels::{inspector, operation_list, operations};
use crate::request::{Request, Requests};
use crate::shown::{Sheet, Tab};
use crate::theme;

pub(crate) fn show(ui: &mut Ui, page: &Page<'_>, panels: &mut Panels, out: &mut Requests) {
    // A form needs room for its fields between its heading and its buttons.
    let has_form = page.shown.sheet.tab == Tab::Operations && panels.forms.is_open();
    let tall = ui.available_height() * if has_form { 0.6 } else { 0.46 };
    let panel = Panel::bottom("sheet").resizable(false);
    let panel = if page.shown.sheet.closed { panel } else { panel.exact_size(tall) };
    panel.show(ui, |ui| {
        sheet_tabs(ui, page, out);
        if page.shown.sheet.closed {
            return;
        }
        match page.shown.sheet.tab {
            Tab::Lists => {
                panels.left(ui, page, out);
            }
            Tab::Inspector => {
                egui::ScrollArea::vertical().id_salt("sheet inspector").auto_shrink([false, false]).show(
                    ui,
                    |ui| {
                        inspector::show(ui, page, &mut panels.inspector, out);
                        operation_list::of_selection(ui, page, panels.forms.list(), out);
                    },
                );
            }
            // A form has its own area that scrolls.
            Tab::Operations if panels.forms.is_open() => operations::show(ui, page, &mut panels.forms, out),
            Tab::Operations => {
                egui::ScrollArea::vertical().id_salt("sheet operations").auto_shrink([false, false]).show(
                    ui,
                    |ui| {
                        operations::adjust(ui, page, &mut panels.forms, out);
                        operations::show(ui, page, &mut panels.forms, out);
                    },
                );
            }
            Tab::History => panels.history.list(ui, page, out),
        }
    });
}

fn sheet_tabs(ui: &mut Ui, page: &Page<'_>, out: &mut Requests) {
    ui.horizontal(|ui| {
        ui.ctx().accesskit_node_builder(ui.unique_id(), |node| {
            node.set_role(egui::Role::TabList);
            node.set_label("Panels");
        });
        ui.spacing_mut().item_spacing.x = 2.0;
        let width = ((ui.available_width() - 4.0 * 2.0) / 4.0).max(0.0);
        for (tab, label, hint) in [
            (Tab::Lists, "Elements", "Vertices, edges, half-edges and faces"),
            (Tab::Inspector, "Inspector", "The selected element"),
            (Tab::Operations, "Operations", "New shapes, subdivision and more"),
            (Tab::History, "History", "The steps by name; tap one to go to it"),
        ] {
            let on = page.shown.sheet.tab == tab && !page.shown.sheet.closed;
            let button = Button::selectable(on, label);
            let response = ui.add_sized(vec2(width, theme::TOUCH_TARGET), button);
            ui.ctx().accesskit_node_builder(response.id, |node| {
                node.set_role(egui::Role::Tab);
                node.set_selected(on);
            });
            if response.on_hover_text(hint).clicked() {
                // The open tab's own button closes the sheet, which leaves the viewport its space.
                out.push(Request::ShowSheet(Sheet { tab, closed: on }));
            }
        }
    });
}
