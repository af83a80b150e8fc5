//! The window: the page's app as an eframe app.

use std::path::PathBuf;
use std::sync::Arc;

use eframe::{CreationContext, NativeOptions};
use egui::{FontData, FontFamily, FontInsert, FontPriority, InsertFontFamily, RawInput, Ui, ViewportBuilder};
use egui_wgpu::{RenderState, WgpuSetup};
use epaint_default_fonts::{HACK_REGULAR, UBUNTU_LIGHT};
use meshwright_web::access::tree::UiTree;
use meshwright_web::app::App;
use meshwright_web::input::pacing::Pacing;
use meshwright_web::platform::DeviceInfo;

use crate::closing::Closing;
use crate::platform::Desktop;

/// The program's name, as the system knows its windows.
const APP_ID: &str = "meshwright";
const SIZE_POINTS: [f32; 2] = [1280.0, 800.0];
const MIN_SIZE_POINTS: [f32; 2] = [360.0, 480.0];

/// Shows the window until it is closed. The files are opened together.
pub fn run(files: Vec<PathBuf>) -> eframe::Result {
    let viewport = ViewportBuilder::default()
        .with_title("Meshwright")
        .with_app_id(APP_ID)
        .with_inner_size(SIZE_POINTS)
        .with_min_inner_size(MIN_SIZE_POINTS)
        .with_drag_and_drop(true);
    let mut options = NativeOptions { viewport, ..NativeOptions::default() };
    if let WgpuSetup::CreateNew(setup) = &mut options.wgpu_options.wgpu_setup {
        setup.device_descriptor = Arc::new(|adapter| wgpu::DeviceDescriptor {
            label: Some("meshwright"),
            required_limits: adapter.limits(),
            ..Default::default()
        });
    }
    eframe::run_native(APP_ID, options, Box::new(|context| Ok(Box::new(Window::new(context, files)))))
}

struct Window {
    app: App,
    pacing: Pacing,
    closing: Closing,
}

impl Window {
    fn new(context: &CreationContext<'_>, files: Vec<PathBuf>) -> Self {
        let ctx = &context.egui_ctx;
        ctx.add_plugin(UiTree::default());
        let graphics = context.wgpu_render_state.clone();
        let platform = Desktop::new(ctx, files, device_info(graphics.as_ref()));
        let app = App::new(ctx, Box::new(platform), graphics);
        add_whole_fonts(ctx);
        Self { app, pacing: Pacing::default(), closing: Closing::default() }
    }
}

impl eframe::App for Window {
    fn raw_input_hook(&mut self, ctx: &egui::Context, raw_input: &mut RawInput) {
        if self.pacing.pace(raw_input, None, self.app.is_opening()) {
            ctx.request_repaint();
        }
    }

    fn logic(&mut self, ctx: &egui::Context, _frame: &mut eframe::Frame) {
        self.app.logic(ctx);
        self.closing.follow(ctx, self.app.would_lose_changes());
    }

    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        self.app.ui(ui);
    }
}

/// Adds the fonts that those of the interface are parts of, for names in Greek and Cyrillic and for rare signs.
fn add_whole_fonts(ctx: &egui::Context) {
    for (name, bytes) in [("Ubuntu Light", UBUNTU_LIGHT), ("Hack", HACK_REGULAR)] {
        let families = [FontFamily::Proportional, FontFamily::Monospace]
            .map(|family| InsertFontFamily { family, priority: FontPriority::Lowest });
        ctx.add_font(FontInsert::new(name, FontData::from_static(bytes), families.into()));
    }
}

/// The device's description for the status bar.
fn device_info(state: Option<&RenderState>) -> DeviceInfo {
    let Some(info) = state.map(|state| state.adapter.get_info()) else {
        return DeviceInfo::default();
    };
    let adapter = [info.name, info.driver, info.driver_info];
    let adapter: Vec<String> = adapter.into_iter().filter(|text| !text.is_empty()).collect();
    DeviceInfo { renderer: info.backend.to_string(), adapter: adapter.join(", ") }
}
