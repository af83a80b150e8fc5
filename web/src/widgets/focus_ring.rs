//! The ring around the widget that has the keyboard focus, shown while the keyboard is used.

use egui::{Context, Id, Key, Stroke, StrokeKind};

use crate::theme;

/// The key under which it is remembered whether the keyboard was used last.
const BY_KEYBOARD: &str = "focus moved by keyboard";

/// Draws the ring over the widget. Call it at the end of a frame.
pub(crate) fn show(ctx: &Context) {
    let by_keyboard = Id::unique(BY_KEYBOARD);
    let shown = ctx.input(|input| {
        let moves = [Key::Tab, Key::ArrowUp, Key::ArrowDown, Key::ArrowLeft, Key::ArrowRight];
        if input.pointer.any_pressed() {
            Some(false)
        } else {
            moves.iter().any(|key| input.key_pressed(*key)).then_some(true)
        }
    });
    let shown = ctx.data_mut(|data| {
        let before = data.get_temp_mut_or(by_keyboard, false);
        *before = shown.unwrap_or(*before);
        *before
    });
    let focused = ctx.memory(|memory| memory.focused()).filter(|_| shown);
    let Some(response) = focused.and_then(|id| ctx.read_response(id)) else { return };
    let around = response.interact_rect.intersect(ctx.content_rect());
    if !around.is_positive() {
        return;
    }
    let style = ctx.global_style();
    let palette = theme::palette(&style.visuals);
    let painter = ctx.layer_painter(response.layer_id);
    // The dark and the light line together stand out on any picture.
    let outer = around.expand(2.0).intersect(ctx.content_rect());
    painter.rect_stroke(outer, 4.0, Stroke::new(1.0, style.visuals.extreme_bg_color), StrokeKind::Inside);
    painter.rect_stroke(outer.shrink(1.0), 3.0, Stroke::new(2.0, palette.focus), StrokeKind::Inside);
}
