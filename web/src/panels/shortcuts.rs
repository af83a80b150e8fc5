//! The window that lists all keys and gestures.

use egui::{Context, Grid, RichText, ScrollArea, Ui, Window, vec2};

use crate::input::actions;
use crate::input::keys::{self, BEZIER_BINDINGS, BINDINGS, Binding, CIRCLE_BINDINGS, GESTURES};
use crate::page_view::Page;
use crate::request::{Request, Requests};

pub(crate) fn show(ctx: &Context, page: &Page<'_>, out: &mut Requests) {
    let mut open = page.shown.shortcuts;
    let screen = ctx.content_rect();
    Window::new("Keyboard shortcuts")
        .open(&mut open)
        .collapsible(false)
        .resizable(false)
        .pivot(egui::Align2::CENTER_CENTER)
        .fixed_pos(screen.center())
        .show(ctx, |ui| {
            let wide = screen.width() > 700.0;
            ui.set_width(if wide { 640.0 } else { screen.width() - 48.0 });
            ScrollArea::vertical().max_height(screen.height() * 0.7).auto_shrink([false, true]).show(
                ui,
                |ui| {
                    if wide {
                        ui.columns(2, |columns| {
                            if let [left, right] = columns {
                                let half = (BINDINGS.len().div_ceil(2) + 6).min(BINDINGS.len());
                                let (first, second) = BINDINGS.split_at(half);
                                bindings(left, "keys", first);
                                bindings(right, "more keys", second);
                                special(right);
                                right.add_space(12.0);
                                gestures(right);
                            }
                        });
                    } else {
                        bindings(ui, "keys", &BINDINGS);
                        special(ui);
                        ui.add_space(12.0);
                        gestures(ui);
                    }
                },
            );
        });
    if !open && page.shown.shortcuts {
        out.push(Request::Close(crate::shown::Window::Shortcuts));
    }
}

/// The keys that mean something else at times.
fn special(ui: &mut Ui) {
    ui.add_space(12.0);
    ui.label(RichText::new("On a Bezier curve or surface").strong());
    bindings(ui, "bezier keys", &BEZIER_BINDINGS);
    ui.add_space(12.0);
    ui.label(RichText::new("With the selecting circle").strong());
    bindings(ui, "circle keys", &CIRCLE_BINDINGS);
}

fn bindings(ui: &mut Ui, name: &str, table: &[Binding]) {
    Grid::new(name).num_columns(2).spacing(vec2(12.0, 4.0)).min_col_width(96.0).show(ui, |ui| {
        for (action, shortcuts) in table {
            let texts: Vec<String> = shortcuts.iter().map(|key| keys::written(ui.ctx(), key)).collect();
            ui.label(RichText::new(texts.join(", ")).monospace());
            let entry = actions::describe(*action);
            ui.label(entry.label).on_hover_text(entry.description);
            ui.end_row();
        }
    });
}

fn gestures(ui: &mut Ui) {
    ui.label(RichText::new("In the viewport").strong());
    for (what, how) in GESTURES {
        ui.add(egui::Label::new(*what));
        ui.add(egui::Label::new(RichText::new(*how).small().weak()).wrap());
    }
}
