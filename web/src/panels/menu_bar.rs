//! The bar at the top: menus, the toolbar, and the document's name.

use editor::{OpId, Scope};
use egui::{Align, Button, Layout, MenuBar, Response, RichText, Ui};
use halfedge::Element;

use crate::actions::{self, Action, Entry, MENUS, Menu};
use crate::app::App;
use crate::availability::opens_form;
use crate::icons::{Icon, icon_button};
use crate::{keys, theme};

/// The toolbar's buttons; none is a gap.
const TOOLS: &[Option<(Icon, Action)>] = &[
    Some((Icon::Open, Action::Open)),
    Some((Icon::Save, Action::Save)),
    None,
    Some((Icon::Undo, Action::Undo)),
    Some((Icon::Redo, Action::Redo)),
    None,
    Some((Icon::Frame, Action::Frame)),
    Some((Icon::BoxSelect, Action::BoxSelect)),
    None,
    Some((Icon::Wireframe, Action::Wireframe)),
    Some((Icon::Smooth, Action::Smooth)),
    Some((Icon::Info, Action::Overlay)),
    None,
    Some((Icon::Subdivide, Action::Upsample)),
    Some((Icon::Search, Action::Palette)),
];

impl App {
    pub(crate) fn menu_bar(&mut self, ui: &mut Ui, narrow: bool) {
        if narrow {
            theme::for_fingers(ui);
        }
        MenuBar::new().ui(ui, |ui| {
            if narrow {
                let button = icon_button(ui, Icon::Menu, "Menu", false).on_hover_text("All menus");
                egui::Popup::menu(&button).show(|ui| {
                    for menu in MENUS {
                        ui.menu_button(menu.title, |ui| self.menu(ui, menu));
                    }
                });
                self.toolbar(
                    ui,
                    &[
                        Action::Open,
                        Action::Save,
                        Action::Undo,
                        Action::Redo,
                        Action::Frame,
                        Action::BoxSelect,
                        Action::Upsample,
                    ],
                );
            } else {
                for menu in MENUS {
                    ui.menu_button(menu.title, |ui| self.menu(ui, menu));
                }
                ui.separator();
                self.toolbar(ui, &[]);
                ui.with_layout(Layout::right_to_left(Align::Center), |ui| self.title(ui));
            }
        });
    }

    /// The toolbar, or only some of its buttons.
    fn toolbar(&mut self, ui: &mut Ui, only: &[Action]) {
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
            let why_not = self.why_not(action);
            let on = self.is_on(action).unwrap_or(false);
            let button =
                ui.add_enabled_ui(why_not.is_none(), |ui| icon_button(ui, icon, entry.label, on)).inner;
            if explain(button, ui, &entry, why_not.as_deref()).clicked() {
                self.act(action);
            }
        }
    }

    fn title(&mut self, ui: &mut Ui) {
        let document = self.editor.document();
        let changed = self.editor.is_dirty();
        let name = if changed { format!("{} •", document.name()) } else { document.name().to_owned() };
        let hint = if changed { "The document has changes that were not saved" } else { "The document" };
        ui.add(egui::Label::new(RichText::new(name).strong()).truncate()).on_hover_text(hint);
    }

    pub(crate) fn menu(&mut self, ui: &mut Ui, menu: &Menu) {
        ui.set_min_width(220.0);
        for entry in menu.entries {
            match entry {
                None => {
                    ui.separator();
                }
                Some(entry) => self.menu_item(ui, entry),
            }
        }
        match menu.title {
            "File" => {
                ui.menu_button("Save as", |ui| {
                    ui.set_min_width(200.0);
                    for entry in actions::formats() {
                        self.menu_item(ui, &entry);
                    }
                });
            }
            "Mesh" => self.operation_menus(ui),
            _ => {}
        }
    }

    /// The editor's operations: those on whole meshes one by one, local ones by what they work on.
    fn operation_menus(&mut self, ui: &mut Ui) {
        let of_scope = |scope| actions::mesh_operations().filter(move |id| id.spec().scope == scope);
        for id in of_scope(Scope::Meshes) {
            self.menu_item(ui, &actions::of_operation(id));
        }
        ui.separator();
        for (kind, title) in
            [(Element::Vertex, "Vertex edits"), (Element::Edge, "Edge edits"), (Element::Face, "Face edits")]
        {
            ui.menu_button(title, |ui| {
                ui.set_min_width(220.0);
                let is_listed = |id: &OpId| id.spec().element().unwrap_or(Element::Face) == kind;
                for id in of_scope(Scope::Elements).filter(is_listed) {
                    self.menu_item(ui, &actions::of_operation(id));
                }
            });
        }
    }

    /// One entry of a menu, greyed with its reason where it can't be done.
    pub(crate) fn menu_item(&mut self, ui: &mut Ui, entry: &Entry) {
        let why_not = self.why_not(entry.action);
        let keys = keys::text(ui.ctx(), entry.action);
        let label = match entry.action {
            // What opens a form instead of acting at once ends in an ellipsis.
            Action::Operation(id) if opens_form(id) => format!("{}…", entry.label),
            _ => entry.label.to_owned(),
        };
        let response = match self.is_on(entry.action) {
            Some(mut on) => {
                ui.add_enabled(why_not.is_none(), egui::Checkbox::new(&mut on, menu_text(ui, &label, &keys)))
            }
            None => {
                let button = Button::new(label);
                let button = if keys.is_empty() { button } else { button.shortcut_text(keys) };
                ui.add_enabled(why_not.is_none(), button)
            }
        };
        if explain(response, ui, entry, why_not.as_deref()).clicked() {
            self.act(entry.action);
            ui.close();
        }
    }
}

/// A switch's name with its key behind it: check boxes have no place of their own for keys.
fn menu_text(ui: &Ui, label: &str, keys: &str) -> egui::text::LayoutJob {
    let mut job = egui::text::LayoutJob::default();
    let font = egui::TextStyle::Button.resolve(ui.style());
    job.append(label, 0.0, egui::TextFormat::simple(font.clone(), egui::Color32::PLACEHOLDER));
    if !keys.is_empty() {
        job.append(keys, 12.0, egui::TextFormat::simple(font, ui.visuals().weak_text_color()));
    }
    job
}

/// Adds the tooltip: what the thing does and its key, or why it can't be done.
pub(crate) fn explain(response: Response, ui: &Ui, entry: &Entry, why_not: Option<&str>) -> Response {
    if let Some(reason) = why_not {
        let reason = reason.to_owned();
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_description(reason.clone()));
        return response.on_disabled_hover_ui(|ui| {
            ui.label(RichText::new(entry.label).strong());
            ui.label(entry.description);
            ui.colored_label(ui.visuals().warn_fg_color, reason);
        });
    }
    response.on_hover_ui(|ui| {
        let keys = keys::text(ui.ctx(), entry.action);
        let title =
            if keys.is_empty() { entry.label.to_owned() } else { format!("{} ({keys})", entry.label) };
        ui.label(RichText::new(title).strong());
        ui.label(entry.description);
    })
}
