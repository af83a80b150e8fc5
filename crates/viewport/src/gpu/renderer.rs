//! The renderer: objects and highlights go in when they change, pictures come out.

use super::highlight::{Highlight, Layer, Marked};
use super::object::Object;
use super::pipelines::Pipelines;
use super::stream::Stream;
use super::targets::Targets;
use super::uniforms::{DrawUniform, FrameUniform, rgba};
use crate::{Camera, Style};
use glam::Vec3;
use halfedge::{Mesh, Touched};
use std::collections::HashMap;

/// Distance between draw uniforms: what every device allows as a dynamic offset.
const DRAW_STRIDE: usize = 256;

/// What changed about an object.
#[derive(Clone, Copy, Debug)]
pub enum ObjectChange<'a> {
    /// It is new, or another mesh.
    Everything,
    /// An edit, an undo or a redo touched this.
    Touched(&'a Touched),
}

/// One object in a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ObjectDraw {
    /// As told to [`Renderer::sync_object`].
    pub id: u64,
    /// Whether it is drawn at all.
    pub visible: bool,
    /// Whether it is the one being edited, which shows its edges and vertices.
    pub active: bool,
}

/// What to draw.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// The viewport's size in physical pixels.
    pub size: [u32; 2],
    /// How large dots and lines are.
    pub pixels_per_point: f32,
    /// Seen from here.
    pub camera: &'a Camera,
    /// These objects, those not synchronised left out.
    pub objects: &'a [ObjectDraw],
    /// Like this.
    pub style: &'a Style,
}

/// A frame as it was last drawn, to see whether the next is the same.
#[derive(Clone, Debug, PartialEq)]
struct Drawn {
    size: [u32; 2],
    pixels_per_point: f32,
    camera: Camera,
    objects: Vec<ObjectDraw>,
    style: Style,
    generation: u64,
}

/// Draws objects into textures of its own, and those into a render pass.
///
/// When something changes: [`Renderer::sync_object`], [`Renderer::set_highlight`]. Each frame:
/// [`Renderer::prepare`] with a command encoder, then [`Renderer::paint`] in a render pass with one
/// sample, the target format and no depth. A frame like the one before is not drawn again.
pub struct Renderer {
    pipelines: Pipelines,
    objects: HashMap<u64, Object>,
    selected: Marked,
    hovered: Marked,
    targets: Option<Targets>,
    frame_buffer: wgpu::Buffer,
    draw_buffer: wgpu::Buffer,
    bind_group: wgpu::BindGroup,
    generation: u64,
    drawn: Option<Drawn>,
}

/// One draw of a frame: which pipeline's turn it is and its uniform's place.
enum Step<'a> {
    Background,
    Mesh(&'a Object),
    Points(&'a Stream),
    Ground,
    Marked(&'a Marked, Shape),
}

#[derive(Clone, Copy)]
enum Shape {
    Fill,
    Lines,
    Arrows,
    Points,
}

impl Renderer {
    /// A renderer that paints into targets of this format.
    pub fn new(device: &wgpu::Device, target: wgpu::TextureFormat) -> Self {
        let pipelines = Pipelines::new(device, target);
        let frame_buffer = uniform_buffer(device, "viewport frame", size_of::<FrameUniform>());
        let draw_buffer = uniform_buffer(device, "viewport draws", DRAW_STRIDE * 32);
        let bind_group = bind(device, &pipelines, &frame_buffer, &draw_buffer);
        Self {
            pipelines,
            objects: HashMap::new(),
            selected: Marked::new(),
            hovered: Marked::new(),
            targets: None,
            frame_buffer,
            draw_buffer,
            bind_group,
            generation: 0,
            drawn: None,
        }
    }

    /// Follows an object's mesh; gives the bytes uploaded. A touched mesh costs in proportion to
    /// what was touched; an object not seen before, or built for a style with other normals or
    /// without the dots that are now wanted, is uploaded whole.
    pub fn sync_object(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        id: u64,
        mesh: &Mesh,
        change: ObjectChange<'_>,
        style: &Style,
    ) -> u64 {
        self.generation += 1;
        let fits = self.fits_style(id, style);
        let object = self.objects.entry(id).or_insert_with(Object::new);
        match change {
            ObjectChange::Touched(touched) if fits && !touched.everything => {
                object.update(device, queue, mesh, touched)
            }
            _ => object.rebuild(device, queue, mesh, style.smooth, style.vertices),
        }
    }

    /// Begins to upload an object's mesh whole; what was uploaded before is drawn until
    /// [`Renderer::upload_faces`] has uploaded all of it. For meshes that take longer than a frame: it takes
    /// the memory of both meanwhile.
    pub fn begin_object_upload(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        id: u64,
        mesh: &Mesh,
        style: &Style,
    ) {
        let object = self.objects.entry(id).or_insert_with(Object::new);
        object.begin_upload(device, queue, mesh, style.smooth, style.vertices);
    }

    /// Whether an object's upload has begun and is not done.
    pub fn is_uploading(&self, id: u64) -> bool {
        self.objects.get(&id).is_some_and(Object::is_uploading)
    }

    /// Uploads so many faces more of an object that is behind, with its mesh as it is now; gives whether
    /// that was the last of it. Highlights are due then: positions count from elsewhere.
    pub fn upload_faces(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        id: u64,
        mesh: &Mesh,
        faces: usize,
    ) -> bool {
        let object = self.objects.get_mut(&id).filter(|object| object.is_uploading());
        let done = object.is_some_and(|object| object.upload_faces(device, queue, mesh, faces));
        self.generation += u64::from(done);
        done
    }

    /// Whether the object's buffers suit the style. If not, [`Renderer::sync_object`] is due even
    /// though the mesh is the same.
    pub fn fits_style(&self, id: u64, style: &Style) -> bool {
        self.objects
            .get(&id)
            .map(Object::looks)
            .is_some_and(|(smooth, has_points)| smooth == style.smooth && (has_points || !style.vertices))
    }

    /// Forgets an object.
    pub fn remove_object(&mut self, id: u64) {
        self.generation += 1;
        self.objects.remove(&id);
    }

    /// Forgets the objects that are not wanted.
    pub fn retain_objects(&mut self, mut wanted: impl FnMut(u64) -> bool) {
        self.generation += 1;
        self.objects.retain(|&id, _| wanted(id));
    }

    /// Replaces a highlight. Call it when its elements change, and after
    /// [`Renderer::sync_object`] when their object did. Costs O(elements); faces also O(face ids)/64.
    pub fn set_highlight(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        layer: Layer,
        highlight: Option<Highlight<'_>>,
    ) {
        self.begin_highlight_upload(device, layer, highlight);
        if let Some(highlight) = highlight {
            self.upload_highlight_elements(device, queue, layer, highlight.mesh, usize::MAX);
        }
    }

    /// Begins to replace a highlight, which [`Renderer::upload_highlight_elements`] does, for those of more
    /// elements than there is time for in a frame. Otherwise as [`Renderer::set_highlight`].
    pub fn begin_highlight_upload(
        &mut self,
        device: &wgpu::Device,
        layer: Layer,
        highlight: Option<Highlight<'_>>,
    ) {
        let highlight = highlight.and_then(|h| Some((h, self.objects.get(&h.object)?.buffers.origin())));
        let marked = self.marked(layer);
        if marked.object.is_none() && highlight.is_none() {
            return;
        }
        marked.begin_upload(device, highlight);
        self.generation += 1;
    }

    /// Uploads so many elements more of a highlight that has begun, with the same mesh; gives whether
    /// there are any left.
    pub fn upload_highlight_elements(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        layer: Layer,
        mesh: &Mesh,
        elements: usize,
    ) -> bool {
        let marked = self.marked(layer);
        if !marked.is_uploading() {
            return false;
        }
        let is_left = marked.upload_elements(device, queue, mesh, elements);
        self.generation += 1;
        is_left
    }

    fn marked(&mut self, layer: Layer) -> &mut Marked {
        match layer {
            Layer::Selected => &mut self.selected,
            Layer::Hovered => &mut self.hovered,
        }
    }

    /// Bytes of GPU memory in vertex buffers of objects.
    pub fn gpu_bytes(&self) -> u64 {
        self.objects.values().map(Object::gpu_bytes).sum()
    }

    /// Draws the frame into the renderer's own textures, unless that is what they show already.
    /// Gives whether it drew.
    pub fn prepare(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        frame: &Frame<'_>,
    ) -> bool {
        let size = Targets::fit(device, frame.size);
        let wanted = Drawn {
            size,
            pixels_per_point: frame.pixels_per_point,
            camera: *frame.camera,
            objects: frame.objects.to_vec(),
            style: *frame.style,
            generation: self.generation,
        };
        if self.drawn.as_ref() == Some(&wanted) {
            return false;
        }
        self.drawn = Some(wanted);
        if self.targets.as_ref().is_none_or(|t| t.size != size) {
            self.targets = Some(Targets::new(device, &self.pipelines.picture, size));
        }
        let uniform = FrameUniform::new(frame.camera, size, frame.pixels_per_point, frame.style);
        queue.write_buffer(&self.frame_buffer, 0, bytemuck::bytes_of(&uniform));

        let count = self.steps(frame).len();
        let needed = (count * DRAW_STRIDE) as u64;
        if self.draw_buffer.size() < needed {
            self.draw_buffer = uniform_buffer(device, "viewport draws", needed.next_power_of_two() as usize);
            self.bind_group = bind(device, &self.pipelines, &self.frame_buffer, &self.draw_buffer);
        }
        let steps = self.steps(frame);
        let mut uniforms = vec![0_u8; needed as usize];
        for ((_, uniform), place) in steps.iter().zip(uniforms.chunks_mut(DRAW_STRIDE)) {
            let bytes = bytemuck::bytes_of(uniform);
            if let Some(place) = place.get_mut(..bytes.len()) {
                place.copy_from_slice(bytes);
            }
        }
        queue.write_buffer(&self.draw_buffer, 0, &uniforms);
        if let Some(targets) = &self.targets {
            self.encode(encoder, targets, &steps);
        }
        true
    }

    /// Puts the picture into the render pass, filling its viewport.
    pub fn paint(&self, pass: &mut wgpu::RenderPass<'_>) {
        if let Some(targets) = &self.targets {
            pass.set_pipeline(&self.pipelines.composite);
            pass.set_bind_group(0, &targets.bind_group, &[]);
            pass.draw(0..3, 0..1);
        }
    }

    /// What a frame draws, in order.
    fn steps(&self, frame: &Frame<'_>) -> Vec<(Step<'_>, DrawUniform)> {
        let Frame { camera, style, pixels_per_point: ppp, .. } = *frame;
        let theme = &style.theme;
        let plain = DrawUniform::new(camera, Vec3::ZERO, [0.0; 4], [0.0; 4]);
        let mut steps = vec![(Step::Background, plain)];
        let visible = || {
            let shown = frame.objects.iter().filter(|o| o.visible);
            shown.filter_map(|o| Some((o, self.objects.get(&o.id)?)))
        };
        for (draw, object) in visible() {
            let lines = if style.wireframe && draw.active { 1.0 } else { 0.0 };
            let params = [0.6 * ppp, lines, 0.0, 0.0];
            steps.push((
                Step::Mesh(object),
                DrawUniform::new(camera, object.buffers.origin(), [0.0; 4], params),
            ));
        }
        if style.grid {
            steps.push((Step::Ground, plain));
        }
        for (draw, object) in visible() {
            let origin = object.buffers.origin();
            let mut push = |points, color, radius, rim| {
                let params = [radius * ppp, rim * ppp, 1e-3, 0.0];
                steps
                    .push((Step::Points(points), DrawUniform::new(camera, origin, rgba(color, 1.0), params)));
            };
            if draw.active && style.vertices && object.has_points {
                push(&object.points, theme.vertex, 2.5, 0.0);
            }
            if object.isolated.points.len() > 0 {
                push(&object.isolated.points, theme.isolated, 3.5, 1.0);
            }
        }
        for (marked, color) in [(&self.selected, theme.selected), (&self.hovered, theme.hovered)] {
            let Some((_, object)) = visible().find(|(draw, _)| Some(draw.id) == marked.object) else {
                continue;
            };
            let mut push = |shape, alpha, params| {
                let uniform = DrawUniform::new(camera, object.buffers.origin(), rgba(color, alpha), params);
                steps.push((Step::Marked(marked, shape), uniform));
            };
            push(Shape::Fill, 0.4, [0.0; 4]);
            push(Shape::Lines, 1.0, [1.25 * ppp, 0.0, 0.0, 0.0]);
            push(Shape::Arrows, 1.0, [1.1 * ppp, 4.0 * ppp, 9.0 * ppp, 0.0]);
            push(Shape::Points, 1.0, [4.5 * ppp, 1.0 * ppp, 0.0, 0.0]);
        }
        steps
    }

    fn encode(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        targets: &Targets,
        steps: &[(Step<'_>, DrawUniform)],
    ) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("viewport"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &targets.samples,
                depth_slice: None,
                resolve_target: Some(&targets.resolved),
                ops: wgpu::Operations {
                    load: wgpu::LoadOp::Clear(wgpu::Color::BLACK),
                    store: wgpu::StoreOp::Discard,
                },
            })],
            depth_stencil_attachment: Some(wgpu::RenderPassDepthStencilAttachment {
                view: &targets.depth,
                depth_ops: Some(wgpu::Operations {
                    load: wgpu::LoadOp::Clear(0.0),
                    store: wgpu::StoreOp::Discard,
                }),
                stencil_ops: None,
            }),
            timestamp_writes: None,
            occlusion_query_set: None,
            multiview_mask: None,
        });
        let p = &self.pipelines;
        for (at, (step, _)) in steps.iter().enumerate() {
            pass.set_bind_group(0, &self.bind_group, &[(at * DRAW_STRIDE) as u32]);
            match step {
                Step::Background => {
                    pass.set_pipeline(&p.background);
                    pass.draw(0..3, 0..1);
                }
                Step::Ground => {
                    pass.set_pipeline(&p.ground);
                    pass.draw(0..6, 0..1);
                }
                Step::Mesh(object) => {
                    pass.set_pipeline(&p.mesh);
                    for page in &object.pages {
                        let streams = (page.positions.slice(), page.normals.slice(), page.colors.slice());
                        if let (Some(positions), Some(normals), Some(colors)) = streams {
                            pass.set_vertex_buffer(0, positions);
                            pass.set_vertex_buffer(1, normals);
                            pass.set_vertex_buffer(2, colors);
                            pass.draw(0..page.vertices(), 0..1);
                        }
                    }
                }
                Step::Points(points) => instances(&mut pass, &p.points, points, 12, 6),
                Step::Marked(marked, Shape::Fill) => {
                    if let Some(fill) = marked.fill.slice() {
                        pass.set_pipeline(&p.marked_fill);
                        pass.set_vertex_buffer(0, fill);
                        pass.draw(0..(marked.fill.len() / 12) as u32, 0..1);
                    }
                }
                Step::Marked(marked, Shape::Lines) => {
                    instances(&mut pass, &p.marked_lines, &marked.lines, 24, 6);
                }
                Step::Marked(marked, Shape::Arrows) => {
                    instances(&mut pass, &p.marked_arrows, &marked.arrows, 36, 9);
                }
                Step::Marked(marked, Shape::Points) => {
                    instances(&mut pass, &p.marked_points, &marked.points, 12, 6);
                }
            }
        }
    }
}

/// Draws a shape of this many vertices for each entry of a stream.
fn instances(
    pass: &mut wgpu::RenderPass<'_>,
    pipeline: &wgpu::RenderPipeline,
    stream: &Stream,
    entry: u64,
    vertices: u32,
) {
    if let Some(slice) = stream.slice() {
        pass.set_pipeline(pipeline);
        pass.set_vertex_buffer(0, slice);
        pass.draw(0..vertices, 0..(stream.len() / entry) as u32);
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
