//! The soft shadow on the ground. Its map is drawn again only when objects change, so that it costs one textured
//! square in other frames.

use super::frame::ObjectDraw;
use super::surface::{bind_picture, picture_texture};
use super::uniforms::{DrawUniform, number_of_axis};
use crate::{Bounds, Camera, UpAxis};
use glam::Vec3;

/// Pixels on each side of the map.
const MAP_SIDE_PX: u32 = 256;
/// The map's half-width, in halves of the scene's greatest horizontal extent: room for the blur.
const MAP_WIDTH_PER_SCENE: f32 = 1.4;

/// Where the map lies: on the ground below the middle of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground {
    pub middle: Vec3,
    pub half_width: f32,
    pub up: UpAxis,
}

impl Ground {
    /// The ground under the camera's scene; none if there is nothing to cast a shadow, or if the camera looks from
    /// below the ground.
    pub fn below(camera: &Camera) -> Option<Self> {
        let scene: Bounds = camera.scene()?;
        let up = camera.up;
        let size = up.to_upright((scene.max - scene.min).as_dvec3()).abs();
        let half_width = size.x.max(size.z) as f32 * 0.5 * MAP_WIDTH_PER_SCENE;
        let (center, lowest) = (scene.center().as_dvec3(), up.to_upright(scene.min.as_dvec3()).y);
        let middle = up.to_scene(up.to_upright(center).with_y(lowest)).as_vec3();
        let is_above = up.to_upright(camera.eye()).y > lowest;
        let is_seen = is_above || camera.orthographic && camera.pitch > 0.0;
        (half_width.is_normal() && is_seen).then_some(Self { middle, half_width, up })
    }

    /// The uniform of an object that casts a shadow.
    pub fn cast(self, origin: Vec3) -> DrawUniform {
        let offset = (origin.as_dvec3() - self.middle.as_dvec3()).as_vec3();
        DrawUniform {
            offset: offset.extend(1.0 / self.half_width).to_array(),
            color: [0.0; 4],
            params: [number_of_axis(self.up), 0.0, 0.0, 0.0],
        }
    }
}

/// What the map shows.
#[derive(Clone, Debug, PartialEq)]
pub struct MapKey {
    pub ground: Ground,
    pub visible: Vec<u64>,
    /// Counts the changes of meshes.
    pub shapes: u64,
}

impl MapKey {
    pub fn new(ground: Ground, objects: &[ObjectDraw], shapes: u64) -> Self {
        let visible = objects.iter().filter(|object| object.visible).map(|object| object.id);
        Self { ground, visible: visible.collect(), shapes }
    }
}

/// The map, and a second one between the two blurs.
pub struct Shadow {
    maps: [wgpu::TextureView; 2],
    /// For reading each of the maps.
    read: [wgpu::BindGroup; 2],
    drawn: Option<MapKey>,
    pipelines: ShadowPipelines,
}

/// The pipelines that draw the map.
pub struct ShadowPipelines {
    cast: wgpu::RenderPipeline,
    blurs: [wgpu::RenderPipeline; 2],
}

impl Shadow {
    pub fn new(device: &wgpu::Device, surface: &wgpu::BindGroupLayout, pipelines: ShadowPipelines) -> Self {
        let textures = [(); 2].map(|()| picture_texture(device, "shadow on the ground", [MAP_SIDE_PX; 2]));
        Self {
            maps: textures.each_ref().map(|texture| texture.create_view(&Default::default())),
            read: textures.each_ref().map(|texture| bind_picture(device, surface, texture)),
            drawn: None,
            pipelines,
        }
    }

    /// For reading the map.
    pub fn map(&self) -> &wgpu::BindGroup {
        &self.read[0]
    }

    /// Whether the map has to be drawn again to show this, which it is from now on.
    pub fn becomes(&mut self, key: MapKey) -> bool {
        let differs = self.drawn.as_ref() != Some(&key);
        self.drawn = Some(key);
        differs
    }

    /// Draws the map: `cast` draws the objects. Costs a draw of all objects, without shading.
    pub fn encode(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        uniforms: &wgpu::BindGroup,
        cast: impl FnOnce(&mut wgpu::RenderPass<'_>),
    ) {
        let [map, between] = &self.maps;
        let [read_map, read_between] = &self.read;
        let mut pass = begin(encoder, map);
        pass.set_pipeline(&self.pipelines.cast);
        cast(&mut pass);
        drop(pass);
        for (pipeline, (from, to)) in
            self.pipelines.blurs.iter().zip([(read_map, between), (read_between, map)])
        {
            let mut pass = begin(encoder, to);
            pass.set_pipeline(pipeline);
            pass.set_bind_group(0, uniforms, &[0]);
            pass.set_bind_group(1, from, &[]);
            pass.draw(0..3, 0..1);
        }
    }
}

fn begin<'a>(encoder: &'a mut wgpu::CommandEncoder, view: &wgpu::TextureView) -> wgpu::RenderPass<'a> {
    encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        label: Some("shadow"),
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations {
                load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                store: wgpu::StoreOp::Store,
            },
        })],
        ..Default::default()
    })
}

impl ShadowPipelines {
    pub fn new(
        device: &wgpu::Device,
        module: &wgpu::ShaderModule,
        scene: &wgpu::PipelineLayout,
        surfaces: &wgpu::PipelineLayout,
    ) -> Self {
        let pipeline = |layout, vertex, fragment, buffers: &[_], blend| {
            device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
                label: Some("shadow"),
                layout: Some(layout),
                vertex: wgpu::VertexState {
                    module,
                    entry_point: Some(vertex),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    buffers,
                },
                primitive: wgpu::PrimitiveState::default(),
                depth_stencil: None,
                multisample: wgpu::MultisampleState::default(),
                fragment: Some(wgpu::FragmentState {
                    module,
                    entry_point: Some(fragment),
                    compilation_options: wgpu::PipelineCompilationOptions::default(),
                    targets: &[Some(wgpu::ColorTargetState {
                        format: super::targets::COLOR_FORMAT,
                        blend,
                        write_mask: wgpu::ColorWrites::ALL,
                    })],
                }),
                multiview_mask: None,
                cache: None,
            })
        };
        // Of faces above each other the one nearest to the ground counts.
        let nearest = wgpu::BlendComponent {
            src_factor: wgpu::BlendFactor::One,
            dst_factor: wgpu::BlendFactor::One,
            operation: wgpu::BlendOperation::Max,
        };
        let nearest = wgpu::BlendState { color: nearest, alpha: nearest };
        let positions = Some(wgpu::VertexBufferLayout {
            array_stride: 12,
            step_mode: wgpu::VertexStepMode::Vertex,
            attributes: &wgpu::vertex_attr_array![0 => Float32x3],
        });
        Self {
            cast: pipeline(scene, "cast_vertex", "cast_fragment", &[positions], Some(nearest)),
            blurs: [
                pipeline(surfaces, "blur_vertex", "blur_across", &[], None),
                pipeline(surfaces, "blur_vertex", "blur_along", &[], None),
            ],
        }
    }
}
