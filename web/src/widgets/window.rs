//! Windows in the middle of the page.

use egui::{Align2, Context, Window};

/// A window that opens in the middle.
pub(crate) fn centred(ctx: &Context, title: &'static str) -> Window<'static> {
    Window::new(title)
        .collapsible(false)
        .pivot(Align2::CENTER_CENTER)
        .default_pos(ctx.content_rect().center())
}

/// A window that stays in the middle, as large as what is in it.
pub(crate) fn fixed(ctx: &Context, title: &'static str) -> Window<'static> {
    centred(ctx, title).resizable(false).fixed_pos(ctx.content_rect().center())
}
