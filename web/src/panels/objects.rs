//! The list of objects, shown when a document has more than one.

use editor::Command;
use editor::ops::{ActivateObject, DeleteObject, RenameObject, SetObjectVisible};
use egui::{Button, RichText, ScrollArea, TextEdit, Ui, vec2};

use crate::app::App;
use crate::icons::{Icon, icon_button};
use crate::lists::columns::thousands;

impl App {
    pub(crate) fn objects(&mut self, ui: &mut Ui) {
        if self.editor.document().objects().len() < 2 {
            return;
        }
        ui.add_space(4.0);
        ui.label(RichText::new("Objects").strong());
        let rows: Vec<(String, bool, usize)> = self
            .editor
            .document()
            .objects()
            .iter()
            .map(|object| (object.name().to_owned(), object.visible(), object.mesh().face_count()))
            .collect();
        let active = self.editor.document().active_index();
        let height = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
        ScrollArea::vertical()
            .id_salt("objects")
            .max_height(6.0 * height)
            .auto_shrink([false, true])
            .show_rows(ui, ui.spacing().interact_size.y, rows.len(), |ui, range| {
                for at in range {
                    if let Some((name, visible, faces)) = rows.get(at) {
                        self.object_row(ui, at, name, *visible, *faces, at == active);
                    }
                }
            });
        ui.separator();
    }

    fn object_row(&mut self, ui: &mut Ui, at: usize, name: &str, visible: bool, faces: usize, active: bool) {
        ui.horizontal(|ui| {
            let (icon, verb) = if visible { (Icon::Eye, "Hide") } else { (Icon::EyeClosed, "Show") };
            let eye = icon_button(ui, icon, &format!("{verb} {name}"), false)
                .on_hover_text(format!("{verb} this object"));
            if eye.clicked() {
                self.begin(Command::from(SetObjectVisible { visible: !visible }).on(at), None);
            }
            if let Some((row, text)) = &mut self.forms.renaming
                && *row == at
            {
                let field = ui
                    .add(TextEdit::singleline(text).desired_width(ui.available_width() - 30.0))
                    .accessible_name("Object name");
                if self.forms.focus_renaming {
                    self.forms.focus_renaming = false;
                    field.request_focus();
                }
                if field.lost_focus() {
                    let text = text.clone();
                    self.forms.renaming = None;
                    let kept = ui.input(|input| !input.key_pressed(egui::Key::Escape));
                    if kept && !text.trim().is_empty() && text != name {
                        self.begin(Command::from(RenameObject { name: text }).on(at), None);
                    }
                }
                return;
            }
            let width = (ui.available_width() - 36.0).max(60.0);
            let button = Button::selectable(active, name)
                .truncate()
                .shortcut_text(thousands(faces))
                .min_size(vec2(width, 0.0));
            let row = ui
                .add_sized(vec2(width, ui.spacing().interact_size.y), button)
                .accessible_name(name)
                .on_hover_text(
                    "Click to edit this object; double-click to rename it. The number is its faces.",
                );
            if row.double_clicked() {
                self.forms.renaming = Some((at, name.to_owned()));
                self.forms.focus_renaming = true;
            } else if row.clicked() && !active {
                self.begin(Command::from(ActivateObject::default()).on(at), None);
            }
            ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                let delete = icon_button(ui, Icon::Delete, &format!("Delete {name}"), false)
                    .on_hover_text("Delete this object");
                if delete.clicked() {
                    self.begin(Command::from(DeleteObject::default()).on(at), None);
                }
            });
        });
    }
}
