//! Starts eframe on the page's canvas and tells the page how that went.

use eframe::{WebOptions, WebRunner, wgpu};
use wasm_bindgen::prelude::*;

use crate::worker_link;

#[wasm_bindgen]
extern "C" {
    /// The notices of index.html.
    #[wasm_bindgen(js_namespace = meshwrightPage)]
    fn started(info: &str);
    #[wasm_bindgen(js_namespace = meshwrightPage, js_name = noGraphics)]
    fn no_graphics(reason: &str);
    #[wasm_bindgen(js_namespace = meshwrightPage)]
    fn crashed(message: &str);
}

/// Runs the editor on the canvas with the id `meshwright`.
pub fn start() {
    std::panic::set_hook(Box::new(|info| crashed(&info.to_string())));
    wasm_bindgen_futures::spawn_local(async {
        let Some(canvas) = find_canvas() else {
            crashed("The page has no canvas with the id `meshwright`.");
            return;
        };
        let result = WebRunner::new()
            .start(canvas, WebOptions::default(), Box::new(|context| Ok(Box::new(Page::new(context)))))
            .await;
        if let Err(reason) = result {
            no_graphics(&reason.as_string().unwrap_or_else(|| format!("{reason:?}")));
        }
    });
}

fn find_canvas() -> Option<web_sys::HtmlCanvasElement> {
    web_sys::window()?.document()?.get_element_by_id("meshwright")?.dyn_into().ok()
}

struct Page {
    renderer: &'static str,
    reported: bool,
}

impl Page {
    fn new(context: &eframe::CreationContext<'_>) -> Self {
        let backend = context.wgpu_render_state.as_ref().map(|state| state.adapter.get_info().backend);
        let renderer = match backend {
            Some(wgpu::Backend::BrowserWebGpu) => "webgpu",
            _ => "webgl2",
        };
        worker_link::spawn();
        Self { renderer, reported: false }
    }
}

impl eframe::App for Page {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        egui::CentralPanel::default().show(ui, |ui| {
            ui.heading("Meshwright");
            ui.label(format!("Renderer: {}", self.renderer));
        });
        if !self.reported {
            self.reported = true;
            let info = serde_json::json!({
                "version": env!("CARGO_PKG_VERSION"),
                "renderer": self.renderer,
            });
            started(&info.to_string());
        }
    }
}
