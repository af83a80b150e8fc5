//! Shaders and pipelines.

use super::shadow::ShadowPipelines;
use super::targets::{COLOR_FORMAT, DEPTH_FORMAT, SAMPLES_PER_PIXEL};
use super::uniforms::{DrawUniform, FrameUniform};
use std::num::NonZeroU64;
use wgpu::{VertexStepMode, vertex_attr_array};

/// All pipelines and their bind group layouts.
pub struct Pipelines {
    pub uniforms: wgpu::BindGroupLayout,
    pub picture: wgpu::BindGroupLayout,
    pub surface: wgpu::BindGroupLayout,
    pub background: wgpu::RenderPipeline,
    pub mesh: wgpu::RenderPipeline,
    /// Without the back sides of faces.
    pub mesh_fronts: wgpu::RenderPipeline,
    pub ground: wgpu::RenderPipeline,
    pub shadow: wgpu::RenderPipeline,
    /// Translucent back sides of faces, which hide nothing.
    pub glass_backs: wgpu::RenderPipeline,
    pub glass_fronts: wgpu::RenderPipeline,
    /// Faces that aren't seen, but hide what is drawn later.
    pub veil: wgpu::RenderPipeline,
    /// Dots, lines and fills that are behind faces.
    pub behind: Marks,
    /// Those that are in front.
    pub in_front: Marks,
    pub composite: wgpu::RenderPipeline,
}

/// The pipelines of dots, and of highlights.
pub struct Marks {
    pub points: wgpu::RenderPipeline,
    pub lines: wgpu::RenderPipeline,
    pub arrows: wgpu::RenderPipeline,
    pub fill: wgpu::RenderPipeline,
}

/// How a pipeline uses the depth buffer. Depth is reversed: greater is nearer.
#[derive(Clone, Copy)]
pub(super) enum Depth {
    Write,
    Test,
    /// What [`Depth::Test`] leaves out.
    Behind,
    Ignore,
}

/// Keeps the colours that are there.
const KEEP: wgpu::BlendState = {
    let keep = wgpu::BlendComponent {
        src_factor: wgpu::BlendFactor::Zero,
        dst_factor: wgpu::BlendFactor::One,
        operation: wgpu::BlendOperation::Add,
    };
    wgpu::BlendState { color: keep, alpha: keep }
};

#[derive(Clone, Copy)]
pub(super) struct Maker<'a> {
    pub device: &'a wgpu::Device,
    pub layout: &'a wgpu::PipelineLayout,
    pub cull: Option<wgpu::Face>,
}

impl Maker<'_> {
    pub fn pipeline(
        &self,
        label: &str,
        (module, vertex, fragment): (&wgpu::ShaderModule, &str, &str),
        buffers: &[Option<wgpu::VertexBufferLayout<'_>>],
        depth: Depth,
        blend: Option<wgpu::BlendState>,
    ) -> wgpu::RenderPipeline {
        let (write, compare) = match depth {
            Depth::Write => (true, wgpu::CompareFunction::Greater),
            Depth::Test => (false, wgpu::CompareFunction::GreaterEqual),
            Depth::Behind => (false, wgpu::CompareFunction::Less),
            Depth::Ignore => (false, wgpu::CompareFunction::Always),
        };
        self.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label: Some(label),
            layout: Some(self.layout),
            vertex: wgpu::VertexState {
                module,
                entry_point: Some(vertex),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                buffers,
            },
            primitive: wgpu::PrimitiveState { cull_mode: self.cull, ..Default::default() },
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(write),
                depth_compare: Some(compare),
                stencil: wgpu::StencilState::default(),
                bias: wgpu::DepthBiasState::default(),
            }),
            multisample: wgpu::MultisampleState { count: SAMPLES_PER_PIXEL, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module,
                entry_point: Some(fragment),
                compilation_options: wgpu::PipelineCompilationOptions::default(),
                targets: &[Some(wgpu::ColorTargetState {
                    format: COLOR_FORMAT,
                    blend,
                    write_mask: wgpu::ColorWrites::ALL,
                })],
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}

pub(super) fn buffer<'a>(
    stride: u64,
    step_mode: VertexStepMode,
    attributes: &'a [wgpu::VertexAttribute],
) -> Option<wgpu::VertexBufferLayout<'a>> {
    Some(wgpu::VertexBufferLayout { array_stride: stride, step_mode, attributes })
}

pub(super) fn uniform(binding: u32, has_dynamic_offset: bool, size: usize) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset,
            min_binding_size: NonZeroU64::new(size as u64),
        },
        count: None,
    }
}

/// A picture that fragments sample between its pixels.
pub(super) fn filtered_picture(binding: u32) -> wgpu::BindGroupLayoutEntry {
    for_fragments(
        binding,
        wgpu::BindingType::Texture {
            sample_type: wgpu::TextureSampleType::Float { filterable: true },
            view_dimension: wgpu::TextureViewDimension::D2,
            multisampled: false,
        },
    )
}

/// A sampler for such pictures.
pub(super) fn filtering_sampler(binding: u32) -> wgpu::BindGroupLayoutEntry {
    for_fragments(binding, wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering))
}

fn for_fragments(binding: u32, ty: wgpu::BindingType) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::FRAGMENT, ty, count: None }
}

impl Pipelines {
    pub fn new(device: &wgpu::Device, target: wgpu::TextureFormat) -> (Self, ShadowPipelines) {
        let uniforms = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("viewport uniforms"),
            entries: &[
                uniform(0, false, size_of::<FrameUniform>()),
                uniform(1, true, size_of::<DrawUniform>()),
            ],
        });
        let picture = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
            label: Some("viewport picture"),
            entries: &[wgpu::BindGroupLayoutEntry {
                binding: 0,
                visibility: wgpu::ShaderStages::FRAGMENT,
                ty: wgpu::BindingType::Texture {
                    sample_type: wgpu::TextureSampleType::Float { filterable: false },
                    view_dimension: wgpu::TextureViewDimension::D2,
                    multisampled: false,
                },
                count: None,
            }],
        });
        let surface = surface_layout(device);
        let layout = |label, groups: &[Option<&wgpu::BindGroupLayout>]| {
            device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: Some(label),
                bind_group_layouts: groups,
                immediate_size: 0,
            })
        };
        let of_scene = layout("viewport scene", &[Some(&uniforms)]);
        let of_surfaces = layout("viewport surfaces", &[Some(&uniforms), Some(&surface)]);
        let shader = |label, source: &str| {
            device.create_shader_module(wgpu::ShaderModuleDescriptor {
                label: Some(label),
                source: wgpu::ShaderSource::Wgsl(source.into()),
            })
        };
        let mesh = shader(
            "mesh",
            concat!(
                include_str!("shaders/common.wgsl"),
                include_str!("shaders/faces.wgsl"),
                include_str!("shaders/mesh.wgsl")
            ),
        );
        let overlay = shader(
            "overlay",
            concat!(include_str!("shaders/common.wgsl"), include_str!("shaders/overlay.wgsl")),
        );
        let ground = shader(
            "ground",
            concat!(include_str!("shaders/common.wgsl"), include_str!("shaders/ground.wgsl")),
        );
        let shadow = shader(
            "shadow",
            concat!(include_str!("shaders/common.wgsl"), include_str!("shaders/shadow.wgsl")),
        );
        let shadow_pipelines = ShadowPipelines::new(device, &shadow, &of_scene, &of_surfaces);
        let maker = Maker { device, layout: &of_scene, cull: None };
        let over = Some(wgpu::BlendState::ALPHA_BLENDING);
        let (corner, instance) = (VertexStepMode::Vertex, VertexStepMode::Instance);
        let one = vertex_attr_array![0 => Float32x3];
        let two = vertex_attr_array![0 => Float32x3, 1 => Float32x3];
        let three = vertex_attr_array![0 => Float32x3, 1 => Float32x3, 2 => Float32x3];
        let marks = |depth| {
            let pipeline = |label, vertex, fragment, buffers| {
                maker.pipeline(label, (&overlay, vertex, fragment), &[buffers], depth, over)
            };
            Marks {
                points: pipeline("dots", "dot_vertex", "dot_fragment", buffer(12, instance, &one)),
                lines: pipeline("lines", "line_vertex", "flat_fragment", buffer(24, instance, &two)),
                arrows: pipeline("arrows", "arrow_vertex", "flat_fragment", buffer(36, instance, &three)),
                fill: pipeline("fill", "fill_vertex", "flat_fragment", buffer(12, corner, &one)),
            }
        };
        let faces = |label, depth, blend, cull| {
            let buffers = [
                buffer(12, corner, &one),
                buffer(8, corner, &vertex_attr_array![1 => Snorm16x4]),
                buffer(4, corner, &vertex_attr_array![2 => Unorm8x4]),
            ];
            let stages = (&mesh, "mesh_vertex", "mesh_fragment");
            let maker = Maker { layout: &of_surfaces, cull, ..maker };
            maker.pipeline(label, stages, &buffers, depth, blend)
        };
        let on_ground = Maker { layout: &of_surfaces, ..maker };
        let pipelines = Self {
            background: maker.pipeline(
                "background",
                (&ground, "background_vertex", "background_fragment"),
                &[],
                Depth::Ignore,
                None,
            ),
            ground: maker.pipeline(
                "ground",
                (&ground, "ground_vertex", "ground_fragment"),
                &[],
                Depth::Ignore,
                over,
            ),
            shadow: on_ground.pipeline(
                "shadow on the ground",
                (&shadow, "shadow_vertex", "shadow_fragment"),
                &[],
                Depth::Ignore,
                over,
            ),
            mesh: faces("mesh", Depth::Write, None, None),
            mesh_fronts: faces("fronts", Depth::Write, None, Some(wgpu::Face::Back)),
            glass_backs: faces("translucent backs", Depth::Ignore, over, Some(wgpu::Face::Front)),
            glass_fronts: faces("translucent fronts", Depth::Ignore, over, Some(wgpu::Face::Back)),
            veil: faces("depth of a translucent mesh", Depth::Write, Some(KEEP), None),
            behind: marks(Depth::Behind),
            in_front: marks(Depth::Test),
            composite: composite(device, &picture, target),
            uniforms,
            picture,
            surface,
        };
        (pipelines, shadow_pipelines)
    }
}

/// What surfaces are shaded with: a matcap's picture and a sampler.
fn surface_layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: Some("viewport surface"),
        entries: &[filtered_picture(0), filtering_sampler(1)],
    })
}

fn composite(
    device: &wgpu::Device,
    picture: &wgpu::BindGroupLayout,
    target: wgpu::TextureFormat,
) -> wgpu::RenderPipeline {
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("composite"),
        source: wgpu::ShaderSource::Wgsl(include_str!("shaders/composite.wgsl").into()),
    });
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("composite"),
        bind_group_layouts: &[Some(picture)],
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("composite"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("composite_vertex"),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: None,
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some(if target.is_srgb() { "composite_linear" } else { "composite_gamma" }),
            compilation_options: wgpu::PipelineCompilationOptions::default(),
            targets: &[Some(wgpu::ColorTargetState {
                format: target,
                blend: None,
                write_mask: wgpu::ColorWrites::ALL,
            })],
        }),
        multiview_mask: None,
        cache: None,
    })
}
