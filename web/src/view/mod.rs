//! The viewport's state: the camera, the picture and the gesture in progress.

mod camera;
mod cursor;
pub(crate) mod flight;
pub(crate) mod flying;
mod gesture;
mod glide;
pub(crate) mod pane;
pub(crate) mod panes;
pub(crate) mod picture;
pub(crate) mod ring;
pub(crate) mod textures;
mod tools;
mod turning;

use editor::{Changes, Editor, Object, ObjectChange, ObjectId, SelectMode};
use egui::epaint::MarginF32;
use egui::{Id, Rect, Vec2};
use glam::Vec3;
use halfedge::geometry::BitSet;
use halfedge::{Budget, Element, FaceId, InParts};
use std::collections::{HashMap, VecDeque};
use surface::{FaceTree, FaceTreeBuilder};
use viewport::{Bounds, Camera, RegionSelection, Style};

use crate::bezier;
use cursor::Cursor;
use flight::Flight;
pub(crate) use gesture::{Gesture, Tool};
use glide::Glides;
use panes::Panes;
use picture::Picture;
use ring::RingTool;
use textures::Textures;
use turning::Turning;

/// The picking tree of a mesh with at most this many faces is built at once when it is needed.
const MAX_TREE_FACES_AT_ONCE: usize = 50_000;

/// The distance between framed things and the bars over the viewport, in points.
const BAR_GAP_POINTS: f32 = 8.0;

/// Framed things fill at least this share of the viewport, whatever the bars cover.
const MIN_FRAME_SHARE: f32 = 0.5;

/// The number of frames until the panels have their final sizes.
const FRAMES_UNTIL_PANELS_SETTLE: u8 = 3;

/// The radius that the selecting circle begins with, and its limits, in points.
const START_CIRCLE_RADIUS: f32 = 32.0;
const CIRCLE_RADIUS_LIMITS: std::ops::RangeInclusive<f32> = 3.0..=400.0;

/// A region of the screen whose elements are being looked for.
pub(crate) struct Selecting {
    pub object: ObjectId,
    pub region: RegionSelection,
    pub mode: SelectMode,
    /// The stroke that it is part of.
    pub stroke: Option<u64>,
}

/// The viewport's id on the page. The page's keys work while it has the focus.
pub(crate) fn widget_id() -> Id {
    Id::unique("viewport")
}

/// The viewport's state.
pub(crate) struct View {
    /// The camera of the current view.
    pub camera: Camera,
    pub style: Style,
    pub turning: Turning,
    pub cursor: Cursor,
    /// The moves of cameras that take a moment.
    pub glides: Glides,
    /// The flight in progress, in the current view.
    pub flight: Option<Flight>,
    pub tool: Tool,
    /// The current view's rectangle on the page, in points.
    pub rect: Rect,
    /// The viewport's rectangle, with all views.
    pub area: Rect,
    pub panes: Panes,
    /// How much of each side of the viewport lies under bars, in points.
    pub covered: MarginF32,
    pub picture: Option<Picture>,
    pub textures: Textures,
    pub gesture: Gesture,
    /// The element under the pointer, in the viewport or in a list.
    pub hovered: Option<(Element, u32)>,
    /// The element whose row or link is under the pointer in this frame.
    from_list: Option<(Element, u32)>,
    /// The pointer, camera, kind and x-ray of the last pick, so that a still pointer costs nothing.
    pub looked: Option<(egui::Pos2, Camera, Element, bool)>,
    /// The bounds of the objects, and which of them are drawn.
    bounds: HashMap<ObjectId, Option<Bounds>>,
    /// The picking trees, each built when the pointer is first over its object.
    trees: HashMap<ObjectId, FaceTree>,
    /// The faces that have changed since a tree was last asked for: an edit that follows the pointer asks for none.
    stale_faces: HashMap<ObjectId, BitSet>,
    /// The unfinished tree of a large mesh, built over several frames.
    building: Option<(ObjectId, FaceTreeBuilder)>,
    /// The regions of the screen whose elements are still being looked for, in order.
    pub regions: VecDeque<Selecting>,
    /// The number of strokes of the circle so far.
    pub strokes: u64,
    /// The radius of the selecting circle, in points.
    pub circle_radius: f32,
    /// The loop cut at the pointer.
    pub ring: RingTool,
    /// The modifiers of the last click.
    pub clicked_with: Option<egui::Modifiers>,
    /// How far from an element a click on it may be, in points: farther for fingers.
    pub pick_radius: f32,
    /// The elements that may still be processed in this frame.
    pub budget: Budget,
    /// The height of what the welcome view covers at the bottom, in points.
    pub covered_below: f32,
    /// The number of frames until everything is framed: in the first frame the viewport has no size yet,
    /// and panels get theirs in the second.
    pub frame_due: u8,
}

impl View {
    pub fn new(gpu: Option<egui_wgpu::RenderState>) -> Self {
        Self {
            camera: Camera::default(),
            style: Style::default(),
            turning: Turning::default(),
            cursor: Cursor::default(),
            glides: Glides::default(),
            flight: None,
            tool: Tool::Orbit,
            rect: Rect::NOTHING,
            area: Rect::NOTHING,
            panes: Panes::default(),
            covered: MarginF32::ZERO,
            picture: gpu.map(Picture::new),
            textures: Textures::default(),
            gesture: Gesture::None,
            hovered: None,
            from_list: None,
            looked: None,
            bounds: HashMap::new(),
            trees: HashMap::new(),
            stale_faces: HashMap::new(),
            building: None,
            regions: VecDeque::new(),
            strokes: 0,
            circle_radius: START_CIRCLE_RADIUS,
            ring: RingTool::default(),
            clicked_with: None,
            pick_radius: 0.0,
            budget: Budget::default(),
            covered_below: 0.0,
            frame_due: FRAMES_UNTIL_PANELS_SETTLE,
        }
    }

    /// Sets the element whose row or link is under the pointer.
    pub fn hover_from_list(&mut self, kind: Element, id: u32) {
        self.from_list = Some((kind, id));
    }

    /// Makes the selecting circle larger by a factor.
    pub fn scale_circle(&mut self, factor: f32) {
        let (least, most) = (CIRCLE_RADIUS_LIMITS.start(), CIRCLE_RADIUS_LIMITS.end());
        self.circle_radius = (self.circle_radius * factor).clamp(*least, *most);
    }

    /// The current view's size in points, as the camera expects it.
    pub fn size(&self) -> glam::Vec2 {
        glam::vec2(self.rect.width(), self.rect.height())
    }

    /// The part of the viewport that no bar covers, in points.
    pub fn free_area(&self) -> Rect {
        self.area - self.covered
    }

    /// The part of the current view that no bar covers.
    pub fn free_rect(&self) -> Rect {
        self.rect.intersect(self.free_area())
    }

    /// Sets how much of the viewport bars cover. Things are framed beside the bars, in the middle of the viewport.
    pub fn set_covered(&mut self, covered: MarginF32) {
        self.covered = covered;
        self.in_each(Self::frame_beside_bars);
    }

    /// Makes the current view frame things beside the bars over it.
    fn frame_beside_bars(&mut self) {
        let free = self.free_rect();
        let [left, top] = [free.left() - self.rect.left(), free.top() - self.rect.top()];
        let [right, bottom] = [self.rect.right() - free.right(), self.rect.bottom() - free.bottom()];
        let share = |covered: f32, size: f32| {
            f64::from((1.0 - 2.0 * (covered + BAR_GAP_POINTS) / size.max(1.0)).max(MIN_FRAME_SHARE))
        };
        let (across, down) = (left.max(right), top.max(bottom));
        self.camera.frame_share =
            glam::dvec2(share(across, self.rect.width()), share(down, self.rect.height()));
    }

    fn aspect(&self) -> f32 {
        self.rect.aspect_ratio()
    }

    /// The position of a scene point on the page, in points; none if the point is behind the eye.
    pub fn project(&self, point: Vec3) -> Option<egui::Pos2> {
        let at = self.camera.project(point, self.size())?;
        Some(self.rect.min + Vec2::new(at.x, at.y))
    }

    /// A place on the page, from the current view's corner.
    pub fn local(&self, at: egui::Pos2) -> glam::Vec2 {
        glam::vec2(at.x - self.rect.min.x, at.y - self.rect.min.y)
    }

    /// The change of a coordinate per point of a drag on a spin box: about that of the same drag in the
    /// viewport.
    pub fn drag_speed(&self) -> f64 {
        let speed = self.camera.units_per_pixel(self.size());
        if self.rect.is_positive() && speed.is_finite() { speed } else { 0.01 }
    }

    /// The graphics memory of the objects, in bytes.
    pub fn gpu_bytes(&self) -> u64 {
        self.picture.as_ref().map_or(0, Picture::gpu_bytes)
    }

    /// Updates the buffers, bounds and highlights to the document.
    pub fn follow(&mut self, editor: &Editor, changes: Changes) {
        if !changes.bezier.is_empty() {
            self.looked = None;
        }
        if changes.materials {
            let looks = self.textures.follow_document(&mut self.style, editor.document());
            if let Some(picture) = &self.picture {
                picture.set_materials(looks);
                picture.retain_pictures(|number| self.textures.shows(number));
            }
        }
        for (id, change) in &changes.objects {
            self.looked = None;
            self.building.take_if(|(built, _)| built == id);
            self.regions.retain(|selecting| selecting.object != *id);
            let Some(object) = editor.document().object(*id) else {
                self.bounds.remove(id);
                self.trees.remove(id);
                self.stale_faces.remove(id);
                if let Some(picture) = &mut self.picture {
                    picture.forget(*id);
                }
                continue;
            };
            let mesh = object.mesh();
            if let (ObjectChange::Touched(touched), Some(Some(bounds))) = (change, self.bounds.get_mut(id)) {
                // The bounds grow with moved vertices; they shrink when they are next computed for the
                // whole mesh.
                let moved =
                    touched.vertices.iter().filter(|v| mesh.has_vertex(**v)).map(|&v| mesh.position(v));
                *bounds = Bounds::of(moved).map_or(*bounds, |moved| bounds.union(moved));
            } else {
                self.bounds.insert(*id, surface::measure::bounding_box(mesh));
            }
            match change {
                ObjectChange::Touched(touched) => {
                    if self.trees.contains_key(id) {
                        let stale = self.stale_faces.entry(*id).or_default();
                        touched.for_each_face(mesh, |face| {
                            stale.insert(face.index());
                        });
                    }
                }
                _ => {
                    self.trees.remove(id);
                    self.stale_faces.remove(id);
                }
            }
            if let Some(picture) = &mut self.picture {
                picture.sync(object, change, &self.style);
            }
        }
        for (id, faces) in &changes.hidden {
            self.looked = None;
            let (Some(object), Some(picture)) = (editor.document().object(*id), &mut self.picture) else {
                continue;
            };
            picture.hide(object, faces, &self.style);
        }
        for id in &changes.bezier {
            // Control points lie outside the surface, and a curve has no mesh with bounds.
            let bezier = editor.document().object(*id).and_then(|object| object.bezier());
            if let Some(bounds) = bezier.and_then(|bezier| Bounds::of(bezier::control_points(bezier))) {
                self.bounds.insert(*id, Some(bounds));
            }
        }
        if !changes.objects.is_empty() || changes.document || !changes.bezier.is_empty() {
            let shown = editor.document().objects().iter().filter(|object| object.visible());
            let all = shown.filter_map(|object| self.bounds.get(&object.id()).copied().flatten());
            let scene = all.reduce(|a, b| a.union(b));
            self.change_cameras(|camera| camera.set_scene(scene));
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

    /// Continues building the tree for picking on an object; returns whether it is complete.
    pub fn build_tree_step(&mut self, object: &Object) -> bool {
        let (id, mesh) = (object.id(), object.mesh());
        if self.trees.contains_key(&id) || mesh.face_count() <= MAX_TREE_FACES_AT_ONCE {
            return true;
        }
        let building = self.building.take().filter(|(built, _)| *built == id);
        let (_, mut builder) = building.unwrap_or_else(|| (id, FaceTreeBuilder::new(mesh)));
        match builder.step(mesh, &mut self.budget) {
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

    /// The tree of an object, completed now if necessary.
    pub fn tree(&mut self, object: &Object) -> &FaceTree {
        let (id, mesh) = (object.id(), object.mesh());
        let building = self.building.take_if(|(built, _)| *built == id);
        let tree = self.trees.entry(id).or_insert_with(|| match building {
            Some((_, builder)) => builder.finish(mesh),
            None => FaceTree::new(mesh),
        });
        if let Some(stale) = self.stale_faces.remove(&id) {
            tree.update(mesh, stale.iter().map(FaceId::new));
        }
        tree.set_hidden(object.hidden());
        tree
    }

    /// Continues a region selection; returns the ids found once it is complete.
    pub fn step_region(&mut self, object: &Object, region: &mut RegionSelection) -> Option<Vec<u32>> {
        if !self.build_tree_step(object) {
            return None;
        }
        self.tree(object);
        let tree = self.trees.get(&object.id())?;
        region.step((object.mesh(), tree), &mut self.budget)
    }
}
