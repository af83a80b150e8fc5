//! The graphics that the page draws with, and what can go wrong with them.

use std::fmt;
use std::sync::Arc;

use eframe::WebOptions;
use eframe::egui_wgpu::{RenderState, WgpuSetup, WgpuSetupCreateNew, WgpuSetupExisting};
use wasm_bindgen::JsCast;
use wgpu::{Adapter, Backend, Backends, DeviceDescriptor, Instance, Limits, RequestAdapterOptions};

use crate::platform::DeviceInfo;
use crate::platform::browser::within;

/// How long WebGPU may take to give a device, and then to draw the first frames, before the page draws with WebGL2.
pub const WEBGPU_LIMIT_MS: i32 = 20_000;

/// What draws.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Renderer {
    WebGpu,
    WebGl2,
}

impl Renderer {
    /// What addresses, settings and scripts call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::WebGpu => "webgpu",
            Self::WebGl2 => "webgl2",
        }
    }

    /// What users call it.
    pub fn label(self) -> &'static str {
        match self {
            Self::WebGpu => "WebGPU",
            Self::WebGl2 => "WebGL2",
        }
    }

    /// The renderer of this name.
    pub fn named(name: &str) -> Option<Self> {
        [Self::WebGpu, Self::WebGl2].into_iter().find(|renderer| renderer.name() == name)
    }

    /// The other one.
    pub fn other(self) -> Self {
        match self {
            Self::WebGpu => Self::WebGl2,
            Self::WebGl2 => Self::WebGpu,
        }
    }
}

/// Why the page has to draw with another device.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Trouble {
    /// The device is gone: the driver was updated or has crashed, or the system took it.
    Lost(String),
    /// The device refuses what every WebGPU device must draw.
    Fails(String),
    /// The device has drawn nothing for too long.
    Hangs,
}

impl fmt::Display for Trouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Lost(why) if why.is_empty() => f.write_str("the graphics device was lost"),
            Self::Lost(why) => write!(f, "the graphics device was lost: {why}"),
            Self::Fails(why) => write!(f, "the graphics device reports an error: {why}"),
            Self::Hangs => write!(f, "it has drawn nothing for {} s", WEBGPU_LIMIT_MS / 1000),
        }
    }
}

/// Why a renderer can't be used.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unusable {
    pub why: String,
    /// Whether the browser has it, but it doesn't work.
    pub is_broken: bool,
}

impl Unusable {
    fn broken(why: impl Into<String>) -> Self {
        Self { why: why.into(), is_broken: true }
    }
}

/// eframe's options for this renderer. The device of WebGPU is requested here, so that a browser which gives none, or never
/// answers, leaves the canvas as it is.
///
/// # Errors
/// The renderer can't be used.
pub async fn options(renderer: Renderer) -> Result<WebOptions, Unusable> {
    let setup = match renderer {
        Renderer::WebGpu => {
            let late =
                || Err(Unusable::broken(format!("no device came within {} s", WEBGPU_LIMIT_MS / 1000)));
            WgpuSetup::Existing(within(WEBGPU_LIMIT_MS, request_webgpu()).await.unwrap_or_else(late)?)
        }
        Renderer::WebGl2 => {
            let mut setup = WgpuSetupCreateNew::without_display_handle();
            setup.instance_descriptor.backends = Backends::GL;
            setup.device_descriptor = Arc::new(descriptor);
            WgpuSetup::CreateNew(setup)
        }
    };
    let mut options = WebOptions::default();
    options.wgpu_options.wgpu_setup = setup;
    Ok(options)
}

async fn request_webgpu() -> Result<WgpuSetupExisting, Unusable> {
    let mut setup = WgpuSetupCreateNew::without_display_handle().instance_descriptor;
    setup.backends = Backends::BROWSER_WEBGPU;
    let instance = Instance::new(setup);
    let adapter = instance.request_adapter(&RequestAdapterOptions::default()).await;
    let adapter = adapter.map_err(|error| Unusable { why: error.to_string(), is_broken: false })?;
    let device = adapter.request_device(&descriptor(&adapter)).await;
    let (device, queue) = device.map_err(|error| Unusable::broken(error.to_string()))?;
    Ok(WgpuSetupExisting { instance, adapter, device, queue })
}

fn descriptor(adapter: &Adapter) -> DeviceDescriptor<'static> {
    DeviceDescriptor {
        label: Some("meshwright"),
        required_limits: limits(adapter.get_info().backend, &adapter.limits()),
        ..Default::default()
    }
}

/// The limits to request: the lowest that the page works with, so that no device is refused, except that
/// the largest texture (for large screens) and buffer (for large meshes) are what the device allows.
fn limits(backend: Backend, most: &Limits) -> Limits {
    let least = match backend {
        Backend::Gl => Limits::downlevel_webgl2_defaults(),
        _ => Limits::default(),
    };
    Limits {
        max_texture_dimension_2d: most.max_texture_dimension_2d,
        max_buffer_size: most.max_buffer_size,
        ..least
    }
}

/// The device's description for the status bar and scripts.
pub fn device_info(state: Option<&RenderState>) -> DeviceInfo {
    let Some(info) = state.map(|state| state.adapter.get_info()) else {
        return DeviceInfo::default();
    };
    let renderer = match info.backend {
        Backend::BrowserWebGpu => Renderer::WebGpu,
        _ => Renderer::WebGl2,
    };
    let adapter = [info.name, info.driver, info.driver_info];
    let adapter: Vec<String> = adapter.into_iter().filter(|text| !text.is_empty()).collect();
    DeviceInfo { renderer: renderer.name().to_owned(), adapter: adapter.join(", ") }
}

/// Calls `report` with the number of the attempt to draw when something is wrong with its device.
pub fn watch(state: &RenderState, attempt: u32, report: fn(u32, Trouble)) {
    state.device.set_device_lost_callback(move |_, why| report(attempt, Trouble::Lost(why)));
    state.device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
        report(attempt, Trouble::Fails(error.to_string()))
    }));
}

/// Whether a canvas is drawn on by WebGL2 and has lost its context.
pub fn has_lost_context(canvas: &web_sys::HtmlCanvasElement) -> bool {
    let context = canvas.get_context("webgl2").ok().flatten();
    context
        .and_then(|context| context.dyn_into::<web_sys::WebGl2RenderingContext>().ok())
        .is_some_and(|context| context.is_context_lost())
}
