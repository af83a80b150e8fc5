//! Short messages over the viewport: imports, refusals and failures.

use editor::MessageKind;
use egui::{Align2, Area, Context, Frame, Id, Margin, Order, RichText, Role, Stroke, vec2};

use crate::input::actions;
use crate::page_view::Page;
use crate::request::{Request, Requests};
use crate::theme;
use crate::widgets::icons::{Icon, icon_button};

pub(crate) fn show(ctx: &Context, page: &Page<'_>, narrow: bool, out: &mut Requests) {
    if page.toasts.iter().next().is_none() {
        return;
    }
    let viewport = page.view.rect;
    let width = if narrow { viewport.width() - 24.0 } else { 360.0 };
    Area::new(Id::unique("toasts"))
        .order(Order::Foreground)
        .pivot(Align2::LEFT_BOTTOM)
        .fixed_pos(viewport.left_bottom() + vec2(12.0, -12.0))
        .show(ctx, |ui| {
            ui.set_width(width);
            for (at, toast) in page.toasts.iter().enumerate() {
                let color = match toast.kind {
                    MessageKind::Info => theme::palette(ui.visuals()).good,
                    MessageKind::Warning => ui.visuals().warn_fg_color,
                    MessageKind::Error => ui.visuals().error_fg_color,
                };
                let frame = Frame::popup(ui.style())
                    .inner_margin(Margin { left: 14, right: 6, top: 6, bottom: 6 })
                    .show(ui, |ui| {
                        ui.set_width(width - 20.0);
                        ui.horizontal_top(|ui| {
                            ui.vertical(|ui| {
                                ui.set_width(width - 58.0);
                                ui.add_space(3.0);
                                let text = ui.add(egui::Label::new(&toast.text).wrap());
                                ui.ctx().accesskit_node_builder(text.id, |node| {
                                    node.set_role(Role::Alert);
                                    node.set_label(toast.text.as_str());
                                });
                                if let Some(entry) = toast.remedy.map(actions::describe)
                                    && ui.link(entry.label).on_hover_text(entry.description).clicked()
                                {
                                    out.act(entry.action);
                                }
                                if toast.details.is_empty() {
                                    return;
                                }
                                let label = if toast.open { "Hide details" } else { "Details" };
                                if ui.link(label).on_hover_text("Show or hide the details").clicked() {
                                    out.push(Request::ToggleToast(at));
                                }
                                if toast.open {
                                    egui::ScrollArea::vertical().max_height(180.0).show(ui, |ui| {
                                        for line in &toast.details {
                                            ui.add(egui::Label::new(RichText::new(line).small()).wrap());
                                        }
                                    });
                                }
                            });
                            if icon_button(ui, Icon::Close, "Dismiss message", false)
                                .on_hover_text("Dismiss")
                                .clicked()
                            {
                                out.push(Request::DismissToast(at));
                            }
                        });
                    });
                let rect = frame.response.rect.shrink2(vec2(0.0, 5.0));
                ui.painter().vline(rect.left() + 6.0, rect.y_range(), Stroke::new(3.0, color));
            }
        });
}
