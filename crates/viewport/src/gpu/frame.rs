//! A frame's draws: listing and encoding them.

use super::highlight::{HighlightBuffers, Layer};
use super::object::Object;
use super::pipelines::Marks;
use super::renderer::Renderer;
use super::screen::DRAW_UNIFORM_STRIDE;
use super::stream::Stream;
use super::targets::Targets;
use super::uniforms::{DrawUniform, rgba};
use crate::materials::TEXTURES_PER_DRAW;
use crate::{Camera, Look, Mark, Style, Theme};
use glam::Vec3;

/// More isolated vertices than this are drawn as small dots.
const MAX_LARGE_ISOLATED_VERTICES: u64 = 200;

/// One object in a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ObjectDraw {
    /// Its id, as given to [`Renderer::sync_object`].
    pub id: u64,
    /// Whether it is drawn at all.
    pub visible: bool,
    /// Whether it is the one being edited, whose edges and vertices are drawn.
    pub active: bool,
}

/// What to draw.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// The viewport's size in physical pixels.
    pub size: [u32; 2],
    /// Physical pixels per point, for the sizes of dots and lines.
    pub pixels_per_point: f32,
    /// The camera.
    pub camera: &'a Camera,
    /// The objects; those that were never uploaded are left out.
    pub objects: &'a [ObjectDraw],
    /// The style.
    pub style: &'a Style,
}

/// The last frame drawn, to find out whether the next is the same.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FrameKey {
    pub size: [u32; 2],
    pub pixels_per_point: f32,
    pub camera: Camera,
    pub objects: Vec<ObjectDraw>,
    pub style: Style,
    /// Counts the changes of buffers.
    pub generation: u64,
}

/// One draw of a frame.
pub(super) enum Draw<'a> {
    Background,
    Mesh(&'a Object, Faces),
    /// The faces that show the textures of a pass.
    Textured(&'a Object, Faces, usize),
    Points(&'a Stream, Side),
    Lines(&'a Stream, Side),
    Ground,
    Shadow,
    Highlight(&'a HighlightBuffers, Shape, Side),
}

/// Which faces are drawn, and how.
#[derive(Clone, Copy)]
pub(super) enum Faces {
    All,
    Fronts,
    /// The back sides, translucent.
    GlassBacks,
    GlassFronts,
    /// The back sides of faces of translucent materials.
    ClearBacks,
    ClearFronts,
    /// All faces unseen, for the depths of those drawn as glass.
    Veil,
}

/// Whether marks are drawn where they are behind faces, or where they are in front.
#[derive(Clone, Copy)]
pub(super) enum Side {
    Behind,
    InFront,
}

/// How much of the colours behind translucent faces shows.
const XRAY_TRANSLUCENCY: f32 = 0.5;
/// How strong marks behind faces are.
const STRENGTH_BEHIND_FACES: f32 = 0.35;
/// How many points nearer to the eye than they are marks count as, so that faces beside them don't hide them.
const MARK_OFFSET_POINTS: f32 = 4.0;

/// The kinds of primitive in a highlight.
#[derive(Clone, Copy)]
pub(super) enum Shape {
    Fill,
    Lines,
    Arrows,
    Points,
}

/// What highlights consist of, in order: layer, shape, opacity and sizes in points. A hovered vertex or edge has a wider
/// mark under that of the selection, a hovered face a tint and an outline: the selection's colour stays. The active
/// element has a core of its colour within the selection's mark.
const MARKS: [(Layer, Shape, f32, [f32; 3]); 12] = [
    (Layer::Selected, Shape::Fill, 0.35, [0.0; 3]),
    (Layer::Active, Shape::Fill, 0.25, [0.0; 3]),
    (Layer::Hovered, Shape::Fill, 0.15, [0.0; 3]),
    (Layer::Hovered, Shape::Lines, 1.0, [2.25, 0.0, 0.0]),
    (Layer::Selected, Shape::Lines, 1.0, [1.25, 0.0, 0.0]),
    (Layer::Active, Shape::Lines, 1.0, [0.6, 0.0, 0.0]),
    (Layer::Hovered, Shape::Arrows, 1.0, [2.1, 4.0, 11.0]),
    (Layer::Selected, Shape::Arrows, 1.0, [1.1, 4.0, 9.0]),
    (Layer::Active, Shape::Arrows, 1.0, [0.5, 4.0, 5.0]),
    (Layer::Hovered, Shape::Points, 1.0, [6.5, 0.0, 0.0]),
    (Layer::Selected, Shape::Points, 1.0, [4.5, 1.0, 0.0]),
    (Layer::Active, Shape::Points, 1.0, [2.5, 0.0, 0.0]),
];

impl Renderer {
    /// The draws of a frame, in order.
    pub(super) fn list_draws(&self, frame: &Frame<'_>) -> Vec<(Draw<'_>, DrawUniform)> {
        let Frame { camera, style, pixels_per_point: ppp, .. } = *frame;
        let theme = &style.theme;
        let plain = DrawUniform::new(camera, Vec3::ZERO, [0.0; 4], [0.0; 4]);
        let mut draws = vec![(Draw::Background, plain)];
        // Behind everything: lines over a model look as if they belonged to it.
        if style.grid {
            draws.push((Draw::Ground, plain));
        }
        if let Some(ground) = self.ground(frame) {
            let color = rgba(theme.shadow, theme.shadow_strength);
            let params = [ground.half_width, 0.0, 0.0, 0.0];
            draws.push((Draw::Shadow, DrawUniform::new(camera, ground.middle, color, params)));
        }
        let visible = || {
            let shown = frame.objects.iter().filter(|o| o.visible);
            shown.filter_map(|o| Some((o, self.objects.get(&o.id)?)))
        };
        let kinds: &[Faces] = match (style.x_ray, style.cull) {
            (false, false) => &[Faces::All],
            (false, true) => &[Faces::Fronts],
            // Back sides first, as they are usually farther away.
            (true, false) => &[Faces::GlassBacks, Faces::GlassFronts, Faces::Veil],
            (true, true) => &[Faces::GlassFronts, Faces::Veil],
        };
        for kind in kinds {
            for (draw, object) in visible() {
                let has_lines = style.look == Look::HiddenLine || (style.wireframe && draw.active);
                let translucency = if style.x_ray { XRAY_TRANSLUCENCY } else { 0.0 };
                let mut push = |draw, first_texture| {
                    let lines = if has_lines { 1.0 } else { 0.0 };
                    let params = [0.6 * ppp, lines, translucency, first_texture];
                    draws.push((draw, DrawUniform::new(camera, object.buffers.origin(), [0.0; 4], params)));
                };
                let is_textured = style.wants_uvs() && object.buffers.coloring().has_uvs();
                if !is_textured || matches!(kind, Faces::Veil) {
                    push(Draw::Mesh(object, *kind), 0.0);
                    continue;
                }
                for pass in object.buffers.coloring().passes() {
                    push(Draw::Textured(object, *kind, pass), (pass * TEXTURES_PER_DRAW) as f32);
                }
            }
        }
        if !style.x_ray && style.wants_uvs() {
            self.list_translucent(frame, &mut draws);
        }
        for side in [Side::Behind, Side::InFront] {
            let alpha = match side {
                Side::Behind if style.x_ray => STRENGTH_BEHIND_FACES,
                Side::Behind => continue,
                Side::InFront => 1.0,
            };
            for (_, object) in visible() {
                let found = &object.marks;
                let uniform = |mark, [radius, rim]: [f32; 2]| {
                    let params = [radius * ppp, rim * ppp, 0.0, MARK_OFFSET_POINTS * ppp];
                    DrawUniform::new(camera, found.origin, rgba(Theme::mark(mark), alpha), params)
                };
                for (mark, lines) in Mark::ALL.into_iter().zip(&found.lines).filter(|(_, l)| l.len() > 0) {
                    let is_normal = matches!(mark, Mark::FaceNormals | Mark::VertexNormals);
                    let width = if is_normal { 0.6 } else { 1.2 };
                    draws.push((Draw::Lines(lines, side), uniform(mark, [width, 0.0])));
                }
                draws.push((Draw::Points(&found.points, side), uniform(Mark::NonManifold, [4.0, 1.0])));
            }
            for (draw, object) in visible() {
                let origin = object.buffers.origin();
                let mut push = |points, color, radius, rim| {
                    let params = [radius * ppp, rim * ppp, 0.0, MARK_OFFSET_POINTS * ppp];
                    let uniform = DrawUniform::new(camera, origin, rgba(color, alpha), params);
                    draws.push((Draw::Points(points, side), uniform));
                };
                if draw.active && style.vertices && object.has_points {
                    push(&object.points, theme.vertex, 2.5, 0.0);
                }
                // Among very many, as scans have them, large ones would hide the surface.
                let (radius, rim) = if object.isolated.count() > MAX_LARGE_ISOLATED_VERTICES {
                    (1.5, 0.0)
                } else {
                    (3.5, 1.0)
                };
                push(&object.isolated.points, theme.isolated, radius, rim);
            }
        }
        for side in [Side::Behind, Side::InFront] {
            let strength = match side {
                Side::Behind => STRENGTH_BEHIND_FACES,
                Side::InFront => 1.0,
            };
            for (layer, shape, alpha, params) in MARKS {
                let (marked, color) = match layer {
                    Layer::Selected => (&self.selected, theme.selected),
                    Layer::Active => (&self.active, theme.active),
                    Layer::Hovered => (&self.hovered, theme.hovered),
                };
                let object = visible().find(|(draw, _)| Some(draw.id) == marked.object);
                let Some((_, object)) = object.filter(|_| marked.stream(shape).len() > 0) else { continue };
                let [a, b, c] = params.map(|size| size * ppp);
                let color = rgba(color, alpha * strength);
                let uniform = DrawUniform::new(
                    camera,
                    object.buffers.origin(),
                    color,
                    [a, b, c, MARK_OFFSET_POINTS * ppp],
                );
                draws.push((Draw::Highlight(marked, shape, side), uniform));
            }
        }
        draws
    }

    /// Lists the faces of translucent materials: of each object, farther objects first, the back sides before the front ones.
    fn list_translucent<'a>(&'a self, frame: &Frame<'_>, draws: &mut Vec<(Draw<'a>, DrawUniform)>) {
        let Frame { camera, style, pixels_per_point: ppp, .. } = *frame;
        let visible = frame.objects.iter().filter(|object| object.visible);
        let mut objects: Vec<_> =
            visible.filter_map(|draw| Some((draw, self.objects.get(&draw.id)?))).collect();
        objects.sort_by(|(_, a), (_, b)| {
            let [a, b] = [a, b].map(|object| camera.depth(object.buffers.origin()));
            b.total_cmp(&a)
        });
        let kinds: &[Faces] =
            if style.cull { &[Faces::ClearFronts] } else { &[Faces::ClearBacks, Faces::ClearFronts] };
        for (draw, object) in objects.iter().filter(|(_, object)| object.buffers.coloring().has_uvs()) {
            let lines = if style.wireframe && draw.active { 1.0 } else { 0.0 };
            for kind in kinds {
                for pass in object.buffers.coloring().translucent_passes() {
                    let params = [0.6 * ppp, lines, 0.0, (pass * TEXTURES_PER_DRAW) as f32];
                    let uniform = DrawUniform::new(camera, object.buffers.origin(), [0.0; 4], params);
                    draws.push((Draw::Textured(object, *kind, pass), uniform));
                }
            }
        }
    }

    fn marks(&self, side: Side) -> &Marks {
        match side {
            Side::Behind => &self.pipelines.behind,
            Side::InFront => &self.pipelines.in_front,
        }
    }

    pub(super) fn encode_draws(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        uniforms: &wgpu::BindGroup,
        targets: &Targets,
        draws: &[(Draw<'_>, DrawUniform)],
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
        for (at, (draw, _)) in draws.iter().enumerate() {
            pass.set_bind_group(0, uniforms, &[(at * DRAW_UNIFORM_STRIDE) as u32]);
            match draw {
                Draw::Background => {
                    pass.set_pipeline(&p.background);
                    pass.draw(0..3, 0..1);
                }
                Draw::Ground => {
                    pass.set_pipeline(&p.ground);
                    pass.draw(0..6, 0..1);
                }
                Draw::Shadow => {
                    pass.set_pipeline(&p.shadow);
                    pass.set_bind_group(1, self.shadow.map(), &[]);
                    pass.draw(0..6, 0..1);
                }
                Draw::Mesh(object, faces) => {
                    pass.set_pipeline(match faces {
                        Faces::All => &p.mesh,
                        Faces::Fronts => &p.mesh_fronts,
                        Faces::GlassBacks => &p.glass_backs,
                        Faces::GlassFronts => &p.glass_fronts,
                        Faces::Veil => &p.veil,
                        Faces::ClearBacks | Faces::ClearFronts => continue,
                    });
                    pass.set_bind_group(1, &self.surface.bind_group, &[]);
                    for page in &object.pages {
                        page.draw(&mut pass, false);
                    }
                }
                Draw::Textured(object, faces, number) => {
                    let textured = self.textures.pipelines.as_ref().zip(self.textures.passes.get(*number));
                    let Some((pipelines, textures)) = textured else { continue };
                    pass.set_pipeline(match faces {
                        Faces::All | Faces::Veil => &pipelines.all,
                        Faces::Fronts => &pipelines.fronts,
                        Faces::GlassBacks => &pipelines.glass_backs,
                        Faces::GlassFronts => &pipelines.glass_fronts,
                        Faces::ClearBacks => &pipelines.clear_backs,
                        Faces::ClearFronts => &pipelines.clear_fronts,
                    });
                    pass.set_bind_group(1, textures, &[]);
                    for page in &object.pages {
                        page.draw(&mut pass, true);
                    }
                }
                Draw::Points(points, side) => {
                    instances(&mut pass, &self.marks(*side).points, points, 12, 6);
                }
                Draw::Lines(lines, side) => {
                    instances(&mut pass, &self.marks(*side).lines, lines, 24, 6);
                }
                Draw::Highlight(marked, shape, side) => {
                    let (marks, stream) = (self.marks(*side), marked.stream(*shape));
                    match shape {
                        Shape::Fill => {
                            if let Some(fill) = stream.slice() {
                                pass.set_pipeline(&marks.fill);
                                pass.set_vertex_buffer(0, fill);
                                pass.draw(0..(stream.len() / 12) as u32, 0..1);
                            }
                        }
                        Shape::Lines => instances(&mut pass, &marks.lines, stream, 24, 6),
                        Shape::Arrows => instances(&mut pass, &marks.arrows, stream, 36, 9),
                        Shape::Points => instances(&mut pass, &marks.points, stream, 12, 6),
                    }
                }
            }
        }
    }
}

/// Draws an instance of this many vertices for each entry of a stream.
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
