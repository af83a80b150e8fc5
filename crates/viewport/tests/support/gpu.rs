//! A GPU device without a window, which reads pictures back as arrays.

use glam::Vec2;
use halfedge::Mesh;
use viewport::{Camera, Frame, Look, ObjectChange, ObjectDraw, Renderer, Shading, Style};

/// The size of pictures.
pub const SIZE: [u32; 2] = [200, 160];
/// The same as a vector.
pub const VIEW: Vec2 = Vec2::new(200.0, 160.0);
/// A target that shows what is written.
pub const GAMMA: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// Looking along -z from (0, 0, 5).
pub fn front() -> Camera {
    Camera { yaw: 0.0, pitch: 0.0, ..Camera::default() }
}

/// One object, drawn with this style; `more` sets highlights.
pub fn draw_with(
    gpu: &Gpu,
    mesh: &Mesh,
    camera: &Camera,
    style: &Style,
    more: impl FnOnce(&mut Renderer),
) -> Image {
    let mut renderer = gpu.renderer();
    renderer.sync_object(&gpu.device, &gpu.queue, 7, mesh, ObjectChange::Everything, style);
    more(&mut renderer);
    gpu.render(&mut renderer, &frame(camera, style), GAMMA)
}

pub fn draw(gpu: &Gpu, mesh: &Mesh, camera: &Camera, style: &Style) -> Image {
    draw_with(gpu, mesh, camera, style, |_| {})
}

pub fn frame<'a>(camera: &'a Camera, style: &'a Style) -> Frame<'a> {
    const OBJECT: &[viewport::ObjectDraw] = &[viewport::ObjectDraw { id: 7, visible: true, active: true }];
    Frame { size: SIZE, pixels_per_point: 1.0, camera, objects: OBJECT, style }
}

pub struct Gpu {
    pub device: wgpu::Device,
    pub queue: wgpu::Queue,
}

/// A device with the limits of WebGL2, so that tests ask for no more. `WGPU_BACKEND=gl` uses OpenGL, whose shaders
/// are those of WebGL2.
///
/// # Panics
/// There is no adapter: `cargo xtask setup` installs one that draws in software.
pub fn gpu() -> Gpu {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle_from_env());
    let adapter = pollster::block_on(instance.request_adapter(&wgpu::RequestAdapterOptions::default()));
    let adapter = adapter.unwrap_or_else(|error| {
        panic!(
            "{error}: nothing here can draw; `cargo xtask setup` installs a driver that draws in software."
        )
    });
    let descriptor = wgpu::DeviceDescriptor {
        required_limits: wgpu::Limits::downlevel_webgl2_defaults(),
        ..Default::default()
    };
    let (device, queue) = pollster::block_on(adapter.request_device(&descriptor)).expect("a device");
    Gpu { device, queue }
}

/// A picture, RGBA.
#[derive(Clone, PartialEq)]
pub struct Image {
    pub size: [u32; 2],
    pub pixels: Vec<[u8; 4]>,
}

impl Image {
    pub fn at(&self, x: u32, y: u32) -> [u8; 3] {
        let [r, g, b, _] = self.pixels[(y * self.size[0] + x) as usize];
        [r, g, b]
    }

    pub fn near(&self, p: glam::Vec2) -> [u8; 3] {
        self.at(p.x as u32, p.y as u32)
    }

    pub fn count(&self, what: impl Fn([u8; 3]) -> bool) -> usize {
        self.pixels.iter().filter(|[r, g, b, _]| what([*r, *g, *b])).count()
    }
}

/// Whether each channel is within `by`.
pub fn close(a: [u8; 3], b: [u8; 3], by: u8) -> bool {
    (0..3).all(|i| a[i].abs_diff(b[i]) <= by)
}

/// A style with only flat faces on a flat black background.
pub fn bare() -> Style {
    let mut style = Style {
        look: Look::Course,
        shading: Shading::Flat,
        wireframe: false,
        grid: false,
        shadow: false,
        ..Style::default()
    };
    style.theme.background_top = halfedge::Color([0; 3]);
    style.theme.background_bottom = halfedge::Color([0; 3]);
    style
}

pub fn shown(id: u64) -> ObjectDraw {
    ObjectDraw { id, visible: true, active: true }
}

impl Gpu {
    pub fn renderer(&self) -> Renderer {
        Renderer::new(&self.device, wgpu::TextureFormat::Rgba8Unorm)
    }

    /// The frame as the page shows it.
    pub fn render(&self, renderer: &mut Renderer, frame: &Frame<'_>, format: wgpu::TextureFormat) -> Image {
        let [width, height] = frame.size;
        let size = wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
        let target = self.device.create_texture(&wgpu::TextureDescriptor {
            label: None,
            size,
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format,
            usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
            view_formats: &[],
        });
        let view = target.create_view(&wgpu::TextureViewDescriptor::default());
        let row = (width * 4).next_multiple_of(256);
        let buffer = self.device.create_buffer(&wgpu::BufferDescriptor {
            label: None,
            size: u64::from(row * height),
            usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
            mapped_at_creation: false,
        });
        let mut encoder = self.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        renderer.prepare(0, &self.device, &self.queue, &mut encoder, frame);
        {
            let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
                color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                    view: &view,
                    depth_slice: None,
                    resolve_target: None,
                    ops: wgpu::Operations::default(),
                })],
                ..Default::default()
            });
            renderer.paint(0, &mut pass);
        }
        encoder.copy_texture_to_buffer(
            target.as_image_copy(),
            wgpu::TexelCopyBufferInfo {
                buffer: &buffer,
                layout: wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(row),
                    rows_per_image: None,
                },
            },
            size,
        );
        self.queue.submit([encoder.finish()]);
        buffer.slice(..).map_async(wgpu::MapMode::Read, |result| result.expect("mapped"));
        self.device.poll(wgpu::PollType::wait_indefinitely()).expect("drawn");
        let data = buffer.slice(..).get_mapped_range().expect("mapped").to_vec();
        let pixels = data
            .chunks(row as usize)
            .flat_map(|line| line[..(width * 4) as usize].chunks(4))
            .map(|p| [p[0], p[1], p[2], p[3]])
            .collect();
        Image { size: frame.size, pixels }
    }
}
