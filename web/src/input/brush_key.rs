//! The key that paints a selection while it is held: Tab, in the keys of Maya.

use egui::{Context, Event, Key, Plugin, RawInput};

use super::keys;
use crate::view::widget_id;

/// Whether a drag in the viewport paints with the circle because the key is held.
pub(crate) fn is_held(ctx: &Context) -> bool {
    let paints = keys::map(ctx).mouse().paints_with_tab();
    paints && !ctx.text_edit_focused() && ctx.input(|input| input.key_down(Key::Tab))
}

/// Keeps a held Tab from moving the focus on and on: over the viewport, only the first press of it does.
pub(crate) struct HeldTab;

impl Plugin for HeldTab {
    fn debug_name(&self) -> &'static str {
        "held Tab"
    }

    fn input_hook(&mut self, ctx: &Context, input: &mut RawInput) {
        if !is_held(ctx) {
            return;
        }
        let at = ctx.input(|input| input.pointer.latest_pos());
        let is_over =
            ctx.read_response(widget_id()).zip(at).is_some_and(|(viewport, at)| viewport.rect.contains(at));
        if is_over {
            input.events.retain(|event| !matches!(event, Event::Key { key: Key::Tab, pressed: true, .. }));
        }
    }
}
