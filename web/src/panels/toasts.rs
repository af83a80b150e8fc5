//! Short messages in a corner of the viewport: imports, refusals and failures.

use editor::MessageKind;
use egui::accesskit::Live;
use egui::{Align2, Area, Context, Frame, Id, Margin, Order, RichText, Role, Stroke, Ui, vec2};
use halfedge::words::counted;

use crate::input::actions::{self, Action};
use crate::keeping::OfDocument;
use crate::page_view::Page;
use crate::panels::live_bar;
use crate::request::{Request, Requests};
use crate::session::toasts::{Remedy, Slot, Toast};
use crate::theme;
use crate::widgets::icon_button::icon_button;
use crate::widgets::icons::Icon;

/// The most that the details of a toast take of the viewport's height.
const MAX_SHARE_OF_HEIGHT: f32 = 0.3;

/// The least width of a toast, in points.
const MIN_WIDTH_POINTS: f32 = 120.0;

pub(crate) fn show(ctx: &Context, page: &Page<'_>, narrow: bool, out: &mut Requests) {
    if page.toasts.visible().next().is_none() {
        return;
    }
    let viewport = live_bar::room_above(ctx, page);
    let width = if narrow { (viewport.width() - 24.0).max(MIN_WIDTH_POINTS) } else { 360.0 };
    let id = Id::unique("toasts");
    // An area is placed by its size in the last frame: where that no longer holds, it is measured first.
    let contents = (page.toasts.changes(), width.to_bits());
    let is_changed = ctx.data(|data| data.get_temp(id)) != Some(contents);
    ctx.data_mut(|data| data.insert_temp(id, contents));
    Area::new(id)
        .order(Order::Foreground)
        .pivot(Align2::LEFT_BOTTOM)
        .fixed_pos(viewport.left_bottom() + vec2(12.0, -12.0))
        .sizing_pass(is_changed)
        .show(ctx, |ui| {
            ui.set_width(width);
            for (slot, toast) in page.toasts.visible() {
                toast_frame(ui, page, slot, toast, width, out);
            }
        });
}

fn toast_frame(ui: &mut Ui, page: &Page<'_>, slot: Slot, toast: &Toast, width: f32, out: &mut Requests) {
    let color = match toast.kind {
        MessageKind::Info => theme::palette(ui.visuals()).good,
        MessageKind::Warning => ui.visuals().warn_fg_color,
        MessageKind::Error => ui.visuals().error_fg_color,
    };
    let frame = Frame::popup(ui.style()).inner_margin(Margin { left: 14, right: 6, top: 6, bottom: 6 });
    let shown = frame.show(ui, |ui| {
        ui.set_width(width - 20.0);
        ui.horizontal_top(|ui| {
            ui.vertical(|ui| {
                ui.set_width(width - 58.0);
                ui.add_space(3.0);
                let text = ui.add(egui::Label::new(&toast.text).wrap());
                ui.ctx().accesskit_node_builder(text.id, |node| {
                    node.set_role(Role::Alert);
                    node.set_live(match toast.kind {
                        MessageKind::Error => Live::Assertive,
                        MessageKind::Info | MessageKind::Warning => Live::Polite,
                    });
                    node.set_label(toast.text.as_str());
                });
                if has_links(page, slot, toast) {
                    ui.horizontal_wrapped(|ui| links(ui, page, slot, toast, out));
                }
                if toast.open {
                    let most = page.view.area.height() * MAX_SHARE_OF_HEIGHT;
                    egui::ScrollArea::vertical().max_height(most).show(ui, |ui| {
                        for line in &toast.details {
                            ui.add(egui::Label::new(RichText::new(line).small()).wrap());
                        }
                    });
                }
            });
            if icon_button(ui, Icon::Close, "Dismiss message", false).on_hover_text("Dismiss").clicked() {
                out.push(Request::DismissToast(slot));
            }
        });
    });
    let rect = shown.response.rect.shrink2(vec2(0.0, 5.0));
    ui.painter().vline(rect.left() + 6.0, rect.y_range(), Stroke::new(3.0, color));
}

fn has_links(page: &Page<'_>, slot: Slot, toast: &Toast) -> bool {
    let has_earlier = slot == Slot::Error && page.toasts.earlier_errors() > 0;
    remedy(page, toast).is_some() || !toast.details.is_empty() || has_earlier
}

/// What a toast offers now: after another edit, undo would undo that one.
fn remedy(page: &Page<'_>, toast: &Toast) -> Option<Remedy> {
    let is_current = |revision| page.editor.revision() == revision;
    toast.remedy.filter(|remedy| match remedy {
        Remedy::Act(_) | Remedy::RestoreDocument => true,
        Remedy::UndoEdit { revision } => is_current(*revision),
    })
}

/// What can be done about a toast, its details, and the errors before it.
fn links(ui: &mut Ui, page: &Page<'_>, slot: Slot, toast: &Toast, out: &mut Requests) {
    match remedy(page, toast) {
        Some(Remedy::Act(action)) => {
            let entry = actions::describe(action);
            if ui.link(entry.label).on_hover_text(entry.description).clicked() {
                out.act(action);
            }
        }
        Some(Remedy::UndoEdit { .. })
            if ui
                .link("Undo")
                .on_hover_text("Undo this edit and later changes of the selection")
                .clicked() =>
        {
            out.push(Request::UndoEdit);
        }
        Some(Remedy::RestoreDocument)
            if ui.link("Undo").on_hover_text("Put the document back into the list").clicked() =>
        {
            out.push(Request::Document(OfDocument::Restore));
        }
        _ => {}
    }
    if !toast.details.is_empty() {
        let label = if toast.open { "Hide details" } else { "Details" };
        if ui.link(label).on_hover_text("Show or hide the details").clicked() {
            out.push(Request::ToggleToast(slot));
        }
    }
    let earlier = page.toasts.earlier_errors();
    if slot == Slot::Error && earlier > 0 {
        let label = counted(earlier, "earlier error", "earlier errors");
        if ui.link(label).on_hover_text("Open the list of all messages").clicked() {
            out.act(Action::Messages);
        }
    }
}
