//! The graphics device that the page requests.

use std::sync::Arc;

use eframe::WebOptions;
use eframe::egui_wgpu::{RenderState, WgpuSetup, WgpuSetupCreateNew};
use wgpu::{Backend, Backends, DeviceDescriptor, Limits};

use crate::platform::DeviceInfo;

/// The graphics APIs to try.
#[derive(Clone, Copy, Debug)]
pub enum Choice {
    /// WebGPU if the browser has it, else WebGL2.
    Best,
    /// WebGL2 even if the browser has WebGPU, because WebGPU failed.
    WebGl2,
}

/// eframe's options for these graphics APIs.
pub fn options(choice: Choice) -> WebOptions {
    let mut setup = WgpuSetupCreateNew::without_display_handle();
    setup.instance_descriptor.backends = match choice {
        Choice::Best => Backends::BROWSER_WEBGPU | Backends::GL,
        Choice::WebGl2 => Backends::GL,
    };
    setup.device_descriptor = Arc::new(|adapter| DeviceDescriptor {
        label: Some("meshwright"),
        required_limits: limits(adapter.get_info().backend, &adapter.limits()),
        ..Default::default()
    });
    let mut options = WebOptions::default();
    options.wgpu_options.wgpu_setup = WgpuSetup::CreateNew(setup);
    options
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
        Backend::BrowserWebGpu => "webgpu",
        _ => "webgl2",
    };
    let adapter = [info.name, info.driver, info.driver_info];
    let adapter: Vec<String> = adapter.into_iter().filter(|text| !text.is_empty()).collect();
    DeviceInfo { renderer: renderer.to_owned(), adapter: adapter.join(", ") }
}
