//! Box selection: the elements in a rectangle of the screen.

use crate::Camera;
use crate::occlusion::{Drawing, Drawn, Occlusion};
use crate::sight::Sight;
use glam::{Vec2, Vec3};
use halfedge::geometry::PolygonTriangulator;
use halfedge::{Budget, EdgeId, Element, FaceId, HalfedgeId, InParts, Mesh, VertexId};
use std::ops::Range;
use surface::FaceTree;

/// A rectangle of the viewport, edges included, in the unit of its size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScreenRect {
    /// The top left corner.
    pub min: Vec2,
    /// The bottom right corner.
    pub max: Vec2,
}

impl ScreenRect {
    /// The rectangle with these two points as opposite corners, in either order.
    pub fn between(a: Vec2, b: Vec2) -> Self {
        Self { min: a.min(b), max: a.max(b) }
    }

    fn contains(&self, p: Vec2) -> bool {
        p.cmpge(self.min).all() && p.cmple(self.max).all()
    }

    /// The part of a segment inside, as fractions of its length (Liang and Barsky 1984).
    fn clip(&self, [a, b]: [Vec2; 2]) -> Option<[f32; 2]> {
        let along = b - a;
        let (mut enter, mut leave) = (0.0_f32, 1.0_f32);
        for axis in 0..2 {
            let (start, step) = (a[axis], along[axis]);
            if step == 0.0 {
                if start < self.min[axis] || start > self.max[axis] {
                    return None;
                }
                continue;
            }
            let (t0, t1) = ((self.min[axis] - start) / step, (self.max[axis] - start) / step);
            enter = enter.max(t0.min(t1));
            leave = leave.min(t0.max(t1));
        }
        (enter <= leave).then_some([enter, leave])
    }
}

/// A mesh seen through a rectangle.
struct Through<'a> {
    sight: Sight<'a>,
    rect: ScreenRect,
    /// Whether elements have to be visible.
    visible_only: bool,
    /// Decides about most points without a ray.
    occlusion: Option<Occlusion>,
}

/// A box selection that tests some elements at a time, so that a frame stays short. The mesh must not change
/// meanwhile.
///
/// It finds vertices inside the rectangle, edges and faces with any part inside, and the half-edges of such
/// edges. With `visible_only`, hidden elements are left out: vertices behind a face; edges hidden at the
/// middle and the quarters of the part inside; faces hidden in the middle and at all corners; half-edges of
/// such faces. Costs O(mesh) in all, and rays for elements near silhouettes.
pub struct BoxSelection {
    camera: Camera,
    viewport: Vec2,
    rect: ScreenRect,
    kind: Element,
    visible_only: bool,
    stage: Stage,
}

enum Stage {
    Begun,
    /// Drawing the depth buffer.
    Drawing(Drawing),
    /// Testing the elements from this id on.
    Testing(Option<Occlusion>, usize, Vec<u32>),
}

impl BoxSelection {
    /// A selection of the elements in a rectangle of a viewport. Costs O(1).
    pub fn new(camera: &Camera, viewport: Vec2, rect: ScreenRect, kind: Element, visible_only: bool) -> Self {
        Self { camera: *camera, viewport, rect, kind, visible_only, stage: Stage::Begun }
    }

    /// The kind of elements that it finds.
    pub fn kind(&self) -> Element {
        self.kind
    }
}

/// It reads the mesh and its tree. The budget counts vertices placed, faces drawn and elements tested; the result
/// is the ids found, in ascending order.
impl InParts for BoxSelection {
    type Input<'a> = (&'a Mesh, &'a FaceTree);
    type Output = Vec<u32>;

    fn step(&mut self, (mesh, tree): (&Mesh, &FaceTree), budget: &mut Budget) -> Option<Vec<u32>> {
        let (camera, viewport) = (self.camera, self.viewport);
        let sight = || Sight::new(mesh, tree, &camera, viewport);
        // Both half-edges of an edge are tested together.
        let kind = if self.kind == Element::Halfedge { Element::Edge } else { self.kind };
        while !budget.is_spent() {
            self.stage = match std::mem::replace(&mut self.stage, Stage::Begun) {
                Stage::Begun if self.visible_only => {
                    budget.take(mesh.vertex_count());
                    Stage::Drawing(Occlusion::begin(mesh, sight().view(), self.rect))
                }
                Stage::Begun => Stage::Testing(None, 0, Vec::new()),
                Stage::Drawing(drawing) => match drawing.draw_faces(mesh, budget) {
                    Drawn::Partly(drawing) => Stage::Drawing(drawing),
                    Drawn::Whole(occlusion) => Stage::Testing(occlusion, 0, Vec::new()),
                },
                Stage::Testing(occlusion, next, mut found) => {
                    let end = next + budget.take(mesh.capacity(kind) - next);
                    let through = Through {
                        sight: sight(),
                        rect: self.rect,
                        visible_only: self.visible_only,
                        occlusion,
                    };
                    through.find(self.kind, next as u32..end as u32, &mut found);
                    if end == mesh.capacity(kind) {
                        return Some(found);
                    }
                    Stage::Testing(through.occlusion, end, found)
                }
            };
        }
        None
    }
}

impl Through<'_> {
    /// Adds those of the elements with these ids that are inside; for half-edges the ids are those of edges.
    fn find(&self, kind: Element, ids: Range<u32>, found: &mut Vec<u32>) {
        let mesh = self.sight.mesh;
        match kind {
            Element::Vertex => self.vertices(ids, found),
            Element::Edge => found.extend(self.edges(ids).map(EdgeId::raw)),
            Element::Halfedge => {
                let sees_side =
                    |h: &HalfedgeId| !self.visible_only || mesh.face_of(*h).is_none_or(|f| self.sees_face(f));
                let sides = self.edges(ids).flat_map(EdgeId::halfedges).filter(sees_side);
                found.extend(sides.map(HalfedgeId::raw));
            }
            Element::Face => self.faces(ids, found),
        }
    }

    fn vertices(&self, ids: Range<u32>, found: &mut Vec<u32>) {
        let mesh = self.sight.mesh;
        let inside = |p: Vec3| self.sight.project(p).is_some_and(|pixel| self.rect.contains(pixel));
        let seen = |v: VertexId| {
            let own = |f| mesh.face_vertices(f).any(|w| w == v);
            self.sees(mesh.position(v), || self.sight.sees(mesh.position(v), own).is_some())
        };
        let vertices = ids.filter_map(|id| mesh.vertex(id));
        found.extend(vertices.filter(|&v| inside(mesh.position(v)) && seen(v)).map(VertexId::raw));
    }

    /// Whether a point counts as visible; `by_ray` decides where the depth buffer can't.
    fn sees(&self, point: Vec3, by_ray: impl FnOnce() -> bool) -> bool {
        let told = self.occlusion.as_ref().and_then(|o| o.sees(self.sight.view(), point));
        !self.visible_only || told.unwrap_or_else(by_ray)
    }

    fn edges(&self, ids: Range<u32>) -> impl Iterator<Item = EdgeId> {
        ids.filter_map(|id| self.sight.mesh.edge(id)).filter(|&e| {
            let Some(segment) = self.sight.segment(e) else { return false };
            let Some([enter, leave]) = self.rect.clip(segment.pixels) else { return false };
            !self.visible_only
                || [0.5, 0.25, 0.75].into_iter().any(|part| {
                    let point = self.sight.point_on(&segment, enter + (leave - enter) * part);
                    self.sees(point, || self.sight.sees_edge_at(e, point).is_some())
                })
        })
    }

    fn faces(&self, ids: Range<u32>, found: &mut Vec<u32>) {
        let (sight, rect, mesh) = (&self.sight, self.rect, self.sight.mesh);
        // A face larger than the rectangle may have no edge inside.
        let middle = (rect.min + rect.max) * 0.5;
        let mut corners: Vec<Option<Vec2>> = Vec::new();
        let mut triangulator = PolygonTriangulator::new();
        let mut inside = |face: FaceId| {
            corners.clear();
            corners.extend(mesh.face_vertices(face).map(|v| sight.project(mesh.position(v))));
            if corners.iter().any(Option::is_none) {
                // Partly behind the eye: the edges in front of it decide.
                return mesh.face_halfedges(face).any(|h| {
                    sight.segment(h.edge()).is_some_and(|segment| rect.clip(segment.pixels).is_some())
                });
            }
            let corners = || corners.iter().copied().flatten();
            let low = corners().fold(Vec2::INFINITY, Vec2::min);
            let high = corners().fold(Vec2::NEG_INFINITY, Vec2::max);
            if low.cmpgt(rect.max).any() || high.cmplt(rect.min).any() {
                return false;
            }
            let next = corners().cycle().skip(1);
            corners().zip(next).any(|(a, b)| rect.clip([a, b]).is_some())
                || triangulator.triangulate_face(mesh, face).iter().any(|triangle| {
                    let [Some(a), Some(b), Some(c)] =
                        triangle.map(|h| sight.project(mesh.position(mesh.from(h))))
                    else {
                        return false;
                    };
                    let turns = [(a, b), (b, c), (c, a)].map(|(p, q)| (q - p).perp_dot(middle - p));
                    turns.iter().all(|&t| t >= 0.0) || turns.iter().all(|&t| t <= 0.0)
                })
        };
        let faces = ids.filter_map(|id| mesh.face(id));
        found.extend(
            faces.filter(|&f| inside(f) && (!self.visible_only || self.sees_face(f))).map(FaceId::raw),
        );
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
