//! The renderer: draws objects and highlights that are uploaded when they change.

use super::frame::{Frame, FrameKey};
use super::highlight::{Highlight, HighlightBuffers, Layer};
use super::object::Object;
use super::pipelines::Pipelines;
use super::screen::{DRAW_UNIFORM_STRIDE, Screen};
use super::shadow::{Ground, MapKey, Shadow};
use super::surface::Surface;
use super::targets::Targets;
use super::textures::Textures;
use super::uniforms::FrameUniform;
use crate::{Legend, Mark, Materials, Style};
use halfedge::geometry::BitSet;
use halfedge::{Budget, InParts, Mesh, Touched};
use std::collections::HashMap;
use std::sync::Arc;

/// What changed about an object.
#[derive(Clone, Copy, Debug)]
pub enum ObjectChange<'a> {
    /// It is new, or has another mesh.
    Everything,
    /// An edit, an undo or a redo touched these elements.
    Touched(&'a Touched),
}

/// Draws objects into textures of its own, and those into a render pass.
///
/// Call [`Renderer::sync_object`] and [`Renderer::set_highlight`] when something changes; in each frame
/// call [`Renderer::prepare`] with a command encoder, then [`Renderer::paint`] in a render pass with one
/// sample, the target format and no depth. A frame equal to the one before isn't drawn again.
///
/// Several views of the same objects, each with a camera and a number of its own, share all buffers of objects: a view
/// more costs its draws, and textures of its size.
pub struct Renderer {
    pub(super) pipelines: Pipelines,
    pub(super) objects: HashMap<u64, Object>,
    /// The looks of the document's materials.
    pub(super) materials: Arc<Materials>,
    pub(super) textures: Textures,
    pub(super) selected: HighlightBuffers,
    pub(super) active: HighlightBuffers,
    pub(super) hovered: HighlightBuffers,
    pub(super) surface: Surface,
    pub(super) shadow: Shadow,
    /// What each view is drawn with; none while it is being drawn.
    screens: Vec<Option<Screen>>,
    /// Counts the changes of buffers.
    pub(super) generation: u64,
    /// Counts the changes of meshes among them.
    shapes: u64,
}

impl Renderer {
    /// A renderer for render targets of this format.
    pub fn new(device: &wgpu::Device, target: wgpu::TextureFormat) -> Self {
        let (pipelines, of_shadow) = Pipelines::new(device, target);
        let surface = Surface::new(device, &pipelines.surface);
        let shadow = Shadow::new(device, &pipelines.surface, of_shadow);
        Self {
            pipelines,
            objects: HashMap::new(),
            materials: Arc::default(),
            textures: Textures::new(device),
            selected: HighlightBuffers::new(),
            active: HighlightBuffers::new(),
            hovered: HighlightBuffers::new(),
            surface,
            shadow,
            screens: Vec::new(),
            generation: 0,
            shapes: 0,
        }
    }

    /// Uploads changes of an object's mesh; returns the number of bytes. The cost is in proportion to what
    /// was touched; an object that is new, or was uploaded for a style with other normals, other colours or
    /// without dots that are wanted now, is uploaded whole.
    pub fn sync_object(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        id: u64,
        mesh: &Mesh,
        change: ObjectChange<'_>,
        style: &Style,
    ) -> u64 {
        self.count_shape();
        let fits = self.fits_style(id, style);
        let object = self.objects.entry(id).or_insert_with(Object::new);
        match change {
            ObjectChange::Touched(touched) if fits && !touched.everything => {
                object.update(device, queue, mesh, touched)
            }
            _ => object.rebuild(device, queue, mesh, style, &self.materials),
        }
    }

    /// Begins an upload of an object's whole mesh that [`Renderer::upload_faces`] carries out over several
    /// frames. The old buffers are drawn until it is complete, and take memory beside the new ones.
    pub fn begin_object_upload(&mut self, id: u64, mesh: &Mesh, style: &Style) {
        let object = self.objects.entry(id).or_insert_with(Object::new);
        object.begin_upload(mesh, style, &self.materials);
    }

    /// Whether an upload of an object has begun and isn't complete.
    pub fn is_uploading(&self, id: u64) -> bool {
        self.objects.get(&id).is_some_and(Object::is_uploading)
    }

    /// Uploads more faces of an object whose upload has begun, from its current mesh, as many as the budget has;
    /// returns whether that was the last of it. If so, set the highlights again: the origin of positions
    /// changed.
    pub fn upload_faces(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        id: u64,
        mesh: &Mesh,
        budget: &mut Budget,
    ) -> bool {
        let object = self.objects.get_mut(&id).filter(|object| object.is_uploading());
        let done = object.is_some_and(|object| object.upload_faces(device, queue, mesh, budget));
        if done {
            self.count_shape();
        }
        done
    }

    /// Notes that an object's mesh changed.
    fn count_shape(&mut self) {
        self.generation += 1;
        self.shapes += 1;
    }

    /// Whether the object's buffers suit the style. If not, call [`Renderer::sync_object`] even if the mesh
    /// is the same.
    pub fn fits_style(&self, id: u64, style: &Style) -> bool {
        self.objects.get(&id).is_some_and(|object| object.fits(style, &self.materials))
    }

    /// Finds and uploads more of the marks that the style wants on an object, as many as the budget has elements;
    /// returns whether there are any left. Until all are found, the last ones are drawn.
    pub fn upload_marks(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        id: u64,
        mesh: &Mesh,
        style: &Style,
        budget: &mut Budget,
    ) -> bool {
        let Some(object) = self.objects.get_mut(&id).filter(|object| !object.is_uploading()) else {
            return false;
        };
        let origin = object.buffers.origin();
        let (changed, is_left) = object.marks.step((device, queue), mesh, origin, style.marks, budget);
        self.generation += u64::from(changed);
        is_left
    }

    /// The number of marks of a kind on an object.
    pub fn mark_count(&self, id: u64, mark: Mark) -> u64 {
        self.objects.get(&id).map_or(0, |object| object.marks.count(mark))
    }

    /// What the colours of an object stand for; none for colours of the mesh itself.
    pub fn legend(&self, id: u64) -> Option<Legend> {
        self.objects.get(&id)?.buffers.coloring().legend()
    }

    /// Hides these faces of an object and no others. It takes effect with the next upload; for a few faces, pass those
    /// that changed to [`Renderer::sync_object`].
    pub fn set_hidden(&mut self, id: u64, faces: &Arc<BitSet>) {
        self.objects.entry(id).or_insert_with(Object::new).set_hidden(faces);
    }

    /// Removes an object.
    pub fn remove_object(&mut self, id: u64) {
        self.count_shape();
        self.objects.remove(&id);
    }

    /// Replaces a highlight. Call it when its elements change, and after [`Renderer::sync_object`] of their
    /// object. Costs O(elements); for faces also O(face ids / 64).
    pub fn set_highlight(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        layer: Layer,
        highlight: Option<Highlight<'_>>,
    ) {
        self.begin_highlight_upload(device, layer, highlight);
        if let Some(highlight) = highlight {
            self.upload_highlight_elements(device, queue, layer, highlight.mesh, &mut Budget::unlimited());
        }
    }

    /// Begins to replace a highlight; [`Renderer::upload_highlight_elements`] uploads its elements over several
    /// frames. Otherwise like [`Renderer::set_highlight`].
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

    /// Uploads more elements of a highlight that has begun, with the same mesh, as many as the budget has;
    /// returns whether there are any left.
    pub fn upload_highlight_elements(
        &mut self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        layer: Layer,
        mesh: &Mesh,
        budget: &mut Budget,
    ) -> bool {
        let marked = self.marked(layer);
        if !marked.is_uploading() {
            return false;
        }
        let is_left = marked.step((device, queue, mesh), budget).is_none();
        self.generation += 1;
        is_left
    }

    fn marked(&mut self, layer: Layer) -> &mut HighlightBuffers {
        match layer {
            Layer::Selected => &mut self.selected,
            Layer::Active => &mut self.active,
            Layer::Hovered => &mut self.hovered,
        }
    }

    /// Bytes of GPU memory in vertex buffers of objects and in pictures.
    pub fn gpu_bytes(&self) -> u64 {
        self.objects.values().map(Object::gpu_bytes).sum::<u64>() + self.picture_bytes()
    }

    /// Frees what views are drawn with that don't exist any more: those from this number on.
    pub fn keep_views(&mut self, count: usize) {
        self.screens.truncate(count);
    }

    /// Draws the frame of a view into textures of its own, unless they show it already; returns whether it
    /// drew. Views are counted from 0.
    pub fn prepare(
        &mut self,
        view: usize,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        encoder: &mut wgpu::CommandEncoder,
        frame: &Frame<'_>,
    ) -> bool {
        let size = Targets::fit(device, frame.size);
        let wanted = FrameKey {
            size,
            pixels_per_point: frame.pixels_per_point,
            camera: *frame.camera,
            objects: frame.objects.to_vec(),
            style: *frame.style,
            generation: self.generation,
        };
        if self.screens.len() <= view {
            self.screens.resize_with(view + 1, || None);
        }
        let before = self.screens.get_mut(view).and_then(Option::take);
        let mut screen = before.unwrap_or_else(|| Screen::new(device, &self.pipelines));
        let is_new = screen.drawn.as_ref() != Some(&wanted);
        if is_new {
            screen.drawn = Some(wanted);
            self.draw(&mut screen, (device, queue, encoder), frame, size);
        }
        if let Some(place) = self.screens.get_mut(view) {
            *place = Some(screen);
        }
        is_new
    }

    fn draw(
        &mut self,
        screen: &mut Screen,
        (device, queue, encoder): (&wgpu::Device, &wgpu::Queue, &mut wgpu::CommandEncoder),
        frame: &Frame<'_>,
        size: [u32; 2],
    ) {
        if screen.targets.as_ref().is_none_or(|t| t.size != size) {
            screen.targets = Some(Targets::new(device, &self.pipelines.picture, size));
        }
        if let Some(matcap) = frame.style.look.matcap() {
            self.surface.want(device, queue, &self.pipelines.surface, matcap);
        }
        if frame.style.wants_uvs() {
            self.textures.prepare(device, queue, &self.pipelines.uniforms, &self.materials);
        }
        let uniform = FrameUniform::new(frame.camera, size, frame.pixels_per_point, frame.style);
        queue.write_buffer(&screen.frame_buffer, 0, bytemuck::bytes_of(&uniform));

        let map = self.ground(frame).map(|ground| MapKey::new(ground, frame.objects, self.shapes));
        let casts_anew = map.is_some_and(|map| self.shadow.becomes(map));
        let count = self.list_draws(frame).len() + if casts_anew { frame.objects.len() } else { 0 };
        let needed = (count * DRAW_UNIFORM_STRIDE) as u64;
        screen.reserve_draws(device, &self.pipelines, needed);
        let draws = self.list_draws(frame);
        let casts = if casts_anew { self.list_casts(frame) } else { Vec::new() };
        let mut uniforms = vec![0_u8; needed as usize];
        let all = draws.iter().map(|(_, uniform)| uniform).chain(casts.iter().map(|(_, uniform)| uniform));
        for (uniform, place) in all.zip(uniforms.chunks_mut(DRAW_UNIFORM_STRIDE)) {
            let bytes = bytemuck::bytes_of(uniform);
            if let Some(place) = place.get_mut(..bytes.len()) {
                place.copy_from_slice(bytes);
            }
        }
        queue.write_buffer(&screen.draw_buffer, 0, &uniforms);
        if casts_anew {
            self.encode_casts(encoder, &screen.bind_group, &casts, draws.len());
        }
        if let Some(targets) = &screen.targets {
            self.encode_draws(encoder, &screen.bind_group, targets, &draws);
        }
    }

    /// The ground, if a shadow on it is drawn.
    pub(super) fn ground(&self, frame: &Frame<'_>) -> Option<Ground> {
        frame.style.shadow.then(|| Ground::below(frame.camera)).flatten()
    }

    /// Draws the picture of a view in the render pass, filling its viewport.
    pub fn paint(&self, view: usize, pass: &mut wgpu::RenderPass<'_>) {
        let screen = self.screens.get(view).and_then(Option::as_ref);
        if let Some(targets) = screen.and_then(|screen| screen.targets.as_ref()) {
            pass.set_pipeline(&self.pipelines.composite);
            pass.set_bind_group(0, &targets.bind_group, &[]);
            pass.draw(0..3, 0..1);
        }
    }
}
