//! The save dialog: a file name, a format, and what the format can't hold of the document.

use editor::{Changes, Document};
use egui::text_selection::CCursorRange;
use egui::{
    Align2, Button, ComboBox, Context, Frame, Grid, Id, Key, Label, Modal, RichText, ScrollArea, TextEdit,
    Ui, vec2,
};
use formats::Format;

use crate::input::actions::{self, Action};
use crate::page_view::Page;
use crate::platform::Platform;
use crate::request::{Request, Requests};
use crate::theme;
use crate::widgets::controls::{primary_button, text_field};

/// The key of the setting with the last saved format's code.
pub(crate) const FORMAT_SETTING: &str = "format";

/// The dialog's state.
pub(crate) struct Saving {
    stage: Stage,
    name: String,
    /// The name of a document, and the name under which it was last saved.
    last_saved: Option<(String, String)>,
    format: Format,
    /// What the format can't hold of the current document; none until computed.
    losses: Option<(Format, Vec<String>)>,
}

/// The progress of opening the dialog.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Stage {
    Closed,
    /// The name field is yet to be focused.
    Opening,
    /// The name is yet to be selected, so that typing replaces it.
    Focusing,
    Open,
}

impl Saving {
    pub fn new(platform: &dyn Platform) -> Self {
        let format = platform.load_setting(FORMAT_SETTING).and_then(|kept| Format::from_code(&kept));
        let format = format.filter(|format| format.can_save()).unwrap_or_default();
        Self { stage: Stage::Closed, name: String::new(), last_saved: None, format, losses: None }
    }

    /// Opens the dialog for a document. The name is the one that it was last saved under, else its own. The format is the given one, else a Bezier format if the document
    /// has only control points, else the last one used.
    pub fn show(&mut self, document: &Document, format: Option<Format>) {
        self.stage = Stage::Opening;
        self.name = match &self.last_saved {
            Some((of, name)) if of == document.name() => name.clone(),
            _ => document.name().to_owned(),
        };
        let kinds = || document.objects().iter().map(|object| object.bezier().map(|b| b.curve().is_some()));
        let all = |wanted| !document.objects().is_empty() && kinds().all(|is_curve| is_curve == wanted);
        self.format = match (format, self.format) {
            (Some(format), _) => format,
            (None, last) if all(Some(true)) => Format::for_bezier(true).unwrap_or(last),
            (None, last) if all(Some(false)) => Format::for_bezier(false).unwrap_or(last),
            (None, last) if last.is_bezier() && all(None) => Format::default(),
            (None, last) => last,
        };
    }

    pub fn is_open(&self) -> bool {
        self.stage != Stage::Closed
    }

    /// Forgets the losses if the document changed.
    pub fn follow(&mut self, changes: &Changes) {
        if !changes.objects.is_empty() || changes.document {
            self.losses = None;
        }
    }

    /// Chooses the format whose extension was typed, if it suits the document.
    fn follow_extension(&mut self, page: &Page<'_>) {
        if let Some(format) = Format::from_name(&self.name)
            && format.extension() != self.format.extension()
            && page.why_not(Action::SaveAs(format)).is_none()
        {
            self.format = format;
        }
    }
}

/// A typed name as a file name: without the format's extension and without characters that some systems
/// don't allow. None if nothing remains.
fn stem(typed: &str, format: Format) -> Option<String> {
    let typed = typed.trim();
    let stem = match typed.rsplit_once('.') {
        Some((stem, extension))
            if format.extensions().iter().any(|own| own.eq_ignore_ascii_case(extension)) =>
        {
            stem
        }
        _ => typed,
    };
    let allowed = |c: char| !c.is_control() && !r#"/\:*?"<>|"#.contains(c);
    let stem: String = stem.chars().map(|c| if allowed(c) { c } else { '_' }).collect();
    let stem = stem.trim_matches([' ', '.']);
    (!stem.is_empty()).then(|| stem.to_owned())
}

pub(crate) fn show(ctx: &Context, page: &Page<'_>, own: &mut Saving, narrow: bool, out: &mut Requests) {
    if !own.is_open() {
        return;
    }
    let screen = ctx.content_rect();
    let margin = if narrow { 12 } else { 16 };
    let width = 400.0_f32.min(screen.width() - 2.0 * f32::from(margin) - 16.0).max(0.0);
    let id = Id::unique("save");
    let area = Modal::default_area(id).anchor(Align2::CENTER_TOP, vec2(0.0, screen.height() * 0.12));
    let frame = Frame::popup(&ctx.global_style()).inner_margin(margin);
    let shown = Modal::new(id).area(area).frame(frame).show(ctx, |ui| {
        ui.set_width(width);
        form(ui, page, own, narrow)
    });
    if shown.inner {
        save(page, own, out);
    } else if shown.should_close() {
        own.stage = Stage::Closed;
    }
}

/// The dialog's contents; returns whether to save now.
fn form(ui: &mut Ui, page: &Page<'_>, own: &mut Saving, narrow: bool) -> bool {
    ui.label(RichText::new("Save document").heading());
    ui.add_space(4.0);
    let mut save = false;
    Grid::new("save").num_columns(2).spacing(vec2(12.0, 8.0)).show(ui, |ui| {
        let label = ui.label("File name").id;
        save = name_field(ui, page, own, narrow, label);
        ui.end_row();
        let label = ui.label("Format").id;
        format_choice(ui, page, own, label);
        ui.end_row();
    });
    ui.add(Label::new(RichText::new(actions::of_format(own.format).description).weak()).wrap());
    ui.add_space(4.0);
    show_losses(ui, page, own);
    ui.add_space(8.0);
    let ready = stem(&own.name, own.format).is_some();
    ui.horizontal(|ui| {
        let button = primary_button(ui, "Save").min_size(vec2(96.0, 28.0));
        let button = ui.add_enabled(ready, button);
        let hint = "Save the file (Enter)";
        save |= button.on_hover_text(hint).on_disabled_hover_text("Enter a file name first.").clicked();
        let cancel = Button::new("Cancel").min_size(vec2(80.0, 28.0));
        if ui.add(cancel).on_hover_text("Close without saving (Escape)").clicked() {
            own.stage = Stage::Closed;
        }
    });
    save && ready
}

/// The name field, followed by the extension; returns whether Enter was pressed in it.
fn name_field(ui: &mut Ui, page: &Page<'_>, own: &mut Saving, narrow: bool, label: Id) -> bool {
    let extension = own.format.extension();
    ui.horizontal(|ui| {
        let width = ui.available_width() - 48.0;
        let field = text_field(&mut own.name).desired_width(width.max(80.0));
        let field = ui.add(field).labelled_by(label);
        if field.changed() {
            own.follow_extension(page);
        }
        match own.stage {
            // A telephone's on-screen keyboard would cover the dialog.
            Stage::Opening if narrow => own.stage = Stage::Open,
            Stage::Opening => {
                field.request_focus();
                own.stage = Stage::Focusing;
                ui.ctx().request_repaint();
            }
            Stage::Focusing => {
                let mut state = TextEdit::load_state(ui.ctx(), field.id).unwrap_or_default();
                state.cursor.set_char_range(Some(CCursorRange::select_all_str(&own.name)));
                state.store(ui.ctx(), field.id);
                own.stage = Stage::Open;
            }
            Stage::Closed | Stage::Open => {}
        }
        if Format::from_name(&own.name) != Format::from_extension(extension) {
            ui.label(RichText::new(format!(".{extension}")).weak());
        }
        field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter))
    })
    .inner
}

/// The formats that suit the document.
fn format_choice(ui: &mut Ui, page: &Page<'_>, own: &mut Saving, label: Id) {
    let combo = ComboBox::from_id_salt("format")
        .selected_text(own.format.name())
        .width((ui.available_width() - 8.0).max(0.0))
        .height(420.0);
    let combo = combo.show_ui(ui, |ui| {
        for entry in actions::formats() {
            let Action::SaveAs(format) = entry.action else { continue };
            if page.why_not(entry.action).is_some() {
                continue;
            }
            let on = format == own.format;
            if ui.selectable_label(on, format.name()).on_hover_text(entry.description).clicked() {
                // An extension in the name would choose its own format again.
                if let Some(stem) = stem(&own.name, own.format) {
                    own.name = stem;
                }
                own.format = format;
            }
        }
    });
    combo.response.labelled_by(label).on_hover_text("The format of the file");
}

/// What the format can't hold, one line each.
fn show_losses(ui: &mut Ui, page: &Page<'_>, own: &mut Saving) {
    let format = own.format;
    let losses = losses_of(page, own, format);
    let (good, warning) = (theme::palette(ui.visuals()).good, ui.visuals().warn_fg_color);
    if !format.can_open() {
        let text = format!(
            "Meshwright can't open {} again, so the document will still count as changed.",
            format.name()
        );
        ui.add(Label::new(RichText::new(text).color(warning)).wrap());
    } else if losses.is_empty() {
        let text = format!("{} holds everything in this document.", format.name());
        ui.label(RichText::new(text).color(good));
    }
    ScrollArea::vertical().max_height(160.0).auto_shrink([false, true]).show(ui, |ui| {
        for loss in losses {
            let text = RichText::new(format!("{loss}.")).color(warning);
            ui.add(Label::new(text).wrap());
        }
    });
}

/// Computes the losses once after each change: at a million faces that takes longer than a frame.
fn losses_of<'a>(page: &Page<'_>, own: &'a mut Saving, format: Format) -> &'a [String] {
    let editor = &page.editor;
    let known = own.losses.take().filter(|(looked, _)| *looked == format);
    let losses = known.unwrap_or_else(|| {
        let document = editor.document();
        (format, formats::losses(format, &document.to_model(document.name())))
    });
    &own.losses.insert(losses).1
}

/// Requests that the files be written.
fn save(page: &Page<'_>, own: &mut Saving, out: &mut Requests) {
    let format = own.format;
    let Some(name) = stem(&own.name, format) else { return };
    own.stage = Stage::Closed;
    own.last_saved = Some((page.editor.document().name().to_owned(), name.clone()));
    let brings_back_all = format.can_open() && losses_of(page, own, format).is_empty();
    out.push(Request::Save { format, name, brings_back_all });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_become_file_names() {
        let cases = [
            ("bunny", Some("bunny")),
            ("  bunny.obj ", Some("bunny")),
            ("bunny.OBJ", Some("bunny")),
            ("v1.2", Some("v1.2")),
            ("bunny.tar", Some("bunny.tar")),
            ("a/b\\c:d", Some("a_b_c_d")),
            ("..hidden..", Some("hidden")),
            ("straße", Some("straße")),
            (".obj", None),
            (" . ", None),
            ("", None),
        ];
        for (typed, wanted) in cases {
            assert_eq!(stem(typed, Format::default()).as_deref(), wanted, "{typed:?}");
        }
    }
}
