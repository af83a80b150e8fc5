//! The pictures that surfaces are shaded with.

use crate::Matcap;
use crate::matcap::MATCAP_SIZE;

/// The matcap's picture on the GPU.
pub struct Surface {
    matcap: Option<Matcap>,
    pub bind_group: wgpu::BindGroup,
}

impl Surface {
    /// A surface without pictures.
    pub fn new(device: &wgpu::Device, layout: &wgpu::BindGroupLayout) -> Self {
        let blank = picture_texture(device, "no matcap", [1, 1]);
        Self { matcap: None, bind_group: bind_picture(device, layout, &blank) }
    }

    /// Makes the picture of a matcap if it isn't there already.
    pub fn want(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        layout: &wgpu::BindGroupLayout,
        matcap: Matcap,
    ) {
        if self.matcap == Some(matcap) {
            return;
        }
        let picture = picture_texture(device, "matcap", [MATCAP_SIZE; 2]);
        queue.write_texture(
            picture.as_image_copy(),
            bytemuck::cast_slice(&matcap.picture()),
            wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(MATCAP_SIZE * 4),
                rows_per_image: None,
            },
            picture.size(),
        );
        *self = Self { matcap: Some(matcap), bind_group: bind_picture(device, layout, &picture) };
    }
}

/// A texture for a picture that shaders read, whether it is uploaded or drawn.
pub fn picture_texture(device: &wgpu::Device, label: &str, [width, height]: [u32; 2]) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some(label),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: super::targets::COLOR_FORMAT,
        usage: wgpu::TextureUsages::TEXTURE_BINDING
            | wgpu::TextureUsages::COPY_DST
            | wgpu::TextureUsages::RENDER_ATTACHMENT,
        view_formats: &[],
    })
}

/// A bind group for reading a picture with linear filtering, up to its rim.
pub fn bind_picture(
    device: &wgpu::Device,
    layout: &wgpu::BindGroupLayout,
    picture: &wgpu::Texture,
) -> wgpu::BindGroup {
    let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("clamped"),
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        ..Default::default()
    });
    device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("viewport surface"),
        layout,
        entries: &[
            wgpu::BindGroupEntry {
                binding: 0,
                resource: wgpu::BindingResource::TextureView(&picture.create_view(&Default::default())),
            },
            wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::Sampler(&sampler) },
        ],
    })
}
