//! The window with the version and the graphics device.

use egui::{Context, Grid, Label, RichText, vec2};

use crate::page_view::Page;
use crate::request::{Request, Requests};
use crate::widgets::window::fixed;

pub(crate) fn show(ctx: &Context, page: &Page<'_>, out: &mut Requests) {
    let mut open = page.shown.about;
    let device = page.platform.device();
    let history = (page.editor.history_bytes(), page.editor.history_limit());
    fixed(ctx, "About Meshwright").open(&mut open).show(ctx, |ui| {
        ui.set_width(320.0_f32.min(ctx.content_rect().width() - 48.0).max(0.0));
        ui.add(Label::new("A polygon mesh editor. Your files stay on this computer.").wrap());
        ui.add_space(4.0);
        Grid::new("about").num_columns(2).spacing(vec2(14.0, 4.0)).show(ui, |ui| {
            let history = format!("{:.1} of {} MB", history.0 as f64 / 1048576.0, history.1 / 1048576);
            let gpu = format!("{:.1} MB", page.view.gpu_bytes() as f64 / 1048576.0);
            for (name, value) in [
                ("Version", env!("CARGO_PKG_VERSION")),
                ("Renderer", device.renderer.as_str()),
                ("Graphics", device.adapter.as_str()),
                ("Graphics memory", gpu.as_str()),
                ("Undo memory", history.as_str()),
            ] {
                ui.label(RichText::new(name).weak());
                ui.add(Label::new(value).wrap().selectable(true));
                ui.end_row();
            }
        });
    });
    if !open && page.shown.about {
        out.push(Request::Close(crate::shown::Window::About));
    }
}
