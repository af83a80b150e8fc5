//! The list of objects, shown when a document has more than one.

use editor::ops::{ActivateObject, DeleteObject, RenameObject, SetObjectVisible};
use editor::{Command, Object};
use egui::{Button, RichText, ScrollArea, Ui, vec2};

use crate::page_view::Page;
use crate::request::Requests;
use crate::widgets::controls::text_field;
use crate::widgets::icon_button::icon_button;
use crate::widgets::icons::Icon;
use halfedge::words::thousands;

/// The object whose name is being typed.
#[derive(Default)]
pub(crate) struct Renaming {
    row: Option<(usize, String)>,
    focus: bool,
}

pub(crate) fn show(ui: &mut Ui, page: &Page<'_>, own: &mut Renaming, out: &mut Requests) {
    if page.editor.document().objects().len() < 2 {
        return;
    }
    ui.add_space(4.0);
    ui.label(RichText::new("Objects").strong());
    let objects = page.editor.document().objects();
    let active = page.editor.document().active_index();
    let height = ui.spacing().interact_size.y + ui.spacing().item_spacing.y;
    ScrollArea::vertical().id_salt("objects").max_height(6.0 * height).auto_shrink([false, true]).show_rows(
        ui,
        ui.spacing().interact_size.y,
        objects.len(),
        |ui, range| {
            for at in range {
                if let Some(object) = objects.get(at) {
                    object_row(ui, at, object, at == active, own, out);
                }
            }
        },
    );
    ui.separator();
}

fn object_row(ui: &mut Ui, at: usize, object: &Object, active: bool, own: &mut Renaming, out: &mut Requests) {
    let (name, visible, faces) = (object.name(), object.visible(), object.mesh().face_count());
    ui.horizontal(|ui| {
        let (icon, verb) = if visible { (Icon::Eye, "Hide") } else { (Icon::EyeClosed, "Show") };
        let eye = icon_button(ui, icon, &format!("{verb} {name}"), false)
            .on_hover_text(format!("{verb} this object"));
        if eye.clicked() {
            out.run(Command::from(SetObjectVisible { visible: !visible }).on(at));
        }
        if let Some((row, text)) = &mut own.row
            && *row == at
        {
            let field = ui
                .add(text_field(text).desired_width((ui.available_width() - 30.0).max(0.0)))
                .accessible_name("Object name");
            if own.focus {
                own.focus = false;
                field.request_focus();
            }
            if field.lost_focus() {
                let text = text.clone();
                own.row = None;
                let kept = ui.input(|input| !input.key_pressed(egui::Key::Escape));
                if kept && !text.trim().is_empty() && text != name {
                    out.run(Command::from(RenameObject { name: text }).on(at));
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
            .on_hover_text("Click to edit, double-click to rename; the number counts the faces");
        if row.double_clicked() {
            own.row = Some((at, name.to_owned()));
            own.focus = true;
        } else if row.clicked() && !active {
            out.run(Command::from(ActivateObject::default()).on(at));
        }
        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
            let delete = icon_button(ui, Icon::Delete, &format!("Delete {name}"), false)
                .on_hover_text("Delete this object");
            if delete.clicked() {
                out.run(Command::from(DeleteObject::default()).on(at));
            }
        });
    });
}
