//! The window with the named selections of the active object.

use editor::ops::{DeleteNamedSelection, NameSelection, RenameNamedSelection, SelectMode, SelectNamed};
use editor::{NamedSelection, OpId};
use egui::{Button, Context, Key, RichText, ScrollArea, TextEdit, Ui};
use halfedge::words::counted;

use crate::page_view::Page;
use crate::request::{Request, Requests};
use crate::widgets::icon_button::icon_button;
use crate::widgets::icons::Icon;
use crate::widgets::window::centred;

/// What is being typed.
#[derive(Default)]
pub(crate) struct Naming {
    new: String,
    /// The selection that is being renamed, and the text so far.
    renaming: Option<(usize, String)>,
}

pub(crate) fn show(ctx: &Context, page: &Page<'_>, own: &mut Naming, out: &mut Requests) {
    let mut open = page.shown.named;
    let screen = ctx.content_rect();
    centred(ctx, "Named selections")
        .open(&mut open)
        .default_width(340.0_f32.min(screen.width() - 48.0))
        .show(ctx, |ui| {
            new_row(ui, page, own, out);
            ui.separator();
            list(ui, page, own, out);
        });
    if !open && page.shown.named {
        out.push(Request::Close(crate::shown::Window::Named));
    }
}

/// The field and the button that keep the selection under a name.
fn new_row(ui: &mut Ui, page: &Page<'_>, own: &mut Naming, out: &mut Requests) {
    ui.horizontal(|ui| {
        let field =
            TextEdit::singleline(&mut own.new).hint_text("Name of the selection").desired_width(190.0);
        let field = ui.add(field).accessible_name("Name of the selection");
        let why_not = match page.editor.selection() {
            selection if selection.is_empty() => Some("Select something first."),
            _ if own.new.trim().is_empty() => Some("Type a name first."),
            _ => None,
        };
        let button = ui.add_enabled(why_not.is_none(), Button::new("Save selection"));
        let button = button
            .on_hover_text(OpId::NameSelection.spec().description)
            .on_disabled_hover_text(why_not.unwrap_or_default());
        let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        if button.clicked() || (entered && why_not.is_none()) {
            out.run(NameSelection { name: std::mem::take(&mut own.new) });
        }
    });
}

fn list(ui: &mut Ui, page: &Page<'_>, own: &mut Naming, out: &mut Requests) {
    let named = page.editor.document().active().map_or(&[][..], |object| object.named_selections());
    if named.is_empty() {
        ui.label(
            RichText::new("No selection has a name yet. Select elements, type a name and save it.").weak(),
        );
        return;
    }
    ScrollArea::vertical().max_height(320.0).auto_shrink([false, true]).show(ui, |ui| {
        for (at, named) in named.iter().enumerate() {
            ui.push_id(at, |ui| ui.horizontal(|ui| row(ui, at, named, own, out)));
        }
    });
}

fn row(ui: &mut Ui, at: usize, named: &NamedSelection, own: &mut Naming, out: &mut Requests) {
    let NamedSelection { name, selection } = named;
    let mut text = match &own.renaming {
        Some((renamed, text)) if *renamed == at => text.clone(),
        _ => name.clone(),
    };
    let field = ui
        .add(TextEdit::singleline(&mut text).desired_width(120.0))
        .accessible_name(format!("Name of {name}"))
        .on_hover_text("Type another name and press Enter");
    if field.changed() {
        own.renaming = Some((at, text.clone()));
    }
    if field.lost_focus() && own.renaming.take().is_some() {
        let kept = ui.input(|input| !input.key_pressed(Key::Escape));
        if kept && !text.trim().is_empty() && text.trim() != name {
            out.run(RenameNamedSelection { name: name.clone(), to: text });
        }
    }
    let (one, many) = (selection.kind().to_string(), selection.kind().plural());
    ui.label(RichText::new(counted(selection.len(), &one, many)).small().weak());
    ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
        let delete = icon_button(ui, Icon::Delete, &format!("Delete {name}"), false);
        if delete.on_hover_text(OpId::DeleteNamedSelection.spec().description).clicked() {
            out.run(DeleteNamedSelection { name: name.clone() });
        }
        for (label, verb, mode) in [
            ("Add", "Add to the selection", SelectMode::Extend),
            ("Select", "Select instead", SelectMode::Replace),
        ] {
            let button = ui.button(label).accessible_name(format!("{label} {name}"));
            if button.on_hover_text(format!("{verb}: the elements of “{name}”")).clicked() {
                out.run(SelectNamed { name: name.clone(), mode });
            }
        }
    });
}
