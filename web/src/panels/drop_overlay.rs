//! The overlay that covers the page while a file is dragged over it.

use egui::{Align2, Context, FontId, Id, LayerId, Order, Stroke, StrokeKind};

use crate::theme;

pub(crate) fn show(ctx: &Context) {
    if ctx.input(|input| input.raw.hovered_files.is_empty()) {
        return;
    }
    let painter = ctx.layer_painter(LayerId::new(Order::Foreground, Id::unique("drop overlay")));
    let style = ctx.global_style();
    let screen = ctx.content_rect();
    painter.rect_filled(screen, 0.0, theme::palette(&style.visuals).overlay);
    let accent = style.visuals.hyperlink_color;
    painter.rect_stroke(screen.shrink(16.0), 12.0, Stroke::new(2.0, accent), StrokeKind::Inside);
    let text = "Drop to open. Your files stay on this computer.";
    let color = style.visuals.strong_text_color();
    painter.text(screen.center(), Align2::CENTER_CENTER, text, FontId::proportional(18.0), color);
}
