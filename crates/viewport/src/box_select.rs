//! Box selection: the elements in a rectangle of the screen.

use crate::Camera;
use crate::sight::Sight;
use glam::{Vec2, Vec3};
use halfedge::{EdgeId, Element, FaceId, Mesh};
use surface::{CornerTriangulator, FaceTree};

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

/// The ids of the elements in a rectangle, in order: vertices that are inside, edges and faces with
/// any part inside, and half-edges whose edge is.
///
/// With `visible_only` those are left out of which nothing can be seen where it was looked for:
/// vertices hidden by a face, edges hidden at the middle of the part inside and a quarter of the
/// part either side of it, faces hidden in the middle and at all corners, half-edges of such
/// faces. That takes up to three rays for each edge and one more than corners for each face inside;
/// else costs O(mesh).
pub fn elements_in_rect(
    mesh: &Mesh,
    tree: &FaceTree,
    camera: &Camera,
    viewport: Vec2,
    rect: ScreenRect,
    kind: Element,
    visible_only: bool,
) -> Vec<u32> {
    let sight = Sight { mesh, tree, camera, viewport };
    match kind {
        Element::Vertex => mesh
            .vertices()
            .filter(|&v| {
                let point = mesh.position(v);
                sight.project(point).is_some_and(|p| rect.contains(p))
                    && (!visible_only
                        || sight.sees(point, |f| mesh.face_vertices(f).any(|w| w == v)).is_some())
            })
            .map(|v| v.raw())
            .collect(),
        Element::Edge => edges(&sight, rect, visible_only).map(EdgeId::raw).collect(),
        Element::Halfedge => edges(&sight, rect, visible_only)
            .flat_map(EdgeId::halfedges)
            .filter(|&h| !visible_only || mesh.face_of(h).is_none_or(|f| sees_face(&sight, f)))
            .map(|h| h.raw())
            .collect(),
        Element::Face => faces(&sight, rect, visible_only),
    }
}

fn edges<'a>(
    sight: &'a Sight<'_>,
    rect: ScreenRect,
    visible_only: bool,
) -> impl Iterator<Item = EdgeId> + 'a {
    sight.mesh.edges().filter(move |&e| {
        let Some(segment) = sight.segment(e) else { return false };
        let Some([enter, leave]) = rect.clip(segment.pixels) else { return false };
        !visible_only
            || [0.5, 0.25, 0.75].into_iter().any(|part| {
                let point = sight.point_on(&segment, enter + (leave - enter) * part);
                sight.sees_edge_at(e, point).is_some()
            })
    })
}

fn faces(sight: &Sight<'_>, rect: ScreenRect, visible_only: bool) -> Vec<u32> {
    let mesh = sight.mesh;
    // Of a face larger than the rectangle, no edge may be inside.
    let middle = (rect.min + rect.max) * 0.5;
    let mut corners = Vec::new();
    let mut triangulator = CornerTriangulator::new();
    let mut inside = |face: FaceId| {
        corners.clear();
        corners.extend(mesh.face_vertices(face).map(|v| sight.project(mesh.position(v))));
        let all: Option<Vec<Vec2>> = corners.iter().copied().collect();
        let Some(corners) = all else {
            // Partly behind the eye: by the edges in front of it.
            return mesh
                .face_halfedges(face)
                .any(|h| sight.segment(h.edge()).is_some_and(|segment| rect.clip(segment.pixels).is_some()));
        };
        let low = corners.iter().copied().fold(Vec2::INFINITY, Vec2::min);
        let high = corners.iter().copied().fold(Vec2::NEG_INFINITY, Vec2::max);
        if low.cmpgt(rect.max).any() || high.cmplt(rect.min).any() {
            return false;
        }
        let next = corners.iter().cycle().skip(1);
        corners.iter().zip(next).any(|(&a, &b)| rect.clip([a, b]).is_some())
            || triangulator.of_face(mesh, face).iter().any(|triangle| {
                let [Some(a), Some(b), Some(c)] =
                    triangle.map(|h| sight.project(mesh.position(mesh.from(h))))
                else {
                    return false;
                };
                let turns = [(a, b), (b, c), (c, a)].map(|(p, q)| (q - p).perp_dot(middle - p));
                turns.iter().all(|&t| t >= 0.0) || turns.iter().all(|&t| t <= 0.0)
            })
    };
    mesh.faces().filter(|&f| inside(f) && (!visible_only || sees_face(sight, f))).map(FaceId::raw).collect()
}

/// Whether the middle of a face, or a point just inside one of its corners, is seen.
fn sees_face(sight: &Sight<'_>, face: FaceId) -> bool {
    let mesh = sight.mesh;
    let mut triangulator = CornerTriangulator::new();
    let Some(triangle) = triangulator.of_face(mesh, face).first() else { return false };
    let middle: Vec3 = triangle.iter().map(|&h| mesh.position(mesh.from(h)) / 3.0).sum();
    let sees = |point: Vec3| sight.sees(point, |f| f == face).is_some();
    sees(middle) || mesh.face_vertices(face).any(|v| sees(mesh.position(v).lerp(middle, 0.05)))
}
