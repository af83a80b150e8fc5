//! The editor as an eframe app.

use eframe::egui_wgpu::RenderState;
use egui::ViewportId;
use wasm_bindgen::prelude::*;
use web_sys::{BeforeUnloadEvent, PointerEvent};

use super::handle::Handle;
use super::mirror::Mirroring;
use super::{graphics, notice};
use crate::access::tree::UiTree;
use crate::app::{App, drawing};
use crate::input::pacing::Pacing;
use crate::platform::browser::Browser;

/// The editor on a canvas, as an eframe app. There is a new one for each graphics device.
pub struct PageApp {
    page: Handle,
    graphics: Option<RenderState>,
    pacing: Pacing,
    /// The number of frames to draw before the device is asked whether it has drawn.
    frames_until_asked: u32,
    /// The number of frames to draw with the document before scripts are told that the editor is ready.
    frames_until_ready: u32,
    has_told: bool,
}

impl PageApp {
    /// Puts the page's editor on the canvas; makes it if there is none yet.
    pub fn new(context: &eframe::CreationContext<'_>, page: Handle) -> Self {
        let ctx = &context.egui_ctx;
        ctx.add_plugin(UiTree::default());
        ctx.add_plugin(Mirroring);
        let graphics = context.wgpu_render_state.clone();
        let device = graphics::device_info(graphics.as_ref());
        let is_first = page.app().is_none();
        let make = || App::new(ctx, Box::new(Browser::new(ctx, device.clone())), graphics.clone());
        if let Some(mut app) = page.app_or_make(make)
            && !is_first
        {
            drawing::go_on(&mut app, ctx, device.clone(), graphics.clone());
        }
        // The first frame computes the layout; the second draws with it.
        Self {
            page,
            graphics,
            pacing: Pacing::default(),
            frames_until_asked: 2,
            frames_until_ready: 2,
            has_told: false,
        }
    }

    fn tell_ready(&mut self, app: &App, ctx: &egui::Context) {
        if self.frames_until_asked > 0 {
            self.frames_until_asked -= 1;
            ctx.request_repaint();
            if let Some(graphics) = self.graphics.as_ref().filter(|_| self.frames_until_asked == 0) {
                self.page.await_drawing(&graphics.queue);
            }
        }
        // Scripts act on the document of the last visit.
        if app.is_opening() {
            return;
        }
        if self.frames_until_ready > 0 {
            self.frames_until_ready -= 1;
            ctx.request_repaint();
        } else if self.page.has_drawn() && !std::mem::replace(&mut self.has_told, true) {
            let info = serde_json::json!({
                "version": env!("CARGO_PKG_VERSION"),
                "renderer": app.device().renderer,
            });
            notice::started(&info.to_string());
        }
    }
}

impl eframe::App for PageApp {
    fn raw_input_hook(&mut self, ctx: &egui::Context, raw_input: &mut egui::RawInput) {
        if self.page.is_lost() {
            // eframe draws nothing in a minimized window. Events wait for the next device.
            let info = raw_input.viewports.entry(ViewportId::ROOT).or_default();
            info.minimized = Some(true);
            return;
        }
        self.page.pressed().mark(raw_input);
        let is_opening = self.page.app().is_some_and(|app| app.is_opening());
        if self.pacing.pace(raw_input, time_of_button(), is_opening) {
            ctx.request_repaint();
        }
    }

    fn logic(&mut self, ctx: &egui::Context, _frame: &mut eframe::Frame) {
        if self.page.is_lost() {
            return;
        }
        let page = self.page.clone();
        if let Some(mut app) = page.app() {
            app.logic(ctx);
            self.tell_ready(&app, ctx);
            page.tell_scripts(&mut app);
        }
    }

    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        if let Some(mut app) = self.page.app() {
            app.ui(ui);
        }
    }
}

/// When the button was pressed or released whose event is being handled, in seconds since the page's start. eframe runs a
/// frame within the handler of such an event.
fn time_of_button() -> Option<f64> {
    let event = web_sys::window()?.event();
    let event = event.dyn_ref::<PointerEvent>()?;
    matches!(event.type_().as_str(), "pointerdown" | "pointerup").then(|| event.time_stamp() / 1000.0)
}

/// Makes the browser ask before the page closes with changes that are neither saved nor kept.
pub fn ask_before_leaving(handle: Handle) -> Result<(), JsValue> {
    let window = web_sys::window().ok_or("there is no window")?;
    let on_leave = Closure::<dyn FnMut(BeforeUnloadEvent)>::new(move |event: BeforeUnloadEvent| {
        if handle.app().is_some_and(|app| app.would_lose_changes()) {
            event.prevent_default();
            // Older browsers ask only if this is set; none shows the text.
            event.set_return_value("unsaved");
        }
    });
    window.add_event_listener_with_callback("beforeunload", on_leave.as_ref().unchecked_ref())?;
    // The listener lives as long as the page.
    on_leave.forget();
    Ok(())
}
