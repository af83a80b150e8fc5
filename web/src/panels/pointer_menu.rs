//! Menus that open at the pointer: the edits of vertices, edges or faces, the looks, and what the 3D cursor is for.

use egui::{Align, Context, Id, LayerId, Layout, Popup, PopupKind, Pos2, SetOpenCommand};

use crate::input::actions::{self, Action, Entry};
use crate::page_view::Page;
use crate::panels::menu_bar::menu_item;
use crate::request::Requests;

/// Which menu is open, and where.
#[derive(Debug)]
pub(crate) struct PointerMenu {
    /// The action that opened it.
    action: Action,
    at: Pos2,
    opens: bool,
}

impl Default for PointerMenu {
    fn default() -> Self {
        Self { action: Action::LookMenu, at: Pos2::ZERO, opens: false }
    }
}

impl PointerMenu {
    /// Opens the menu of an action at a place on the page.
    pub fn open(&mut self, action: Action, at: Pos2) {
        *self = Self { action, at, opens: true };
    }
}

/// What the menu of an action lists.
fn entries(action: Action) -> Vec<Entry> {
    let of_menus = |wanted: fn(Action) -> bool| actions::all().filter(|entry| wanted(entry.action)).collect();
    match action {
        Action::ElementMenu(kind) => actions::edits_of(kind).into_iter().map(actions::of_operation).collect(),
        Action::CursorMenu => of_menus(|action| matches!(action, Action::Cursor(_))),
        _ => of_menus(|action| {
            matches!(action, Action::Wireframe | Action::XRay | Action::Smooth | Action::Look(_))
        }),
    }
}

/// Shows the menu while it is open.
pub(crate) fn show(ctx: &Context, page: &Page<'_>, own: &mut PointerMenu, out: &mut Requests) {
    let opens = std::mem::take(&mut own.opens).then_some(SetOpenCommand::Bool(true));
    Popup::new(Id::unique("pointer menu"), ctx.clone(), own.at, LayerId::background())
        .kind(PopupKind::Menu)
        .layout(Layout::top_down_justified(Align::Min))
        .style(egui::containers::menu::menu_style)
        .accessible_name(actions::describe(own.action).label)
        .open_memory(opens)
        .show(|ui| {
            ui.set_min_width(200.0);
            for entry in entries(own.action) {
                menu_item(ui, page, &entry, out);
            }
        });
}
