//! The textures that the scene is drawn into, before they are drawn in the page's render pass.

/// Samples per pixel.
pub const SAMPLES_PER_PIXEL: u32 = 4;
/// Colours are stored gamma-encoded, in a format that every device can resolve.
pub const COLOR_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
/// Floating point suits the reversed depth range.
pub const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// Multisampled colour and depth, and the resolved colour.
pub struct Targets {
    pub size: [u32; 2],
    pub samples: wgpu::TextureView,
    pub depth: wgpu::TextureView,
    pub resolved: wgpu::TextureView,
    /// The resolved colour, for the composite shader.
    pub bind_group: wgpu::BindGroup,
}

impl Targets {
    /// Creates textures of this size.
    pub fn new(device: &wgpu::Device, layout: &wgpu::BindGroupLayout, size: [u32; 2]) -> Self {
        let attachment = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let texture = |label, format, sample_count, usage| {
            device
                .create_texture(&wgpu::TextureDescriptor {
                    label: Some(label),
                    size: wgpu::Extent3d { width: size[0], height: size[1], depth_or_array_layers: 1 },
                    mip_level_count: 1,
                    sample_count,
                    dimension: wgpu::TextureDimension::D2,
                    format,
                    usage,
                    view_formats: &[],
                })
                .create_view(&wgpu::TextureViewDescriptor::default())
        };
        let resolved =
            texture("viewport", COLOR_FORMAT, 1, attachment | wgpu::TextureUsages::TEXTURE_BINDING);
        let bind_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("viewport composite"),
            layout,
            entries: &[wgpu::BindGroupEntry {
                binding: 0,
                resource: wgpu::BindingResource::TextureView(&resolved),
            }],
        });
        Self {
            size,
            samples: texture("viewport samples", COLOR_FORMAT, SAMPLES_PER_PIXEL, attachment),
            depth: texture("viewport depth", DEPTH_FORMAT, SAMPLES_PER_PIXEL, attachment),
            resolved,
            bind_group,
        }
    }

    /// The nearest size that the device allows: at least one pixel.
    pub fn fit(device: &wgpu::Device, size: [u32; 2]) -> [u32; 2] {
        let most = device.limits().max_texture_dimension_2d;
        size.map(|s| s.clamp(1, most))
    }
}
