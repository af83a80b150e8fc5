//! Region selection: the elements in a box, a lasso or under a brush.

use crate::Camera;
use crate::occlusion::{Drawing, Occlusion};
use crate::region::{Region, ScreenRect};
use crate::sight::Sight;
use glam::{Vec2, Vec3};
use halfedge::geometry::{BitSet, PolygonTriangulator};
use halfedge::{Budget, EdgeId, Element, FaceId, HalfedgeId, InParts, Mesh, NONE, VertexId};
use std::cell::Cell;
use surface::selecting::is_hidden;
use surface::{FaceTree, FaceWalk};

/// Isolated vertices are looked for among so many vertices at the cost of one element.
const VERTICES_SEARCHED_PER_ELEMENT: usize = 16;

/// A ray costs as much as testing so many elements, where folds hide each other.
const ELEMENTS_PER_RAY: usize = 48;
/// Faces whose elements are tested before the rays are counted.
const FACES_PER_COUNT: usize = 128;

/// A mesh seen through a region.
struct Through<'a> {
    sight: Sight<'a>,
    region: &'a Region,
    /// Whether elements have to be visible.
    visible_only: bool,
    /// Decides about most points without a ray.
    occlusion: Option<&'a Occlusion>,
    /// The number of rays so far.
    rays: Cell<usize>,
}

/// A region selection that tests some elements at a time, so that a frame stays short. The mesh must not change
/// meanwhile.
///
/// It finds vertices inside the region, edges and faces with any part inside, and the half-edges of such
/// edges. With `visible_only`, hidden elements are left out: vertices behind a face; edges hidden at the
/// middle and the quarters of each part inside; faces hidden in the middle and at all corners; half-edges of
/// such faces. The tree limits the work to what is near the region: costs O(elements there + vertices / 16), and rays
/// for elements near silhouettes.
pub struct RegionSelection {
    camera: Camera,
    viewport: Vec2,
    region: Region,
    kind: Element,
    visible_only: bool,
    stage: Stage,
    /// The faces whose box reaches into the region.
    faces: Vec<FaceId>,
    /// The elements tested.
    tested: BitSet,
    found: BitSet,
}

enum Stage {
    Begun,
    /// Looking for faces, and drawing those into a depth buffer.
    Collecting(FaceWalk, Option<Drawing>),
    /// Testing the elements of the faces from this one on.
    Testing(Option<Occlusion>, usize),
    /// Testing isolated vertices from this one on.
    Isolated(Option<Occlusion>, usize),
}

impl RegionSelection {
    /// A selection of the elements in a region of a viewport. Costs O(1).
    pub fn new(camera: &Camera, viewport: Vec2, region: Region, kind: Element, visible_only: bool) -> Self {
        Self {
            camera: *camera,
            viewport,
            region,
            kind,
            visible_only,
            stage: Stage::Begun,
            faces: Vec::new(),
            tested: BitSet::new(),
            found: BitSet::new(),
        }
    }

    /// The kind of elements that it finds.
    pub fn kind(&self) -> Element {
        self.kind
    }
}

/// It reads the mesh and its tree. The budget counts faces found, elements tested and, many times over, rays; the result is the ids found, in
/// ascending order.
impl InParts for RegionSelection {
    type Input<'a> = (&'a Mesh, &'a FaceTree);
    type Output = Vec<u32>;

    fn step(&mut self, (mesh, tree): (&Mesh, &FaceTree), budget: &mut Budget) -> Option<Vec<u32>> {
        let (camera, viewport) = (self.camera, self.viewport);
        let sight = || Sight::new(mesh, tree, &camera, viewport);
        while !budget.is_spent() {
            self.stage = match std::mem::replace(&mut self.stage, Stage::Begun) {
                Stage::Begun => {
                    let drawing = self.visible_only.then(|| Drawing::new(self.region.bounds()));
                    Stage::Collecting(tree.walk(), drawing)
                }
                Stage::Collecting(mut walk, mut drawing) => {
                    let (sight, faces) = (sight(), &mut self.faces);
                    let area = self.region.bounds().expand(Drawing::MARGIN_PX);
                    let before = faces.len();
                    let is_left = walk.step(
                        tree,
                        mesh,
                        budget,
                        |bounds| sight.may_overlap(bounds, &area),
                        |face| faces.push(face),
                    );
                    let new = faces.get(before..).unwrap_or_default();
                    drawing = drawing.and_then(|drawing| drawing.draw_faces(mesh, sight.view(), new));
                    if is_left {
                        Stage::Collecting(walk, drawing)
                    } else {
                        Stage::Testing(drawing.map(Drawing::finish), 0)
                    }
                }
                Stage::Testing(occlusion, next) => {
                    let end = next + budget.take((self.faces.len() - next).min(FACES_PER_COUNT));
                    let rays = self.test(&sight(), occlusion.as_ref(), next..end);
                    budget.take(rays * ELEMENTS_PER_RAY);
                    match end == self.faces.len() {
                        false => Stage::Testing(occlusion, end),
                        true if self.kind == Element::Vertex => Stage::Isolated(occlusion, 0),
                        true => return Some(self.take_found()),
                    }
                }
                Stage::Isolated(occlusion, next) => {
                    let first = &mesh.connectivity().vertex_halfedge;
                    let wanted = (first.len() - next).div_ceil(VERTICES_SEARCHED_PER_ELEMENT);
                    let end = next + budget.take(wanted) * VERTICES_SEARCHED_PER_ELEMENT;
                    let ids = (next..end.min(first.len())).filter(|&v| first.get(v) == Some(&NONE));
                    let alone = ids.filter_map(|v| mesh.vertex(v as u32));
                    let sight = sight();
                    let through = self.through(&sight, occlusion.as_ref());
                    let found: Vec<VertexId> = alone.filter(|&v| through.has_vertex(v)).collect();
                    for v in found {
                        self.found.insert(v.index());
                    }
                    if end >= first.len() {
                        return Some(self.take_found());
                    }
                    Stage::Isolated(occlusion, end)
                }
            };
        }
        None
    }
}

impl RegionSelection {
    fn through<'a>(&'a self, sight: &'a Sight<'a>, occlusion: Option<&'a Occlusion>) -> Through<'a> {
        Through {
            sight: *sight,
            region: &self.region,
            visible_only: self.visible_only,
            occlusion,
            rays: Cell::new(0),
        }
    }

    /// Tests the elements of some faces that haven't been tested yet; returns the number of rays that it took.
    fn test(
        &mut self,
        sight: &Sight<'_>,
        occlusion: Option<&Occlusion>,
        faces: std::ops::Range<usize>,
    ) -> usize {
        let mesh = sight.mesh;
        let (mut tested, mut found) = (std::mem::take(&mut self.tested), std::mem::take(&mut self.found));
        let through = self.through(sight, occlusion);
        for &face in self.faces.get(faces).unwrap_or_default() {
            match self.kind {
                Element::Vertex => {
                    for v in mesh.face_vertices(face) {
                        if tested.insert(v.index()) && through.has_vertex(v) {
                            found.insert(v.index());
                        }
                    }
                }
                Element::Edge | Element::Halfedge => {
                    for h in mesh.face_halfedges(face) {
                        let edge = h.edge();
                        if !tested.insert(edge.index()) || !through.has_edge(edge) {
                            continue;
                        }
                        if self.kind == Element::Edge {
                            found.insert(edge.index());
                        } else {
                            for h in edge.halfedges().into_iter().filter(|&h| through.sees_side(h)) {
                                found.insert(h.index());
                            }
                        }
                    }
                }
                Element::Face => {
                    if through.has_face(face) {
                        found.insert(face.index());
                    }
                }
            }
        }
        let rays = through.rays.get();
        (self.tested, self.found) = (tested, found);
        rays
    }

    fn take_found(&mut self) -> Vec<u32> {
        std::mem::take(&mut self.found).iter().map(|id| id as u32).collect()
    }
}

impl Through<'_> {
    fn has_vertex(&self, v: VertexId) -> bool {
        let mesh = self.sight.mesh;
        let position = mesh.position(v);
        let own = |f| mesh.face_vertices(f).any(|w| w == v);
        self.sight.project(position).is_some_and(|pixel| self.region.contains(pixel))
            && self.sees(position, || self.sight.sees(position, own).is_some())
    }

    /// Whether a point counts as visible; `by_ray` decides where the depth buffer can't.
    fn sees(&self, point: Vec3, by_ray: impl FnOnce() -> bool) -> bool {
        let count_and_cast = || {
            self.rays.set(self.rays.get() + 1);
            by_ray()
        };
        !self.visible_only
            || self.occlusion.and_then(|o| o.sees(self.sight.view(), point)).unwrap_or_else(count_and_cast)
    }

    fn has_edge(&self, edge: EdgeId) -> bool {
        let Some(segment) = self.sight.segment(edge) else { return false };
        let parts = self.region.clip(segment.pixels);
        if !self.visible_only {
            return !parts.is_empty();
        }
        parts.into_iter().any(|[enter, leave]| {
            [0.5, 0.25, 0.75].into_iter().any(|part| {
                let point = self.sight.point_on(&segment, enter + (leave - enter) * part);
                self.sees(point, || self.sight.sees_edge_at(edge, point, |_| false).is_some())
            })
        })
    }

    /// Whether the face of a half-edge whose edge was found, if it has one, is shown and visible.
    fn sees_side(&self, h: HalfedgeId) -> bool {
        if is_hidden(self.sight.mesh, Element::Halfedge, h.index(), self.sight.tree.hidden()) {
            return false;
        }
        !self.visible_only || self.sight.mesh.face_of(h).is_none_or(|f| self.sees_face(f))
    }

    fn has_face(&self, face: FaceId) -> bool {
        self.is_inside(face) && (!self.visible_only || self.sees_face(face))
    }

    /// Whether any part of a face is inside.
    fn is_inside(&self, face: FaceId) -> bool {
        let (sight, region, mesh) = (&self.sight, self.region, self.sight.mesh);
        let place = |v: VertexId| sight.project(mesh.position(v));
        if mesh.face_vertices(face).any(|v| place(v).is_none()) {
            // Partly behind the eye: the edges in front of it decide.
            return mesh.face_halfedges(face).any(|h| {
                sight.segment(h.edge()).is_some_and(|segment| !region.clip(segment.pixels).is_empty())
            });
        }
        let corners = || mesh.face_vertices(face).filter_map(place);
        if !ScreenRect::around(corners()).overlaps(&region.bounds()) {
            return false;
        }
        let next = corners().skip(1).chain(corners().take(1));
        // A face larger than the region may have no edge inside.
        corners().zip(next).any(|(a, b)| !region.clip([a, b]).is_empty())
            || self.covers(face, region.anchor())
    }

    /// Whether a face is drawn at a pixel, unless others hide it.
    fn covers(&self, face: FaceId, pixel: Vec2) -> bool {
        let mesh = self.sight.mesh;
        PolygonTriangulator::new().triangulate_face(mesh, face).iter().any(|triangle| {
            let [Some(a), Some(b), Some(c)] =
                triangle.map(|h| self.sight.project(mesh.position(mesh.from(h))))
            else {
                return false;
            };
            let turns = [(a, b), (b, c), (c, a)].map(|(p, q)| (q - p).perp_dot(pixel - p));
            turns.iter().all(|&t| t >= 0.0) || turns.iter().all(|&t| t <= 0.0)
        })
    }

    /// Whether the middle of a face, or a point just inside one of its corners, is visible.
    fn sees_face(&self, face: FaceId) -> bool {
        let mesh = self.sight.mesh;
        let mut triangulator = PolygonTriangulator::new();
        let Some(triangle) = triangulator.triangulate_face(mesh, face).first() else { return false };
        let middle: Vec3 = triangle.iter().map(|&h| mesh.position(mesh.from(h)) / 3.0).sum();
        let by_ray = |point: Vec3| self.sight.sees(point, |f| f == face).is_some();
        let sees = |point: Vec3| self.sees(point, || by_ray(point));
        sees(middle) || mesh.face_vertices(face).any(|v| sees(mesh.position(v).lerp(middle, 0.05)))
    }
}
