//! The picture: keeps the renderer's buffers up to date and draws its output on the page.

use editor::{Editor, Object, ObjectChange, ObjectId};
use egui::{PaintCallbackInfo, Ui};
use egui_wgpu::{Callback, CallbackResources, CallbackTrait, RenderState, ScreenDescriptor, wgpu};
use halfedge::geometry::BitSet;
use halfedge::{Budget, Element, FaceId, Mesh, Touched, VertexId};
use viewport::{Camera, Frame, Highlight, Layer, Legend, Mark, Materials, ObjectDraw, Renderer, Style};

use std::collections::HashSet;

use super::View;

/// With more faces than this hidden or shown, a new upload in parts is faster than changing the old one.
const MAX_FACES_HIDDEN_AT_ONCE: usize = 10_000;

/// Bytes of pictures that are uploaded in a frame.
const PICTURE_BYTES_PER_FRAME: usize = 4 << 20;

/// The renderer, stored among egui's resources so that paint callbacks can access it.
pub(crate) struct Picture {
    gpu: RenderState,
    pub selection_stale: bool,
    hovered: Option<(Element, u32)>,
    /// The objects of which the whole mesh has to be uploaded.
    due: HashSet<ObjectId>,
}

impl Picture {
    pub fn new(gpu: RenderState) -> Self {
        let renderer = Renderer::new(&gpu.device, gpu.target_format);
        gpu.renderer.write().callback_resources.insert(renderer);
        Self { gpu, selection_stale: true, hovered: None, due: HashSet::new() }
    }

    fn with<T>(&self, use_it: impl FnOnce(&mut Renderer, &wgpu::Device, &wgpu::Queue) -> T) -> Option<T> {
        let mut egui = self.gpu.renderer.write();
        let renderer = egui.callback_resources.get_mut::<Renderer>()?;
        Some(use_it(renderer, &self.gpu.device, &self.gpu.queue))
    }

    pub fn gpu_bytes(&self) -> u64 {
        self.with(|renderer, _, _| renderer.gpu_bytes()).unwrap_or_default()
    }

    /// Takes the looks of the document's materials.
    pub fn set_materials(&self, materials: Materials) {
        self.with(|renderer, _, _| renderer.set_materials(materials));
    }

    /// Takes a picture that materials show, and uploads it over several frames.
    pub fn set_picture(&self, number: u64, shown: viewport::Picture) {
        self.with(|renderer, device, _| renderer.set_picture(device, number, shown));
    }

    /// Forgets the pictures of which this doesn't hold.
    pub fn retain_pictures(&self, is_kept: impl Fn(u64) -> bool) {
        self.with(|renderer, _, _| renderer.retain_pictures(is_kept));
    }

    /// The longest side of a picture that the device allows, in pixels.
    pub fn largest_side(&self) -> u32 {
        self.gpu.device.limits().max_texture_dimension_2d
    }

    /// What the colours of an object stand for.
    pub fn legend(&self, id: ObjectId) -> Option<Legend> {
        self.with(|renderer, _, _| renderer.legend(id.0)).flatten()
    }

    /// The number of marks of a kind on an object.
    pub fn mark_count(&self, id: ObjectId, mark: Mark) -> u64 {
        self.with(|renderer, _, _| renderer.mark_count(id.0, mark)).unwrap_or_default()
    }

    pub fn forget(&mut self, id: ObjectId) {
        self.due.remove(&id);
        self.with(|renderer, _, _| renderer.remove_object(id.0));
    }

    /// Follows a change of an object's mesh. Few elements are uploaded now, the whole mesh when the picture is next drawn.
    pub fn sync(&mut self, object: &Object, change: &ObjectChange, style: &Style) {
        let (id, mesh) = (object.id(), object.mesh());
        let few = match change {
            ObjectChange::Touched(touched) if !self.due.contains(&id) => Some(touched),
            _ => None,
        };
        if few.is_none() {
            self.due.insert(id);
        }
        self.with(|renderer, device, queue| {
            renderer.set_hidden(id.0, object.hidden());
            if let Some(touched) = few {
                let change = viewport::ObjectChange::Touched(touched);
                renderer.sync_object(device, queue, id.0, mesh, change, style);
            }
        });
    }

    /// Stops or starts drawing faces that were hidden or shown: a few now, many over several frames.
    pub fn hide(&mut self, object: &Object, changed: &BitSet, style: &Style) {
        let mesh = object.mesh();
        if changed.len() > MAX_FACES_HIDDEN_AT_ONCE {
            self.sync(object, &ObjectChange::Everything, style);
            return;
        }
        let faces: Vec<FaceId> = changed.iter().map(FaceId::new).filter(|f| mesh.has_face(*f)).collect();
        // The dots of their vertices come and go with them.
        let mut vertices: Vec<VertexId> = faces.iter().flat_map(|&f| mesh.face_vertices(f)).collect();
        vertices.sort_unstable();
        vertices.dedup();
        let touched = Touched { faces, vertices, ..Touched::default() };
        self.sync(object, &ObjectChange::Touched(touched), style);
    }

    /// Uploads what else the mesh, the style or the highlights need; returns whether there is more to upload. In the middle
    /// of a jump in the history everything waits: the next step would make it void.
    fn prepare(
        &mut self,
        editor: &Editor,
        style: &Style,
        hovered: Option<(Element, u32)>,
        budget: &mut Budget,
    ) -> bool {
        if editor.jump().is_some() {
            return true;
        }
        let pictures =
            self.with(|renderer, _, queue| renderer.upload_pictures(queue, PICTURE_BYTES_PER_FRAME));
        let mut behind = pictures == Some(true);
        for object in editor.document().objects() {
            let (id, mesh) = (object.id(), object.mesh());
            let is_due = self.due.remove(&id);
            let done = self.with(|renderer, device, queue| {
                if is_due || (object.visible() && !renderer.fits_style(id.0, style)) {
                    upload(renderer, device, queue, id, mesh, style, budget);
                }
                let done = renderer.upload_faces(device, queue, id.0, mesh, budget);
                behind |= renderer.is_uploading(id.0);
                if object.visible() {
                    behind |= renderer.upload_marks(device, queue, id.0, mesh, style, budget);
                }
                done
            });
            self.selection_stale |= done == Some(true);
        }
        let active = editor.document().active();
        let highlight = |layer, kind, ids: &[u32]| {
            let highlight = active.filter(|_| !ids.is_empty());
            let highlight =
                highlight.map(|object| Highlight { object: object.id().0, mesh: object.mesh(), kind, ids });
            self.with(|renderer, device, _| renderer.begin_highlight_upload(device, layer, highlight));
        };
        if self.selection_stale {
            let selection = editor.selection();
            let ids: Vec<u32> = selection.ids().collect();
            highlight(Layer::Selected, selection.kind(), &ids);
            highlight(Layer::Active, selection.kind(), selection.latest().as_slice());
        }
        // The hovered element may have moved in the edit that made the selection's highlight stale.
        if self.selection_stale || self.hovered != hovered {
            let (kind, id) = hovered.map_or((Element::Vertex, None), |(kind, id)| (kind, Some(id)));
            highlight(Layer::Hovered, kind, id.as_slice());
        }
        if let Some(active) = active {
            for layer in [Layer::Selected, Layer::Active, Layer::Hovered] {
                self.with(|renderer, device, queue| {
                    let mesh = active.mesh();
                    behind |= renderer.upload_highlight_elements(device, queue, layer, mesh, budget);
                });
            }
        }
        self.selection_stale = false;
        self.hovered = hovered;
        behind
    }
}

/// Uploads a whole mesh: now if the frame's budget allows it, else over several frames.
fn upload(
    renderer: &mut Renderer,
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    id: ObjectId,
    mesh: &Mesh,
    style: &Style,
    budget: &mut Budget,
) {
    if mesh.face_count() > budget.left() {
        renderer.begin_object_upload(id.0, mesh, style);
    } else {
        budget.take(mesh.face_count());
        renderer.sync_object(device, queue, id.0, mesh, viewport::ObjectChange::Everything, style);
    }
}

/// One frame of the viewport, drawn when egui paints.
struct Drawing {
    /// The number of the view among those shown.
    view: usize,
    size: [u32; 2],
    pixels_per_point: f32,
    camera: Camera,
    style: Style,
    objects: Vec<ObjectDraw>,
}

impl CallbackTrait for Drawing {
    fn prepare(
        &self,
        device: &wgpu::Device,
        queue: &wgpu::Queue,
        _screen: &ScreenDescriptor,
        encoder: &mut wgpu::CommandEncoder,
        resources: &mut CallbackResources,
    ) -> Vec<wgpu::CommandBuffer> {
        if let Some(renderer) = resources.get_mut::<Renderer>() {
            let frame = Frame {
                size: self.size,
                pixels_per_point: self.pixels_per_point,
                camera: &self.camera,
                objects: &self.objects,
                style: &self.style,
            };
            renderer.prepare(self.view, device, queue, encoder, &frame);
        }
        Vec::new()
    }

    fn paint(
        &self,
        _info: PaintCallbackInfo,
        pass: &mut wgpu::RenderPass<'static>,
        resources: &CallbackResources,
    ) {
        if let Some(renderer) = resources.get::<Renderer>() {
            renderer.paint(self.view, pass);
        }
    }
}

/// Draws the picture of the document.
pub(crate) fn paint(ui: &Ui, editor: &Editor, view: &mut View) {
    let from_list = view.from_list.take();
    if from_list.is_some() {
        view.hovered = from_list;
    }
    let panes = view.panes();
    let Some(picture) = &mut view.picture else {
        ui.painter().rect_filled(view.area, 0.0, ui.visuals().extreme_bg_color);
        return;
    };
    let document = editor.document();
    picture.with(|renderer, _, _| renderer.keep_views(panes.len()));
    if picture.prepare(editor, &view.style, view.hovered, &mut view.budget) {
        ui.ctx().request_repaint();
    }
    let pixels_per_point = ui.pixels_per_point();
    let pixels = |points: f32| (points * pixels_per_point).round().max(1.0) as u32;
    let active = document.active().map(editor::Object::id);
    let draw = |object: &Object| ObjectDraw {
        id: object.id().0,
        visible: object.visible(),
        active: Some(object.id()) == active,
    };
    let objects: Vec<ObjectDraw> = document.objects().iter().map(draw).collect();
    // The gaps between views.
    ui.painter().rect_filled(view.area, 0.0, ui.visuals().window_stroke.color);
    for (at, pane) in panes.into_iter().enumerate() {
        let (camera, rect) = view.seen_in(pane);
        let drawing = Drawing {
            view: at,
            size: [pixels(rect.width()), pixels(rect.height())],
            pixels_per_point,
            camera: *camera,
            style: view.style,
            objects: objects.clone(),
        };
        ui.painter().add(Callback::new_paint_callback(rect, drawing));
    }
}
