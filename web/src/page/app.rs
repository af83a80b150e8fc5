//! The editor as eframe runs it, and as scripts reach it.

use std::any::Any;
use std::cell::RefMut;

use eframe::WebRunner;
use wasm_bindgen::prelude::*;
use web_sys::{BeforeUnloadEvent, HtmlCanvasElement};

use super::{graphics, notice};
use crate::app::App;
use crate::platform::browser::Browser;
use crate::script::ui_tree::UiTree;

/// The editor as eframe runs it.
pub struct PageApp {
    app: App,
    ready: Ready,
}

/// What is left to do until scripts may be told that the editor is there.
enum Ready {
    /// Frames to draw before.
    In(u32),
    Told,
}

impl PageApp {
    pub fn new(context: &eframe::CreationContext<'_>) -> Self {
        let ctx = &context.egui_ctx;
        ctx.add_plugin(UiTree::default());
        let graphics = context.wgpu_render_state.clone();
        let browser = Browser::new(ctx, graphics::device_info(graphics.as_ref()));
        // The first frame lays out, the second is drawn from it.
        Self { app: App::new(ctx, Box::new(browser), graphics), ready: Ready::In(2) }
    }

    fn tell_ready(&mut self, ctx: &egui::Context) {
        match self.ready {
            Ready::Told => {}
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
    fn logic(&mut self, ctx: &egui::Context, _frame: &mut eframe::Frame) {
        self.app.logic(ctx);
        self.tell_ready(ctx);
    }

    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        self.app.ui(ui);
    }

    fn as_any_mut(&mut self) -> Option<&mut dyn Any> {
        Some(self)
    }
}

/// How scripts and the browser's events reach the editor between two frames.
#[derive(Clone)]
pub struct Handle {
    runner: WebRunner,
    canvas: HtmlCanvasElement,
}

impl Handle {
    pub fn new(runner: WebRunner, canvas: HtmlCanvasElement) -> Self {
        Self { runner, canvas }
    }

    /// The editor; `None` after a crash, and while the editor itself is at work.
    pub fn app(&self) -> Option<RefMut<'_, App>> {
        self.runner.app_mut::<PageApp>().map(|page| RefMut::map(page, |page| &mut page.app))
    }

    /// The canvas's top left corner in CSS pixels of the page.
    pub fn corner(&self) -> [f32; 2] {
        let rect = self.canvas.get_bounding_client_rect();
        [rect.left() as f32, rect.top() as f32]
    }
}

/// Has the browser ask before the page goes while there is work that was not saved.
pub fn ask_before_leaving(handle: Handle) -> Result<(), JsValue> {
    let window = web_sys::window().ok_or("there is no window")?;
    let on_leave = Closure::<dyn FnMut(BeforeUnloadEvent)>::new(move |event: BeforeUnloadEvent| {
        if handle.app().is_some_and(|app| app.editor().is_dirty()) {
            event.prevent_default();
            // Older browsers ask only where this is set; none shows the text.
            event.set_return_value("unsaved");
        }
    });
    window.add_event_listener_with_callback("beforeunload", on_leave.as_ref().unchecked_ref())?;
    // For as long as the page lives.
    on_leave.forget();
    Ok(())
}
