//! Cutting polygons into triangles between their own corners.
//!
//! There is one rule. Drawing, picking, saving, simplifying, remeshing and the operation
//! `triangulate-faces` all follow it, so that they agree on the surface of a non-planar polygon.

mod clip_ears;
mod mesh;
mod optimal;
mod touching;

use crate::geometry::polygon_area_vector;
use crate::{FaceId, HalfedgeId, Mesh};
use clip_ears::EarClipper;
use glam::{DVec3, Vec3};
pub use mesh::MeshTriangulator;

/// Larger polygons aren't cut into a fan: its triangles would be thin, and the first corner would have very
/// many edges.
const MAX_FAN_CORNERS: usize = 8;
/// Larger polygons that touch or cross themselves are cut without regard to overlaps: avoiding overlaps
/// takes time quadratic in the number of corners.
const MAX_TOUCHING_CORNERS: usize = 1024;

/// Decides which corners a cut may join, by their indices. Edits use it to avoid duplicate edges.
pub(crate) trait Allowed: Fn(u32, u32) -> bool {}
impl<F: Fn(u32, u32) -> bool> Allowed for F {}

/// Cuts polygons into triangles, reusing its buffers from one polygon to the next.
///
/// A polygon of n corners always gives n - 2 triangles with the orientation of the polygon:
///
/// 1. A quad is cut from its first corner, or along the other diagonal if only that keeps both halves
///    facing the same way.
/// 2. A polygon of up to 8 corners is cut into a fan from its first corner, if every triangle of the fan
///    faces the polygon's way.
/// 3. Other polygons, including concave ones, are cut ear by ear (Meisters 1975).
/// 4. A polygon of up to 1024 corners that touches itself is cut so that nothing is covered twice. If it
///    crosses itself, as little as possible is covered twice (Klincsek 1980).
/// 5. The corners of a larger one are cut off one by one, convex ones first; the triangles may overlap.
#[derive(Clone, Debug, Default)]
pub struct PolygonTriangulator {
    triangles: Vec<[u32; 3]>,
    sides: Vec<HalfedgeId>,
    side_triangles: Vec<[HalfedgeId; 3]>,
    corners: Vec<Vec3>,
    clipper: EarClipper,
}

impl PolygonTriangulator {
    /// A triangulator with empty buffers.
    pub fn new() -> Self {
        Self::default()
    }

    /// The triangles of a face: three half-edges each, which leave the triangle's corners. Costs O(corners
    /// x concave corners) if the face doesn't touch or cross itself, else up to O(corners²), and
    /// O(corners³) for up to 128 corners.
    pub fn triangulate_face(&mut self, mesh: &Mesh, face: FaceId) -> &[[HalfedgeId; 3]] {
        self.triangulate_face_with(mesh, face, |_, _| true);
        &self.side_triangles
    }

    /// Cuts a face into `side_triangles`, with cuts only between corners that `allowed` accepts, given by the half-edges
    /// that leave them; returns whether that was possible.
    fn triangulate_face_with(
        &mut self,
        mesh: &Mesh,
        face: FaceId,
        allowed: impl Fn(HalfedgeId, HalfedgeId) -> bool,
    ) -> bool {
        self.sides.clear();
        self.sides.extend(mesh.face_halfedges(face));
        self.side_triangles.clear();
        if let &[a, b, c] = self.sides.as_slice() {
            self.side_triangles.push([a, b, c]);
            return true;
        }
        let mut corners = std::mem::take(&mut self.corners);
        corners.clear();
        corners.extend(self.sides.iter().map(|&h| mesh.position(mesh.from(h))));
        let sides = std::mem::take(&mut self.sides);
        let is_cut = self.cut(&corners, true, |i, j| allowed(sides[i as usize], sides[j as usize]));
        (self.corners, self.sides) = (corners, sides);
        for triangle in &self.triangles {
            self.side_triangles.push(triangle.map(|i| self.sides[i as usize]));
        }
        is_cut
    }

    /// The triangles of a polygon, as indices of its corners; none for fewer than three corners. Costs as
    /// much as [`PolygonTriangulator::triangulate_face`].
    pub fn triangulate(&mut self, corners: &[Vec3]) -> &[[u32; 3]] {
        self.cut(corners, true, |_, _| true);
        &self.triangles
    }

    /// The triangles of a polygon cut ear by ear, however many corners it has: neither a fan nor
    /// overlapping triangles. None if it has more than 128 corners, crosses itself and can't be cut that
    /// way. Costs as much as [`PolygonTriangulator::triangulate_face`].
    pub fn cut_ears(&mut self, corners: &[Vec3]) -> Option<&[[u32; 3]]> {
        self.triangulate_with(corners, false, |_, _| true)
    }

    /// The triangles of a polygon, in an order in which each is an ear of what the previous ones leave,
    /// with cuts only between corners that `allowed` accepts. `fans` says whether rules 1 and 2 apply;
    /// otherwise the polygon is cut ear by ear. None if that is impossible.
    pub(crate) fn triangulate_with(
        &mut self,
        corners: &[Vec3],
        fans: bool,
        allowed: impl Allowed,
    ) -> Option<&[[u32; 3]]> {
        self.cut(corners, fans, allowed).then_some(&self.triangles)
    }

    fn cut(&mut self, corners: &[Vec3], fans: bool, allowed: impl Allowed) -> bool {
        self.triangles.clear();
        if corners.len() <= 3 {
            self.triangles.extend((corners.len() == 3).then_some([0, 1, 2]));
            return true;
        }
        let normal = polygon_area_vector(corners.iter().copied());
        if fans {
            let is_cut = match *corners {
                [a, b, c, d] => self.cut_quad([a, b, c, d], normal, &allowed),
                _ => self.cut_fan(corners, normal, &allowed),
            };
            if is_cut {
                return true;
            }
        }
        if self.clipper.clip(corners, normal, &allowed, &mut self.triangles) {
            return true;
        }
        self.triangles.clear();
        // Without fans, ears are wanted whatever they cost.
        if corners.len() <= MAX_TOUCHING_CORNERS || !fans {
            if let Some(triangles) = touching::find_triangles(corners, normal, &allowed) {
                self.triangles = triangles;
                return true;
            }
            if !fans {
                return false;
            }
        }
        self.clipper.clip_somehow(corners, normal, &mut self.triangles);
        let count = corners.len() as u32;
        let is_side = |a: u32, b: u32| a.abs_diff(b) == 1 || a.abs_diff(b) == count - 1;
        let may_join = |a, b| is_side(a, b) || allowed(a, b);
        self.triangles.iter().all(|&[a, b, c]| may_join(a, b) && may_join(b, c) && may_join(c, a))
    }

    /// Cuts a quad along the better diagonal, or along the other one if only that is allowed; returns
    /// whether one was allowed.
    #[inline]
    fn cut_quad(&mut self, [a, b, c, d]: [Vec3; 4], normal: DVec3, allowed: &impl Allowed) -> bool {
        let by_first = facing([a, b, c], normal).min(facing([a, c, d], normal));
        let is_first =
            !(by_first <= 0.0 && facing([a, b, d], normal).min(facing([b, c, d], normal)) > by_first);
        let is_first = is_first && allowed(0, 2) || !allowed(1, 3);
        self.triangles.extend(if is_first { [[0, 1, 2], [0, 2, 3]] } else { [[0, 1, 3], [1, 2, 3]] });
        !is_first || allowed(0, 2)
    }

    /// Cuts a small polygon into a fan; returns whether that was correct and allowed.
    fn cut_fan(&mut self, corners: &[Vec3], normal: DVec3, allowed: &impl Allowed) -> bool {
        let count = corners.len() as u32;
        let fan = (2..count).map(|i| [0, i - 1, i]);
        let is_right = corners.len() <= MAX_FAN_CORNERS
            && fan.clone().all(|triangle| facing(triangle.map(|i| corners[i as usize]), normal) > 0.0)
            && (2..count - 1).all(|i| allowed(0, i));
        if is_right {
            self.triangles.extend(fan);
        }
        is_right
    }
}

/// How far a triangle faces along a normal; negative if it faces away.
#[inline]
fn facing(corners: [Vec3; 3], normal: DVec3) -> f64 {
    let [a, b, c] = corners.map(|p| p.as_dvec3());
    (b - a).cross(c - a).dot(normal)
}
