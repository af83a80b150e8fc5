//! Drawing on another graphics device, after the last one was lost.

use editor::ObjectChange;
use egui::Context;

use super::App;
use crate::fonts;
use crate::platform::DeviceInfo;
use crate::view::picture::Picture;

/// Stops drawing: the device is gone.
pub fn stop(app: &mut App) {
    app.view.picture = None;
}

/// Goes on with another device, and with another egui, which takes over what the last one knew: focus, scrolling, keys and
/// looks. Everything is uploaded again.
pub fn go_on(app: &mut App, ctx: &Context, device: DeviceInfo, gpu: Option<egui_wgpu::RenderState>) {
    let memory = app.session.ctx.memory(Clone::clone);
    ctx.memory_mut(|now| *now = memory);
    fonts::install(ctx);
    app.session.ctx = ctx.clone();
    app.session.platform.draw_on(ctx, device);
    app.panels.forget_pictures();
    app.view.picture = gpu.map(Picture::new);
    app.view.textures.decode_again();
    let (view, document) = (&mut app.view, app.session.editor.document());
    if let Some(picture) = &mut view.picture {
        picture.set_materials(view.textures.looks(document.materials()));
        for object in document.objects() {
            picture.sync(object, &ObjectChange::Everything, &view.style);
        }
    }
    ctx.request_repaint();
}

/// Says something about the graphics.
pub fn say(app: &mut App, text: String) {
    app.session.tell(text, Vec::new());
}
