//! The editor as an eframe app, and its handle for scripts.

use std::any::Any;
use std::cell::RefMut;

use eframe::WebRunner;
use wasm_bindgen::prelude::*;
use web_sys::{BeforeUnloadEvent, HtmlCanvasElement, PointerEvent};

use super::browser_keys::Pressed;
use super::mirror::Mirroring;
use super::{graphics, notice};
use crate::access::tree::UiTree;
use crate::app::App;
use crate::input::pacing::Pacing;
use crate::platform::browser::Browser;

/// The editor as an eframe app.
pub struct PageApp {
    app: App,
    pacing: Pacing,
    pressed: Pressed,
    ready: Ready,
    /// Tells scripts what happened.
    tell: fn(&mut App),
}

/// The progress until scripts are told that the editor is ready.
enum Ready {
    /// The number of frames to draw first.
    In(u32),
    Told,
}

impl PageApp {
    pub fn new(context: &eframe::CreationContext<'_>, pressed: Pressed, tell: fn(&mut App)) -> Self {
        let ctx = &context.egui_ctx;
        ctx.add_plugin(UiTree::default());
        ctx.add_plugin(Mirroring);
        let graphics = context.wgpu_render_state.clone();
        let browser = Browser::new(ctx, graphics::device_info(graphics.as_ref()));
        // The first frame computes the layout; the second draws with it.
        Self {
            app: App::new(ctx, Box::new(browser), graphics),
            pacing: Pacing::default(),
            pressed,
            ready: Ready::In(2),
            tell,
        }
    }

    fn tell_ready(&mut self, ctx: &egui::Context) {
        match self.ready {
            Ready::Told => {}
            // Scripts act on the document of the last visit.
            Ready::In(_) if self.app.is_opening() => {}
            Ready::In(0) => {
                self.ready = Ready::Told;
                let info = serde_json::json!({
                    "version": env!("CARGO_PKG_VERSION"),
                    "renderer": self.app.device().renderer,
                });
                notice::started(&info.to_string());
            }
            Ready::In(frames) => {
                self.ready = Ready::In(frames - 1);
                ctx.request_repaint();
            }
        }
    }
}

impl eframe::App for PageApp {
    fn raw_input_hook(&mut self, ctx: &egui::Context, raw_input: &mut egui::RawInput) {
        self.pressed.mark(raw_input);
        if self.pacing.pace(raw_input, time_of_button()) {
            ctx.request_repaint();
        }
    }

    fn logic(&mut self, ctx: &egui::Context, _frame: &mut eframe::Frame) {
        self.app.logic(ctx);
        self.tell_ready(ctx);
        (self.tell)(&mut self.app);
    }

    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        self.app.ui(ui);
    }

    fn as_any_mut(&mut self) -> Option<&mut dyn Any> {
        Some(self)
    }
}

/// When the button was pressed or released whose event is being handled, in seconds since the page's start. eframe runs a
/// frame within the handler of such an event.
fn time_of_button() -> Option<f64> {
    let event = web_sys::window()?.event();
    let event = event.dyn_ref::<PointerEvent>()?;
    matches!(event.type_().as_str(), "pointerdown" | "pointerup").then(|| event.time_stamp() / 1000.0)
}

/// Gives scripts and browser events access to the editor between two frames.
#[derive(Clone)]
pub struct Handle {
    runner: WebRunner,
    canvas: HtmlCanvasElement,
}

impl Handle {
    pub fn new(runner: WebRunner, canvas: HtmlCanvasElement) -> Self {
        Self { runner, canvas }
    }

    /// The editor; `None` after a crash, and during a call of the editor itself.
    pub fn app(&self) -> Option<RefMut<'_, App>> {
        self.runner.app_mut::<PageApp>().map(|page| RefMut::map(page, |page| &mut page.app))
    }

    /// The canvas's top left corner in CSS pixels of the page.
    pub fn corner(&self) -> [f32; 2] {
        let rect = self.canvas.get_bounding_client_rect();
        [rect.left() as f32, rect.top() as f32]
    }
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
