//! Menus of the edits of vertices, edges or faces, which open at the pointer.

use egui::{Align, Context, Id, LayerId, Layout, Popup, PopupKind, Pos2, SetOpenCommand};
use halfedge::Element;

use crate::input::actions::{self, Action};
use crate::page_view::Page;
use crate::panels::menu_bar::menu_item;
use crate::request::Requests;

/// Which menu is open, and where.
#[derive(Debug)]
pub(crate) struct ElementMenu {
    kind: Element,
    at: Pos2,
    opens: bool,
}

impl Default for ElementMenu {
    fn default() -> Self {
        Self { kind: Element::Vertex, at: Pos2::ZERO, opens: false }
    }
}

impl ElementMenu {
    /// Opens the menu of a kind of element at a place on the page.
    pub fn open(&mut self, kind: Element, at: Pos2) {
        *self = Self { kind, at, opens: true };
    }
}

/// Shows the menu while it is open.
pub(crate) fn show(ctx: &Context, page: &Page<'_>, own: &mut ElementMenu, out: &mut Requests) {
    let opens = std::mem::take(&mut own.opens).then_some(SetOpenCommand::Bool(true));
    Popup::new(Id::unique("element menu"), ctx.clone(), own.at, LayerId::background())
        .kind(PopupKind::Menu)
        .layout(Layout::top_down_justified(Align::Min))
        .style(egui::containers::menu::menu_style)
        .accessible_name(actions::describe(Action::ElementMenu(own.kind)).label)
        .open_memory(opens)
        .show(|ui| {
            ui.set_min_width(200.0);
            for id in actions::edits_of(own.kind) {
                menu_item(ui, page, &actions::of_operation(id), out);
            }
        });
}
