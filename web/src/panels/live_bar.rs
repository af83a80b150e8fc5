//! The bar over the viewport for an edit that follows the pointer.

use editor::ops::{Drag, Field};
use egui::{Align2, Area, Context, DragValue, Frame, Id, Order, RichText, Ui, pos2};
use glam::Vec3;

use crate::page_view::Page;
use crate::request::{Request, Requests};

/// Shows the bar: the name of the edit, its amount, and buttons that end it.
pub(crate) fn show(ctx: &Context, page: &Page<'_>, out: &mut Requests) {
    let Some(live) = &page.live else { return };
    let top = page.view.rect.center_top();
    let (label, drag, field, mut value) = (live.id.spec().label, live.drag, live.field, live.value);
    let refused = live.refused.clone();
    let speed = page.view.drag_speed();
    let mut changed = false;
    let area = Area::new(Id::unique("live edit")).order(Order::Foreground).pivot(Align2::CENTER_TOP);
    area.fixed_pos(pos2(top.x, top.y + 8.0)).show(ctx, |ui| {
        Frame::popup(ui.style()).show(ui, |ui| {
            ui.horizontal(|ui| {
                ui.label(RichText::new(label).strong());
                changed = amounts(ui, drag, field, speed, &mut value);
                if ui
                    .button("Apply")
                    .on_hover_text("Apply the edit (Enter, or a click in the viewport)")
                    .clicked()
                {
                    out.push(Request::EndLive { commit: true });
                }
                if ui.button("Cancel").on_hover_text("Cancel the edit (Escape)").clicked() {
                    out.push(Request::EndLive { commit: false });
                }
            });
            let hint = "Move the pointer, or type a number; Enter applies, Escape cancels.";
            match refused {
                Some(reason) => ui.colored_label(ui.visuals().warn_fg_color, reason),
                None => ui.label(RichText::new(hint).small().weak()),
            };
        });
    });
    if changed {
        out.push(Request::SetLiveAmount(value));
    }
}

/// The spin boxes for the amount, one or three; returns whether a value changed.
fn amounts(ui: &mut Ui, drag: Drag, field: &Field, speed: f64, value: &mut Vec3) -> bool {
    let label = field.label();
    if drag != Drag::Offset {
        let speed = if drag == Drag::Fraction { 0.005 } else { speed };
        return ui
            .add(DragValue::new(&mut value.x).speed(speed).max_decimals(5))
            .on_hover_text("Drag, or type a number")
            .accessible_name(label)
            .changed();
    }
    let mut changed = false;
    for (axis, number) in ["x", "y", "z"].iter().zip([&mut value.x, &mut value.y, &mut value.z]) {
        changed |= ui
            .add(DragValue::new(number).speed(speed).max_decimals(5))
            .accessible_name(format!("{label} {axis}"))
            .changed();
    }
    changed
}
