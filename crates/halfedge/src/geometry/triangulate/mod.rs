//! The triangles of a polygon, for drawing and picking; the mesh is left as it is.

use crate::normals::face_area_vector;
use glam::{DVec2, DVec3, Vec3};
use halfedge::edit::polygon_ears;
use halfedge::{FaceId, HalfedgeId, Mesh};

/// The most corners that a fan is made of: it shows polygons that are not flat as other programs do, and of
/// many corners its triangles are thin.
const FAN: usize = 8;
/// The most corners for which [`polygon_ears`], which can take the square of their number, is asked.
const WEIGHED: usize = 1024;

/// Cuts polygons into triangles by their corners, keeping its buffers from one to the next.
///
/// A polygon of n corners always gives n - 2 triangles, oriented as it is. A quad is cut from its first
/// corner, or along the other diagonal where only that keeps both halves facing the same way. Larger ones are
/// a fan from their first corner where that is right and they have no more than 8, else they are projected
/// along their normal and cut by ear clipping (Meisters 1975), which is right on concave ones; where that is
/// stuck, as it can be on a polygon that touches itself, by [`polygon_ears`]. A large polygon that crosses
/// itself gets triangles that cover it somehow.
#[derive(Clone, Debug, Default)]
pub struct CornerTriangulator {
    triangles: Vec<[u32; 3]>,
    sides: Vec<HalfedgeId>,
    side_triangles: Vec<[HalfedgeId; 3]>,
    corners: Vec<Vec3>,
    flat: Vec<DVec2>,
    next: Vec<u32>,
    prev: Vec<u32>,
    /// Corners that may lie inside an ear: those with an angle of 180 degrees or more.
    reflex: Vec<u32>,
    is_reflex: Vec<bool>,
}

impl CornerTriangulator {
    /// A triangulator with empty buffers.
    pub fn new() -> Self {
        Self::default()
    }

    /// The triangles of a face: three half-edges each, which leave the triangle's corners. Costs
    /// O(corners x concave corners), and where ears alone are stuck what [`polygon_ears`] does.
    pub fn of_face(&mut self, mesh: &Mesh, face: FaceId) -> &[[HalfedgeId; 3]] {
        self.sides.clear();
        self.sides.extend(mesh.face_halfedges(face));
        self.side_triangles.clear();
        if let &[a, b, c] = self.sides.as_slice() {
            self.side_triangles.push([a, b, c]);
            return &self.side_triangles;
        }
        let mut corners = std::mem::take(&mut self.corners);
        corners.clear();
        corners.extend(self.sides.iter().map(|&h| mesh.position(mesh.from(h))));
        self.triangulate(&corners, || face_area_vector(mesh, face));
        self.corners = corners;
        for triangle in &self.triangles {
            self.side_triangles.push(triangle.map(|i| self.sides[i as usize]));
        }
        &self.side_triangles
    }

    /// The triangles of a polygon, as positions in `corners`, at the same cost.
    pub fn of_polygon(&mut self, corners: &[Vec3]) -> &[[u32; 3]] {
        self.triangulate(corners, || {
            let Some((&base, rest)) = corners.split_first() else { return DVec3::ZERO };
            let base = base.as_dvec3();
            rest.windows(2).map(|p| (p[0].as_dvec3() - base).cross(p[1].as_dvec3() - base)).sum()
        });
        &self.triangles
    }

    fn triangulate(&mut self, corners: &[Vec3], normal: impl FnOnce() -> DVec3) {
        self.triangles.clear();
        match corners {
            [] | [_] | [_, _] => {}
            [_, _, _] => self.triangles.push([0, 1, 2]),
            &[a, b, c, d] => self.triangles.extend(quad([a, b, c, d], normal())),
            _ => {
                let normal = normal();
                let fan = (2..corners.len() as u32).map(|i| [0, i - 1, i]);
                if corners.len() <= FAN
                    && fan.clone().all(|ear| facing(ear.map(|i| corners[i as usize]), normal) > 0.0)
                {
                    self.triangles.extend(fan);
                    return;
                }
                if self.clip_ears(corners, normal, true) {
                    return;
                }
                let ears = if corners.len() <= WEIGHED { polygon_ears(corners) } else { None };
                self.triangles.clear();
                match ears {
                    Some(ears) => self.triangles.extend(ears.iter().map(|ear| ear.map(|i| i as u32))),
                    None => _ = self.clip_ears(corners, normal, false),
                }
            }
        }
    }

    /// Cuts ears; whether they cover the polygon. A strict ear touches no other corner. Where there are none,
    /// one is cut that touches some, else any convex corner, else any.
    fn clip_ears(&mut self, corners: &[Vec3], normal: DVec3, strict: bool) -> bool {
        let count = corners.len() as u32;
        self.flat.clear();
        // Along the axis nearest to the normal, so that the projection keeps turning directions.
        let size = normal.abs();
        let axis = if size.x >= size.y && size.x >= size.z {
            0
        } else if size.y >= size.z {
            1
        } else {
            2
        };
        let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
        let (u, v) = if normal[axis] < 0.0 { (v, u) } else { (u, v) };
        self.flat.extend(corners.iter().map(|p| DVec2::new(f64::from(p[u]), f64::from(p[v]))));
        self.next.clear();
        self.next.extend((0..count).map(|i| if i + 1 == count { 0 } else { i + 1 }));
        self.prev.clear();
        self.prev.extend((0..count).map(|i| if i == 0 { count - 1 } else { i - 1 }));
        self.is_reflex.clear();
        self.is_reflex.resize(corners.len(), false);
        self.reflex.clear();
        for i in 0..count {
            if self.turn(i) <= 0.0 {
                self.is_reflex[i as usize] = true;
                self.reflex.push(i);
            }
        }
        let mut left = count;
        let mut at = 0;
        let mut refused = 0;
        while left > 3 {
            let ear = self.turn(at) > 0.0 && (refused >= left && !strict || self.is_empty_ear(at, strict));
            if !ear && refused < 2 * left {
                at = self.next[at as usize];
                refused += 1;
                if strict && refused >= left {
                    return false;
                }
                continue;
            }
            refused = 0;
            let (before, after) = (self.prev[at as usize], self.next[at as usize]);
            self.triangles.push([before, at, after]);
            self.next[before as usize] = after;
            self.prev[after as usize] = before;
            self.is_reflex[at as usize] = false;
            left -= 1;
            for corner in [before, after] {
                if self.is_reflex[corner as usize] && self.turn(corner) > 0.0 {
                    self.is_reflex[corner as usize] = false;
                }
            }
            if self.reflex.len() > 16 {
                let is_reflex = &self.is_reflex;
                let stale = self.reflex.iter().filter(|&&i| !is_reflex[i as usize]).count();
                if stale * 2 > self.reflex.len() {
                    self.reflex.retain(|&i| is_reflex[i as usize]);
                }
            }
            // Not the neighbour at once: cutting every second corner gives rounder triangles.
            at = self.next[after as usize];
        }
        self.triangles.push([self.prev[at as usize], at, self.next[at as usize]]);
        self.turn(at) >= 0.0
    }

    /// Twice the signed area at a corner: positive where it is convex.
    fn turn(&self, i: u32) -> f64 {
        let [a, b, c] = [self.prev[i as usize], i, self.next[i as usize]].map(|k| self.flat[k as usize]);
        (b - a).perp_dot(c - b)
    }

    /// Whether no other corner lies in the triangle at a corner, or but for a strict ear in the place of one of
    /// its own.
    fn is_empty_ear(&self, i: u32, strict: bool) -> bool {
        let ear = [self.prev[i as usize], i, self.next[i as usize]];
        let [a, b, c] = ear.map(|k| self.flat[k as usize]);
        let outside = |p: DVec2| {
            (b - a).perp_dot(p - a) < 0.0 || (c - b).perp_dot(p - b) < 0.0 || (a - c).perp_dot(p - c) < 0.0
        };
        self.reflex.iter().all(|&k| {
            let p = self.flat[k as usize];
            let is_own = ear.contains(&k) || (!strict && [a, b, c].contains(&p));
            !self.is_reflex[k as usize] || is_own || outside(p)
        })
    }
}

/// How far a triangle faces along a normal: less than zero where it faces away.
fn facing(corners: [Vec3; 3], normal: DVec3) -> f64 {
    let [a, b, c] = corners.map(|p| p.as_dvec3());
    (b - a).cross(c - a).dot(normal)
}

fn quad(corners: [Vec3; 4], normal: DVec3) -> [[u32; 3]; 2] {
    let [a, b, c, d] = corners;
    let faces = |p, q, r| facing([p, q, r], normal);
    let first = faces(a, b, c).min(faces(a, c, d));
    if first <= 0.0 && faces(a, b, d).min(faces(b, c, d)) > first {
        return [[0, 1, 3], [1, 2, 3]];
    }
    [[0, 1, 2], [0, 2, 3]]
}
