//! The viewport's state: the camera, the picture, and what the pointer is doing.

mod gesture;
pub(crate) mod picture;

use editor::{Changes, Editor, Object, ObjectChange, ObjectId};
use egui::{Rect, Vec2};
use glam::Vec3;
use halfedge::{Element, FaceId, Mesh, Touched};
use std::collections::HashMap;
use surface::{FaceTree, FaceTreeBuilder};
use viewport::{Bounds, BoxSelection, Camera, Style};

use crate::bezier;
pub(crate) use gesture::{Gesture, Tool};
use picture::Picture;

/// Faces that are uploaded, or sorted into a picking tree, per frame: larger meshes are split over
/// several frames to keep each short.
pub(crate) const FACES_PER_FRAME: usize = 150_000;

/// How many frames the panels take to find their sizes.
const FRAMES_UNTIL_PANELS_SETTLE: u8 = 3;

/// The viewport's state.
pub(crate) struct View {
    pub camera: Camera,
    pub style: Style,
    pub tool: Tool,
    pub rect: Rect,
    pub picture: Option<Picture>,
    pub gesture: Gesture,
    /// Under the pointer, in the viewport or in a list.
    pub hovered: Option<(Element, u32)>,
    /// What a list or a link says is under the pointer this frame.
    from_list: Option<(Element, u32)>,
    /// Where the pointer was and what was seen there, so that a still pointer costs nothing.
    pub looked: Option<(egui::Pos2, Camera, Element)>,
    /// Boxes around the objects, and which of them are drawn.
    bounds: HashMap<ObjectId, Option<Bounds>>,
    /// Made when somebody first points at the object.
    trees: HashMap<ObjectId, FaceTree>,
    /// The tree of a large mesh, made some faces a frame.
    building: Option<(ObjectId, FaceTreeBuilder)>,
    /// What a box selects, found some elements a frame; and whether it extends what is selected.
    pub boxed: Option<(ObjectId, BoxSelection, bool)>,
    /// In how many frames to come everything is looked at: in the first the viewport has no size yet,
    /// and panels find theirs in the second.
    pub frame_due: u8,
}

impl View {
    pub fn new(gpu: Option<egui_wgpu::RenderState>) -> Self {
        Self {
            camera: Camera::default(),
            style: Style::default(),
            tool: Tool::Orbit,
            rect: Rect::NOTHING,
            picture: gpu.map(Picture::new),
            gesture: Gesture::None,
            hovered: None,
            from_list: None,
            looked: None,
            bounds: HashMap::new(),
            trees: HashMap::new(),
            building: None,
            boxed: None,
            frame_due: FRAMES_UNTIL_PANELS_SETTLE,
        }
    }

    /// Where the viewport is on the page, in points.
    pub fn rect(&self) -> Rect {
        self.rect
    }

    /// The element under the pointer.
    pub fn hovered(&self) -> Option<(Element, u32)> {
        self.hovered
    }

    /// Says which element a list or a link has under the pointer.
    pub fn hover_from_list(&mut self, element: Option<(Element, u32)>) {
        if element.is_some() {
            self.from_list = element;
        }
    }

    /// The viewport's size in points, as the camera takes it.
    pub fn size(&self) -> glam::Vec2 {
        glam::vec2(self.rect.width(), self.rect.height())
    }

    fn aspect(&self) -> f32 {
        self.rect.aspect_ratio()
    }

    /// Where a point of the scene is on the page, in points; none behind the eye.
    pub fn project(&self, point: Vec3) -> Option<egui::Pos2> {
        let at = self.camera.project(point, self.size())?;
        Some(self.rect.min + Vec2::new(at.x, at.y))
    }

    /// How much a spin box changes a coordinate for each point of a drag: about as much as the same
    /// drag in the viewport would.
    pub fn drag_speed(&self) -> f64 {
        let speed = self.camera.units_per_pixel(self.size());
        if self.rect.is_positive() && speed.is_finite() { speed } else { 0.01 }
    }

    /// Bytes of graphics memory that the objects take.
    pub fn gpu_bytes(&self) -> u64 {
        self.picture.as_ref().map_or(0, Picture::gpu_bytes)
    }

    /// Makes the buffers, the boxes and the highlights follow the document.
    pub fn follow(&mut self, editor: &Editor, changes: Changes) {
        if !changes.bezier.is_empty() {
            self.looked = None;
        }
        for (id, change) in &changes.objects {
            self.looked = None;
            self.building.take_if(|(built, _)| built == id);
            self.boxed.take_if(|(boxed, ..)| boxed == id);
            let Some(object) = editor.document().object(*id) else {
                self.bounds.remove(id);
                self.trees.remove(id);
                if let Some(picture) = &mut self.picture {
                    picture.forget(*id);
                }
                continue;
            };
            let mesh = object.mesh();
            if let (ObjectChange::Touched(touched), Some(Some(bounds))) = (change, self.bounds.get_mut(id)) {
                // Grows with what moved; it shrinks when the mesh is next taken in whole.
                let moved =
                    touched.vertices.iter().filter(|v| mesh.has_vertex(**v)).map(|&v| mesh.position(v));
                *bounds = Bounds::of(moved).map_or(*bounds, |moved| bounds.union(moved));
            } else {
                self.bounds.insert(*id, surface::measure::bounding_box(mesh));
            }
            match change {
                ObjectChange::Touched(touched) => {
                    if let Some(tree) = self.trees.get_mut(id) {
                        tree.update(mesh, touched_faces(mesh, touched));
                    }
                }
                _ => {
                    self.trees.remove(id);
                }
            }
            if let Some(picture) = &mut self.picture {
                picture.sync(*id, mesh, change, &self.style);
            }
        }
        for id in &changes.bezier {
            // Control points lie outside the surface, and a curve has no mesh to bound it.
            let bezier = editor.document().object(*id).and_then(|object| object.bezier());
            if let Some(bounds) = bezier.and_then(|bezier| Bounds::of(bezier::control_points(bezier))) {
                self.bounds.insert(*id, Some(bounds));
            }
        }
        if !changes.objects.is_empty() || changes.document || !changes.bezier.is_empty() {
            let shown = editor.document().objects().iter().filter(|object| object.visible());
            let all = shown.filter_map(|object| self.bounds.get(&object.id()).copied().flatten());
            self.camera.set_scene(all.reduce(|a, b| a.union(b)));
        }
        if let Some(picture) = &mut self.picture
            && (changes.selection || changes.document || !changes.objects.is_empty())
        {
            picture.selection_stale = true;
        }
        if let Some((kind, id)) = self.hovered
            && editor.mesh().is_none_or(|mesh| !mesh.exists(kind, id))
        {
            self.hovered = None;
        }
    }

    /// Makes some of the tree that picking on an object needs; returns whether it is whole.
    pub fn build_tree_step(&mut self, object: &Object) -> bool {
        let (id, mesh) = (object.id(), object.mesh());
        if self.trees.contains_key(&id) || mesh.face_count() <= FACES_PER_FRAME {
            return true;
        }
        let building = self.building.take().filter(|(built, _)| *built == id);
        let (_, mut builder) = building.unwrap_or_else(|| (id, FaceTreeBuilder::new(mesh)));
        match builder.step(mesh, FACES_PER_FRAME) {
            Some(tree) => {
                self.trees.insert(id, tree);
                true
            }
            None => {
                self.building = Some((id, builder));
                false
            }
        }
    }

    /// The tree of an object, made or made whole now if need be.
    pub fn tree(&mut self, object: &Object) -> &FaceTree {
        let (id, mesh) = (object.id(), object.mesh());
        let building = self.building.take_if(|(built, _)| *built == id);
        self.trees.entry(id).or_insert_with(|| match building {
            Some((_, builder)) => builder.finish(mesh),
            None => FaceTree::new(mesh),
        })
    }

    /// Looks at everything once the viewport has a size.
    pub fn frame_when_seen(&mut self) {
        self.frame_due = FRAMES_UNTIL_PANELS_SETTLE;
    }

    /// Looks at everything from the same direction.
    pub fn frame_all(&mut self) {
        match self.camera.scene() {
            Some(scene) if self.rect.is_positive() => self.camera.frame(scene, self.aspect()),
            _ => self.frame_due = FRAMES_UNTIL_PANELS_SETTLE,
        }
    }

    /// Looks at the selection, or at everything.
    pub fn frame_selection(&mut self, editor: &Editor) {
        let selection = editor.selection();
        let Some(mesh) = editor.mesh().filter(|_| !selection.is_empty()) else { return self.frame_all() };
        let points = selection.ids().flat_map(|id| corners(mesh, selection.kind(), id));
        if let Some(bounds) = Bounds::of(points) {
            self.camera.frame(bounds, self.aspect());
        }
    }

    /// Back to the first view.
    pub fn reset(&mut self) {
        self.camera.orthographic = false;
        self.camera.reset(self.aspect());
    }
}

/// The faces that an edit made, removed, or moved a corner of.
fn touched_faces(mesh: &Mesh, touched: &Touched) -> Vec<FaceId> {
    let mut faces = touched.faces.clone();
    for &v in touched.vertices.iter().filter(|v| mesh.has_vertex(**v)) {
        faces.extend(mesh.vertex_faces(v));
    }
    for &h in touched.halfedges.iter().filter(|h| mesh.has_halfedge(**h)) {
        faces.extend(mesh.face_of(h));
    }
    faces.sort_unstable();
    faces.dedup();
    faces
}

/// The positions that an element spans.
fn corners(mesh: &Mesh, kind: Element, id: u32) -> Vec<Vec3> {
    match kind {
        Element::Vertex => mesh.vertex(id).map(|v| vec![mesh.position(v)]).unwrap_or_default(),
        Element::Edge => {
            mesh.edge(id).map(|e| mesh.ends(e).map(|v| mesh.position(v)).to_vec()).unwrap_or_default()
        }
        Element::Halfedge => mesh
            .halfedge(id)
            .map(|h| [mesh.from(h), mesh.to(h)].map(|v| mesh.position(v)).to_vec())
            .unwrap_or_default(),
        Element::Face => mesh
            .face(id)
            .map(|f| mesh.face_vertices(f).map(|v| mesh.position(v)).collect())
            .unwrap_or_default(),
    }
}
