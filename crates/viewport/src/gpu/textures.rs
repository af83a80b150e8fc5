//! The pictures of materials on the GPU, and the bind groups that draws take them from.
//!
//! A draw has at most [`TEXTURES_PER_DRAW`] textures: WebGL2 guarantees 16 for a shader, and knows no arrays of textures that differ
//! in size. Where materials have more, the faces are drawn in several passes, each of which leaves out those of the
//! others. Which texture a face shows is thus a number at its corners, and an edit moves no triangles between buffers.

use super::pipelines::{Depth, Maker, buffer, filtered_picture, filtering_sampler, uniform};
use super::renderer::Renderer;
use crate::materials::TEXTURES_PER_DRAW;
use crate::{Materials, Texture, Wrap};
use std::collections::HashMap;
use std::sync::Arc;
use wgpu::{VertexStepMode, vertex_attr_array};

/// How many times farther across than along a picture is filtered where a surface is seen from the side.
const ANISOTROPY: u16 = 8;
const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8UnormSrgb;

/// A picture: 8-bit RGBA in sRGB, and its smaller versions.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// The rows from the top, then those of the picture at half the size, rounded down, and so on down to one pixel.
    pub pixels: Vec<u8>,
}

/// How a texture lies on faces, with the layout of `Placement` in `textured.wgsl`.
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
struct Placement {
    u: [f32; 4],
    v: [f32; 4],
}

impl Placement {
    fn new(Texture { transform, cutoff, opacity, .. }: Texture) -> Self {
        let (x, y, moved) = (transform.matrix2.x_axis, transform.matrix2.y_axis, transform.translation);
        Self { u: [x.x, y.x, moved.x, cutoff], v: [x.y, y.y, moved.y, opacity] }
    }
}

/// A picture that is uploaded.
struct Uploading {
    picture: Picture,
    level: u32,
    row: u32,
    /// The bytes that are uploaded.
    done: usize,
}

impl Uploading {
    /// Uploads about this many bytes more, whole rows; returns whether all is uploaded.
    fn step(&mut self, queue: &wgpu::Queue, texture: &wgpu::Texture, bytes: &mut usize) -> bool {
        while self.level < texture.mip_level_count() {
            let [width, height] = self.picture.size.map(|side| (side >> self.level).max(1));
            let row_bytes = width as usize * 4;
            let rows = (*bytes / row_bytes).clamp(1, (height - self.row) as usize);
            let Some(data) = self.picture.pixels.get(self.done..self.done + rows * row_bytes) else {
                return true;
            };
            queue.write_texture(
                wgpu::TexelCopyTextureInfo {
                    mip_level: self.level,
                    origin: wgpu::Origin3d { x: 0, y: self.row, z: 0 },
                    ..texture.as_image_copy()
                },
                data,
                wgpu::TexelCopyBufferLayout {
                    offset: 0,
                    bytes_per_row: Some(row_bytes as u32),
                    rows_per_image: None,
                },
                wgpu::Extent3d { width, height: rows as u32, depth_or_array_layers: 1 },
            );
            self.done += data.len();
            self.row += rows as u32;
            if self.row == height {
                (self.level, self.row) = (self.level + 1, 0);
            }
            *bytes = bytes.saturating_sub(data.len());
            if *bytes == 0 {
                break;
            }
        }
        self.level == texture.mip_level_count()
    }
}

/// Pipelines for faces with texture coordinates, made when they are first drawn.
pub struct TexturedPipelines {
    pub all: wgpu::RenderPipeline,
    pub fronts: wgpu::RenderPipeline,
    pub glass_backs: wgpu::RenderPipeline,
    pub glass_fronts: wgpu::RenderPipeline,
    /// The back sides of faces of translucent materials, which hide nothing.
    pub clear_backs: wgpu::RenderPipeline,
    pub clear_fronts: wgpu::RenderPipeline,
}

/// The pictures, the pipelines that draw them, and what passes bind.
pub struct Textures {
    layout: wgpu::BindGroupLayout,
    pictures: HashMap<u64, wgpu::Texture>,
    uploading: HashMap<u64, Uploading>,
    blank: wgpu::Texture,
    pub pipelines: Option<TexturedPipelines>,
    /// The bind group of each pass; empty where something has changed.
    pub passes: Vec<wgpu::BindGroup>,
}

impl Textures {
    pub fn new(device: &wgpu::Device) -> Self {
        let places = TEXTURES_PER_DRAW as u32;
        let mut entries = vec![uniform(0, false, TEXTURES_PER_DRAW * size_of::<Placement>())];
        entries.extend((1..=places).map(filtered_picture));
        entries.extend((1..=places).map(|place| filtering_sampler(places + place)));
        Self {
            layout: device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
                label: Some("textures"),
                entries: &entries,
            }),
            pictures: HashMap::new(),
            uploading: HashMap::new(),
            blank: texture(device, [1, 1]),
            pipelines: None,
            passes: Vec::new(),
        }
    }

    /// Makes what draws need and isn't there.
    pub fn prepare(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        uniforms: &wgpu::BindGroupLayout,
        materials: &Materials,
    ) {
        if self.pipelines.is_none() {
            self.pipelines = Some(TexturedPipelines::new(device, uniforms, &self.layout));
            // White, so that faces show their colour until the picture is there.
            let white = Picture { size: [1, 1], pixels: vec![255; 4] };
            let mut uploading = Uploading { picture: white, level: 0, row: 0, done: 0 };
            uploading.step(queue, &self.blank, &mut 4);
        }
        if self.passes.is_empty() {
            let textures = materials.textures();
            let none: &[Texture] = &[];
            let passes = textures.chunks(TEXTURES_PER_DRAW).chain(textures.is_empty().then_some(none));
            self.passes = passes.map(|textures| self.bind(device, queue, textures)).collect();
        }
    }

    /// The bind group of a pass.
    fn bind(&self, device: &wgpu::Device, queue: &wgpu::Queue, textures: &[Texture]) -> wgpu::BindGroup {
        let of = |place: usize| textures.get(place).copied().unwrap_or(Texture::new(u64::MAX));
        let all: [Texture; TEXTURES_PER_DRAW] = std::array::from_fn(of);
        let placements = all.map(Placement::new);
        let buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("placements of textures"),
            size: size_of_val(&placements) as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        queue.write_buffer(&buffer, 0, bytemuck::cast_slice(&placements));
        let views = all.map(|texture| {
            let shown = self.pictures.get(&texture.picture);
            let shown = shown.filter(|_| !self.uploading.contains_key(&texture.picture));
            shown.unwrap_or(&self.blank).create_view(&wgpu::TextureViewDescriptor::default())
        });
        let samplers = all.map(|texture| sampler(device, texture.wrap));
        let mut resources = vec![buffer.as_entire_binding()];
        resources.extend(views.iter().map(wgpu::BindingResource::TextureView));
        resources.extend(samplers.iter().map(wgpu::BindingResource::Sampler));
        let entries: Vec<wgpu::BindGroupEntry<'_>> = (0..)
            .zip(resources)
            .map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource })
            .collect();
        device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("textures"),
            layout: &self.layout,
            entries: &entries,
        })
    }
}

fn texture(device: &wgpu::Device, [width, height]: [u32; 2]) -> wgpu::Texture {
    let size = wgpu::Extent3d { width, height, depth_or_array_layers: 1 };
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some("picture"),
        size,
        mip_level_count: size.max_mips(wgpu::TextureDimension::D2),
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: FORMAT,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    })
}

fn sampler(device: &wgpu::Device, wrap: [Wrap; 2]) -> wgpu::Sampler {
    let [address_mode_u, address_mode_v] = wrap.map(|wrap| match wrap {
        Wrap::Repeat => wgpu::AddressMode::Repeat,
        Wrap::Mirror => wgpu::AddressMode::MirrorRepeat,
        Wrap::Clamp => wgpu::AddressMode::ClampToEdge,
    });
    device.create_sampler(&wgpu::SamplerDescriptor {
        label: Some("texture"),
        address_mode_u,
        address_mode_v,
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        mipmap_filter: wgpu::MipmapFilterMode::Linear,
        anisotropy_clamp: ANISOTROPY,
        ..Default::default()
    })
}

impl TexturedPipelines {
    fn new(
        device: &wgpu::Device,
        uniforms: &wgpu::BindGroupLayout,
        textures: &wgpu::BindGroupLayout,
    ) -> Self {
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
            label: Some("textured faces"),
            source: wgpu::ShaderSource::Wgsl(
                concat!(
                    include_str!("shaders/common.wgsl"),
                    include_str!("shaders/faces.wgsl"),
                    include_str!("shaders/textured.wgsl")
                )
                .into(),
            ),
        });
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label: Some("textured faces"),
            bind_group_layouts: &[Some(uniforms), Some(textures)],
            immediate_size: 0,
        });
        let pipeline = |vertex, depth, blend, cull| {
            let buffers = [
                buffer(12, VertexStepMode::Vertex, &vertex_attr_array![0 => Float32x3]),
                buffer(8, VertexStepMode::Vertex, &vertex_attr_array![1 => Snorm16x4]),
                buffer(4, VertexStepMode::Vertex, &vertex_attr_array![2 => Unorm8x4]),
                buffer(8, VertexStepMode::Vertex, &vertex_attr_array![3 => Float32x2]),
            ];
            let maker = Maker { device, layout: &layout, cull };
            let stages = (&module, vertex, "textured_fragment");
            maker.pipeline("textured faces", stages, &buffers, depth, blend)
        };
        let over = Some(wgpu::BlendState::ALPHA_BLENDING);
        let (opaque, translucent) = ("textured_vertex", "translucent_vertex");
        Self {
            all: pipeline(opaque, Depth::Write, None, None),
            fronts: pipeline(opaque, Depth::Write, None, Some(wgpu::Face::Back)),
            glass_backs: pipeline(opaque, Depth::Ignore, over, Some(wgpu::Face::Front)),
            glass_fronts: pipeline(opaque, Depth::Ignore, over, Some(wgpu::Face::Back)),
            clear_backs: pipeline(translucent, Depth::Test, over, Some(wgpu::Face::Front)),
            clear_fronts: pipeline(translucent, Depth::Test, over, Some(wgpu::Face::Back)),
        }
    }
}

impl Renderer {
    /// Sets the looks of the document's materials. Objects that show textures have to be uploaded again, which
    /// [`Renderer::fits_style`] says; others use them when they are uploaded.
    pub fn set_materials(&mut self, materials: Materials) {
        if *self.materials != materials {
            self.materials = Arc::new(materials);
            self.textures_changed();
        }
    }

    /// Sets a picture that textures may show, in place of the one of this number.
    /// [`Renderer::upload_pictures`] uploads it; until then faces show their colours.
    pub fn set_picture(&mut self, device: &wgpu::Device, number: u64, picture: Picture) {
        let most = device.limits().max_texture_dimension_2d;
        if picture.size.iter().any(|side| *side == 0 || *side > most) {
            return;
        }
        self.textures.pictures.insert(number, texture(device, picture.size));
        self.textures.uploading.insert(number, Uploading { picture, level: 0, row: 0, done: 0 });
        self.textures_changed();
    }

    /// Uploads about this many bytes more of the pictures; returns whether there are any left.
    pub fn upload_pictures(&mut self, queue: &wgpu::Queue, mut bytes: usize) -> bool {
        let Textures { pictures, uploading, .. } = &mut self.textures;
        let before = uploading.len();
        uploading.retain(|number, upload| {
            let texture = pictures.get(number);
            bytes == 0 || !texture.is_none_or(|texture| upload.step(queue, texture, &mut bytes))
        });
        let left = uploading.len();
        if left < before {
            self.textures_changed();
        }
        left > 0
    }

    /// Whether a picture was set.
    pub fn has_picture(&self, number: u64) -> bool {
        self.textures.pictures.contains_key(&number)
    }

    /// Forgets the pictures of which this doesn't hold.
    pub fn retain_pictures(&mut self, is_kept: impl Fn(u64) -> bool) {
        let before = self.textures.pictures.len();
        self.textures.pictures.retain(|number, _| is_kept(*number));
        self.textures.uploading.retain(|number, _| is_kept(*number));
        if self.textures.pictures.len() < before {
            self.textures_changed();
        }
    }

    /// Bytes of GPU memory in pictures.
    pub fn picture_bytes(&self) -> u64 {
        let bytes =
            |texture: &wgpu::Texture| u64::from(texture.width()) * u64::from(texture.height()) * 16 / 3;
        self.textures.pictures.values().map(bytes).sum()
    }

    fn textures_changed(&mut self) {
        self.textures.passes.clear();
        self.generation += 1;
    }
}
