//! What one view is drawn with. All views are drawn from the same buffers of objects.

use super::frame::FrameKey;
use super::pipelines::Pipelines;
use super::targets::Targets;
use super::uniforms::{DrawUniform, FrameUniform};

/// Bytes from one draw uniform to the next: a dynamic offset that every device allows.
pub const DRAW_UNIFORM_STRIDE: usize = 256;

/// The textures and uniforms of a view, and the last frame drawn with them.
pub struct Screen {
    pub targets: Option<Targets>,
    pub frame_buffer: wgpu::Buffer,
    pub draw_buffer: wgpu::Buffer,
    pub bind_group: wgpu::BindGroup,
    pub drawn: Option<FrameKey>,
}

impl Screen {
    pub fn new(device: &wgpu::Device, pipelines: &Pipelines) -> Self {
        let frame_buffer = uniform_buffer(device, "viewport frame", size_of::<FrameUniform>());
        let draw_buffer = uniform_buffer(device, "viewport draws", DRAW_UNIFORM_STRIDE * 32);
        let bind_group = bind(device, pipelines, &frame_buffer, &draw_buffer);
        Self { targets: None, frame_buffer, draw_buffer, bind_group, drawn: None }
    }

    /// Makes room for uniforms of so many bytes.
    pub fn reserve_draws(&mut self, device: &wgpu::Device, pipelines: &Pipelines, bytes: u64) {
        if self.draw_buffer.size() < bytes {
            self.draw_buffer = uniform_buffer(device, "viewport draws", bytes.next_power_of_two() as usize);
            self.bind_group = bind(device, pipelines, &self.frame_buffer, &self.draw_buffer);
        }
    }
}

fn uniform_buffer(device: &wgpu::Device, label: &str, size: usize) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor {
        label: Some(label),
        size: size as u64,
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    })
}

fn bind(
    device: &wgpu::Device,
    pipelines: &Pipelines,
    frame: &wgpu::Buffer,
    draws: &wgpu::Buffer,
) -> wgpu::BindGroup {
    device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("viewport uniforms"),
        layout: &pipelines.uniforms,
        entries: &[
            wgpu::BindGroupEntry { binding: 0, resource: frame.as_entire_binding() },
            wgpu::BindGroupEntry {
                binding: 1,
                resource: wgpu::BindingResource::Buffer(wgpu::BufferBinding {
                    buffer: draws,
                    offset: 0,
                    size: std::num::NonZeroU64::new(size_of::<DrawUniform>() as u64),
                }),
            },
        ],
    })
}
