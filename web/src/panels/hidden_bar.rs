//! The note over the viewport that faces are hidden, with a button that shows them again.

use editor::OpId;
use egui::{Align2, Area, Context, Frame, Id, Order, Ui, pos2};
use halfedge::words::counted;

use crate::input::actions;
use crate::input::keys;
use crate::page_view::Page;
use crate::request::Requests;
use crate::view::Tool;

/// Shows the note if faces of the active object are hidden.
pub(crate) fn show(ctx: &Context, page: &Page<'_>, out: &mut Requests) {
    let hidden = page.editor.document().active().map_or(0, |object| object.hidden().len());
    if hidden == 0 {
        return;
    }
    // Beside the tools, below the kinds of elements.
    let top = page.view.free_area().center_top();
    // Below the hint of the box tool.
    let down = if page.view.tool == Tool::Box { 44.0 } else { 8.0 };
    let area = Area::new(Id::unique("hidden faces")).order(Order::Middle).pivot(Align2::CENTER_TOP);
    area.fixed_pos(pos2(top.x, top.y + down)).show(ctx, |ui| {
        Frame::popup(ui.style()).show(ui, |ui| {
            ui.horizontal(|ui| {
                ui.label(format!("{} hidden", counted(hidden, "face", "faces")));
                reveal_button(ui, out);
            });
        });
    });
}

/// A button that shows everything again.
pub(crate) fn reveal_button(ui: &mut Ui, out: &mut Requests) {
    let reveal = actions::of_operation(OpId::Reveal);
    let tooltip = keys::tooltip(ui.ctx(), reveal.description, reveal.action);
    if ui.button(reveal.label).on_hover_text(tooltip).clicked() {
        out.act(reveal.action);
    }
}
