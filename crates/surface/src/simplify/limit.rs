//! Keeping within a distance of the input.
//!
//! Two ways to know that a collapse does: adding what it moves the surface by ([`super::deviation`]) to
//! what came before, which holds for every point but adds up; and, once that goes past the limit,
//! measuring, from points all over the old patch to the new one and from the new one to the input.

use super::Work;
use super::deviation::{Outline, Patches};
use crate::FaceTree;
use crate::face_tree::closest_in_triangle;
use crate::trimesh::TriMesh;
use glam::DVec3;
use halfedge::{Mesh, NONE};

/// How much of the limit what is measured at points may use up: in between it can be a little more.
const MEASURED: f64 = 0.75;

/// The bookkeeping of a bound on the distance.
pub(super) struct Limit {
    /// In the frame of the triangles.
    pub distance: f64,
    /// Per triangle: how far at most it is from the input, and the input from it.
    pub error: Vec<f32>,
    pub patches: Patches,
    /// The faces of the input, by closeness.
    tree: FaceTree,
    /// Corners, middles and middles of sides of the input's triangles, in the frame, and for each triangle those that are
    /// closest to it: the first, and for each point the next.
    points: Vec<DVec3>,
    first_point: Vec<u32>,
    next_point: Vec<u32>,
    /// Those around the edge looked at.
    near: Vec<u32>,
}

impl Limit {
    /// Nothing moved yet; `error` in mesh units.
    pub fn new(mesh: &Mesh, tri: &TriMesh, error: f64) -> Self {
        let triangles = tri.v.len() / 3;
        let mut points = Vec::with_capacity(3 * triangles + tri.out.len());
        let mut first_point = vec![NONE; triangles];
        let mut next_point = Vec::with_capacity(points.capacity());
        let mut put = |triangle: usize, point: DVec3| {
            next_point.push(std::mem::replace(&mut first_point[triangle], points.len() as u32));
            points.push(point);
        };
        for (v, &out) in (0u32..).zip(&tri.out) {
            if out != NONE {
                put(out as usize / 3, tri.at(v));
            }
        }
        for (f, corners) in tri.v.chunks_exact(3).enumerate() {
            let [a, b, c] = [tri.at(corners[0]), tri.at(corners[1]), tri.at(corners[2])];
            put(f, (a + b + c) / 3.0);
            for (h, (p, q)) in (3 * f as u32..).zip([(a, b), (b, c), (c, a)]) {
                if h < tri.opp(h) {
                    put(f, (p + q) * 0.5);
                }
            }
        }
        Self {
            // Rounding positions to floats must not go past it.
            distance: error / tri.frame.scale - 1e-7,
            error: vec![0.0; triangles],
            patches: Patches::default(),
            tree: FaceTree::new(mesh),
            points,
            first_point,
            next_point,
            near: Vec::new(),
        }
    }

    /// Notes the points of the triangles around two vertices.
    pub fn collect(&mut self, tri: &TriMesh, a: u32, b: u32) {
        self.near.clear();
        for (v, other) in [(a, NONE), (b, a)] {
            tri.around(v, |out| {
                if tri.to(out) == other || tri.apex(out) == other {
                    return;
                }
                let mut point = self.first_point[out as usize / 3];
                while point != NONE {
                    self.near.push(point);
                    point = self.next_point[point as usize];
                }
            });
        }
    }

    /// The distance between the new patch and the input, both ways; none if it is above the limit.
    pub fn measure(&self, mesh: &Mesh, tri: &TriMesh) -> Option<f64> {
        let limit = self.distance * MEASURED;
        let mut worst = 0.0f64;
        for &point in &self.near {
            let point = self.points[point as usize];
            let squared = self.patches.new.iter().map(|t| distance_squared(t, point)).reduce(f64::min)?;
            worst = worst.max(squared);
            if squared > limit * limit {
                return None;
            }
        }
        worst = worst.sqrt();
        // Each point is near the one before, and so is what it is closest to.
        let mut near = None;
        let mut at_input = |p: DVec3| {
            let hit = self.tree.closest_point_near(mesh, tri.frame.outward(p), near)?;
            near = Some(hit.face);
            worst = worst.max(hit.distance / tri.frame.scale);
            (worst <= limit).then_some(())
        };
        at_input(self.patches.new.first()?[0])?;
        for &[p, x, y] in &self.patches.new {
            at_input((p + x + y) / 3.0)?;
            for (from, to) in [(p, x), (x, y), (y, p)] {
                at_input((from + to) * 0.5)?;
                at_input((from * 3.0 + to) * 0.25)?;
                at_input((from + to * 3.0) * 0.25)?;
            }
            at_input((p * 2.0 + x + y) * 0.25)?;
            at_input((p + x * 2.0 + y) * 0.25)?;
            at_input((p + x + y * 2.0) * 0.25)?;
        }
        Some(worst)
    }

    /// Gives the points noted to the triangles around the merged vertex, each to the closest.
    pub fn hand_out(&mut self, tri: &TriMesh, v: u32) {
        let mut fan: Vec<(u32, [DVec3; 3])> = Vec::with_capacity(8);
        tri.around(v, |out| {
            self.first_point[out as usize / 3] = NONE;
            fan.push((out / 3, [tri.at(v), tri.at(tri.to(out)), tri.at(tri.apex(out))]));
        });
        for &point in &self.near {
            let at = self.points[point as usize];
            let closest = fan
                .iter()
                .map(|(f, t)| (distance_squared(t, at), *f))
                .reduce(|best, other| if other.0 < best.0 { other } else { best });
            if let Some((_, f)) = closest {
                let first = &mut self.first_point[f as usize];
                self.next_point[point as usize] = std::mem::replace(first, point);
            }
        }
    }
}

fn distance_squared(triangle: &[DVec3; 3], p: DVec3) -> f64 {
    let w = closest_in_triangle(*triangle, p);
    (triangle[0] * w.x + triangle[1] * w.y + triangle[2] * w.z).distance_squared(p)
}

impl Work<'_> {
    /// The bound on the distance of the triangles that would be made; none if it is above the limit.
    pub(super) fn new_error(&mut self, h: u32, at: DVec3) -> Option<f32> {
        let Some(limit) = &mut self.limit else { return Some(0.0) };
        let tri = &self.tri;
        let (a, b) = (tri.from(h), tri.to(h));
        limit.patches.clear();
        let mut error = 0.0f32;
        for (v, other) in [(a, b), (b, a)] {
            tri.around(v, |out| {
                error = error.max(limit.error[out as usize / 3]);
                let (x, y) = (tri.to(out), tri.apex(out));
                if v == a || (x != other && y != other) {
                    limit.patches.old.push([tri.at(v), tri.at(x), tri.at(y)]);
                }
                if x != other && y != other {
                    limit.patches.new.push([at, tri.at(x), tri.at(y)]);
                }
            });
        }
        let mut outline = None;
        if tri.opp(h) == NONE {
            // The boundary comes in to `a` and goes on from `b`.
            let mut last = h;
            while tri.turn(last) != NONE {
                last = tri.turn(last);
            }
            let (before, after) = (tri.apex(last), tri.to(tri.out[b as usize]));
            outline = Some(Outline { old: [before, a, b, after].map(|v| tri.at(v)), ends: [true; 2] });
        } else if tri.is_boundary_vertex(a) || tri.is_boundary_vertex(b) {
            // The boundary vertex stays when it is preserved; else its outline moves with it.
            let v = if tri.is_boundary_vertex(a) { a } else { b };
            let out = tri.out[v as usize];
            let mut last = out;
            while tri.turn(last) != NONE {
                last = tri.turn(last);
            }
            let here = tri.at(v);
            outline = Some(Outline {
                old: [tri.at(tri.apex(last)), here, here, tri.at(tri.to(out))],
                ends: [v == a, v == b],
            });
        }
        let moved = limit.patches.bound(tri.at(a), tri.at(b), at, outline.as_ref());
        let total = f64::from(error) + moved;
        limit.collect(tri, a, b);
        let total = if total <= limit.distance { total } else { limit.measure(self.source, tri)? };
        // Rounded up.
        Some((total * (1.0 + 1e-6)) as f32 + f32::MIN_POSITIVE)
    }
}
