//! The window with all messages: imports, refusals and results.

use editor::MessageKind;
use egui::{Context, Label, RichText, ScrollArea};

use crate::page_view::Page;
use crate::request::{Request, Requests};
use crate::widgets::window::centred;

pub(crate) fn show(ctx: &Context, page: &Page<'_>, out: &mut Requests) {
    let mut open = page.shown.messages;
    let screen = ctx.content_rect();
    centred(ctx, "Messages")
        .open(&mut open)
        .default_size([460.0_f32.min(screen.width() - 48.0), 320.0])
        .show(ctx, |ui| {
            let copy = ui.add_enabled(page.editor.messages().len() > 0, egui::Button::new("Copy all"));
            if copy.on_hover_text("Copy all messages as text").clicked() {
                let lines: Vec<&str> = page.editor.messages().map(|message| message.text.as_str()).collect();
                ui.ctx().copy_text(lines.join("\n"));
            }
            ui.separator();
            ScrollArea::vertical().auto_shrink([false, false]).stick_to_bottom(true).show(ui, |ui| {
                if page.editor.messages().len() == 0 {
                    ui.label(
                        RichText::new(
                            "Nothing has happened yet. Imports, jobs and refusals are listed here.",
                        )
                        .weak(),
                    );
                }
                for message in page.editor.messages() {
                    let text = RichText::new(&message.text);
                    let text = match message.kind {
                        MessageKind::Info => text,
                        MessageKind::Warning => text.color(ui.visuals().warn_fg_color),
                        MessageKind::Error => text.color(ui.visuals().error_fg_color),
                    };
                    ui.add(Label::new(text).wrap().selectable(true));
                }
            });
        });
    if !open && page.shown.messages {
        out.push(Request::Close(crate::shown::Window::Messages));
    }
}
