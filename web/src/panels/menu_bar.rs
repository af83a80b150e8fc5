//! The bar at the top: the menus, the toolbar and the document's name.

use editor::{OpId, Scope};
use egui::accesskit::HasPopup;
use egui::{Align, Button, LayerId, Layout, MenuBar, Response, RichText, Role, ScrollArea, Ui};
use halfedge::Element;

use crate::input::actions::{self, Action, Entry};
use crate::input::availability::opens_form;
use crate::input::keys;
use crate::input::menus::{MENUS, Menu, MenuId, continued, is_in_submenu, submenu};
use crate::page_view::Page;
use crate::request::Requests;
use crate::widgets::icon_button::icon_button;
use crate::widgets::icons::Icon;

/// The part of the window's height that a menu leaves free, in points.
const MENU_MARGIN_POINTS: f32 = 64.0;

/// The toolbar's buttons; `None` is a gap.
const TOOLS: &[Option<(Icon, Action)>] = &[
    Some((Icon::Home, Action::Welcome)),
    Some((Icon::Open, Action::Open)),
    Some((Icon::Save, Action::Save)),
    None,
    Some((Icon::Undo, Action::Undo)),
    Some((Icon::Redo, Action::Redo)),
    None,
    Some((Icon::Frame, Action::Frame)),
    None,
    Some((Icon::Subdivide, Action::Upsample)),
    Some((Icon::Search, Action::Palette)),
];

pub(crate) fn show(ui: &mut Ui, page: &Page<'_>, narrow: bool, out: &mut Requests) {
    MenuBar::new().ui(ui, |ui| {
        ui.ctx().accesskit_node_builder(ui.unique_id(), |node| {
            node.set_role(Role::Toolbar);
            node.set_label("Menus and tools");
        });
        if narrow {
            let button = icon_button(ui, Icon::Menu, "Menu", false).on_hover_text("All menus");
            egui::Popup::menu(&button).show(|ui| {
                for menu in MENUS {
                    opens_menu(ui, menu.id.title(), |ui| show_menu(ui, page, menu, out));
                }
            });
            toolbar(
                ui,
                page,
                &[
                    Action::Open,
                    Action::Save,
                    Action::Undo,
                    Action::Redo,
                    Action::Frame,
                    Action::Upsample,
                    Action::Palette,
                ],
                out,
            );
        } else {
            for menu in MENUS {
                opens_menu(ui, menu.id.title(), |ui| show_menu(ui, page, menu, out));
            }
            ui.separator();
            toolbar(ui, page, &[], out);
            ui.with_layout(Layout::right_to_left(Align::Center), |ui| title(ui, page));
        }
    });
}

/// The toolbar, or only those of its buttons that are in `only`.
fn toolbar(ui: &mut Ui, page: &Page<'_>, only: &[Action], out: &mut Requests) {
    ui.spacing_mut().item_spacing.x = 2.0;
    for tool in TOOLS {
        let Some((icon, action)) = *tool else {
            if only.is_empty() {
                ui.add_space(6.0);
            }
            continue;
        };
        if !only.is_empty() && !only.contains(&action) {
            continue;
        }
        let entry = actions::describe(action);
        let why_not = page.why_not(action);
        let on = page.is_on(action).unwrap_or(false);
        let button = ui.add_enabled_ui(why_not.is_none(), |ui| icon_button(ui, icon, entry.label, on)).inner;
        if explain_as(&page.label_of(&entry), button, ui, &entry, why_not.as_deref()).clicked() {
            out.act(action);
        }
    }
}

fn title(ui: &mut Ui, page: &Page<'_>) {
    let document = page.editor.document();
    let changed = page.editor.is_dirty();
    let name = if changed { format!("{} •", document.name()) } else { document.name().to_owned() };
    let hint = if changed { "The document has unsaved changes" } else { "The document" };
    ui.add(egui::Label::new(RichText::new(name).strong()).truncate()).on_hover_text(hint);
}

/// A button that opens a menu.
fn opens_menu(ui: &mut Ui, title: &str, contents: impl FnOnce(&mut Ui)) {
    let below = ui.layer_id();
    let button = ui.menu_button(title, |ui| {
        keep_above(ui, below);
        contents(ui);
    });
    ui.ctx().accesskit_node_builder(button.response.id, |node| {
        node.set_has_popup(HasPopup::Menu);
        node.set_expanded(button.inner.is_some());
    });
}

/// Puts a menu's layer above the one that its button is in. egui itself does so when the button is pressed, but not where
/// the press brings the button's layer to the top in the same frame and the menu was below it when it was last open.
fn keep_above(ui: &Ui, below: LayerId) {
    let layer = ui.layer_id();
    let lowest = ui.memory(|memory| memory.layer_ids().find(|id| [layer, below].contains(id)));
    if lowest == Some(layer) {
        ui.ctx().move_to_top(layer);
        ui.ctx().request_repaint();
    }
}

/// A menu's entries, which scroll where the window is too low for all of them.
fn show_menu(ui: &mut Ui, page: &Page<'_>, menu: &Menu, out: &mut Requests) {
    let height = ui.ctx().content_rect().height() - MENU_MARGIN_POINTS;
    ScrollArea::vertical()
        .max_height(height)
        .min_scrolled_height(height)
        .show(ui, |ui| menu_entries(ui, page, menu, out));
}

fn menu_entries(ui: &mut Ui, page: &Page<'_>, menu: &Menu, out: &mut Requests) {
    ui.set_min_width(220.0);
    let submenu_of = |entry: &Option<Entry>| entry.and_then(|entry| submenu(entry.action));
    for entries in menu.entries.chunk_by(|a, b| submenu_of(a).is_some() && submenu_of(a) == submenu_of(b)) {
        let list = |ui: &mut Ui, out: &mut Requests| {
            for entry in entries {
                match entry {
                    None => {
                        ui.separator();
                    }
                    Some(entry) => menu_item(ui, page, entry, out),
                }
            }
        };
        match entries.first().and_then(submenu_of) {
            Some(title) => {
                opens_menu(ui, title, |ui| {
                    ui.set_min_width(180.0);
                    list(ui, out);
                    operations(ui, page, continued(title), out);
                });
            }
            None => list(ui, out),
        }
    }
    match menu.id {
        MenuId::File => {
            opens_menu(ui, "Save as", |ui| {
                ui.set_min_width(200.0);
                for entry in actions::formats() {
                    menu_item(ui, page, &entry, out);
                }
            });
        }
        MenuId::Select => {
            ui.separator();
            opens_menu(ui, "Hide and reveal", |ui| operations(ui, page, actions::hiding(), out));
        }
        MenuId::Mesh => operation_menus(ui, page, out),
        _ => {}
    }
}

fn operations(ui: &mut Ui, page: &Page<'_>, list: impl IntoIterator<Item = OpId>, out: &mut Requests) {
    for id in list {
        menu_item(ui, page, &actions::of_operation(id), out);
    }
}

/// The operations: those on whole meshes one by one, local ones by the kind of element.
fn operation_menus(ui: &mut Ui, page: &Page<'_>, out: &mut Requests) {
    let of_scope = |scope| actions::mesh_operations().filter(move |id| id.spec().scope == scope);
    for id in of_scope(Scope::Meshes).filter(|id| !is_in_submenu(*id)) {
        menu_item(ui, page, &actions::of_operation(id), out);
    }
    ui.separator();
    for (kind, title) in
        [(Element::Vertex, "Vertex edits"), (Element::Edge, "Edge edits"), (Element::Face, "Face edits")]
    {
        opens_menu(ui, title, |ui| {
            ui.set_min_width(220.0);
            let is_listed = |id: &OpId| id.spec().element().unwrap_or(Element::Face) == kind;
            for id in of_scope(Scope::Elements).filter(is_listed) {
                menu_item(ui, page, &actions::of_operation(id), out);
            }
        });
    }
}

/// A menu entry, greyed with the reason if it can't be done.
pub(crate) fn menu_item(ui: &mut Ui, page: &Page<'_>, entry: &Entry, out: &mut Requests) {
    let why_not = page.why_not(entry.action);
    let keys = keys::text(ui.ctx(), entry.action);
    let label = match entry.action {
        // An entry that opens a form ends with an ellipsis.
        Action::Operation(id) if opens_form(id) => format!("{}…", entry.label),
        _ => page.label_of(entry),
    };
    let response = match page.is_on(entry.action) {
        Some(mut on) => {
            let keys = RichText::new(keys).weak();
            let text = (RichText::new(label), egui::Atom::grow(), keys);
            ui.add_enabled(why_not.is_none(), egui::Checkbox::new(&mut on, text)).accessible_name(entry.label)
        }
        None => {
            let button = Button::new(label);
            let button = if keys.is_empty() { button } else { button.shortcut_text(keys) };
            ui.add_enabled(why_not.is_none(), button)
        }
    };
    if explain_as(&page.label_of(entry), response, ui, entry, why_not.as_deref()).clicked() {
        out.act(entry.action);
        ui.close();
    }
}

/// Adds a tooltip: the description and the key, or why the action can't be done.
pub(crate) fn explain(response: Response, ui: &Ui, entry: &Entry, why_not: Option<&str>) -> Response {
    explain_as(entry.label, response, ui, entry, why_not)
}

/// The same for an action that is called otherwise now.
fn explain_as(label: &str, response: Response, ui: &Ui, entry: &Entry, why_not: Option<&str>) -> Response {
    if let Some(reason) = why_not {
        let reason = reason.to_owned();
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_description(reason.clone()));
        return response.on_disabled_hover_ui(|ui| {
            ui.label(RichText::new(label).strong());
            ui.label(entry.description);
            ui.colored_label(ui.visuals().warn_fg_color, reason);
        });
    }
    response.on_hover_ui(|ui| {
        let keys = keys::text(ui.ctx(), entry.action);
        let title = if keys.is_empty() { label.to_owned() } else { format!("{label} ({keys})") };
        ui.label(RichText::new(title).strong());
        ui.label(entry.description);
    })
}
