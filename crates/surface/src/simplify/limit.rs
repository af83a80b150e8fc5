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

/// How many points of the input are looked for where its triangles are large.
const POINTS: f64 = 2e5;

/// The bookkeeping of a bound on the distance.
pub(super) struct Limit {
    /// In the frame of the triangles.
    pub distance: f64,
    /// Per triangle: how far at most it is from the input, and the input from it.
    pub error: Vec<f32>,
    pub patches: Patches,
    /// The faces of the input, by closeness.
    tree: FaceTree,
    /// Corners, middles and points of sides of the input's triangles, and of the larger ones points
    /// inside, in the frame; and for each triangle those that are closest to it: the first, and for each
    /// point the next.
    points: Vec<DVec3>,
    first_point: Vec<u32>,
    next_point: Vec<u32>,
    /// Those around the edge looked at.
    near: Vec<u32>,
    /// Into how many parts at most a side is cut to find points.
    most: u32,
}

impl Limit {
    /// Nothing moved yet; `error` in mesh units.
    pub fn new(mesh: &Mesh, tri: &TriMesh, error: f64) -> Self {
        let triangles = tri.v.len() / 3;
        // Rounding positions to floats must not go past it.
        let distance = error / tri.frame.scale - 1e-7;
        // Few triangles are large ones, with much between points; of many, the middles are close enough.
        let most = (POINTS / triangles.max(1) as f64).sqrt().clamp(2.0, 8.0) as u32;
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
            let parts = parts(&[a, b, c], distance).clamp(2, most);
            for [i, j, k] in grid(parts) {
                // A side's points are found from one of its triangles.
                let side = [(k, 0), (i, 1), (j, 2)].into_iter().find(|(weight, _)| *weight == 0);
                if side.is_none_or(|(_, side)| {
                    let h = 3 * f as u32 + side;
                    h < tri.opp(h)
                }) {
                    put(f, weighed([a, b, c], [i, j, k]));
                }
            }
        }
        Self {
            distance,
            error: vec![0.0; triangles],
            patches: Patches::default(),
            tree: FaceTree::new(mesh),
            points,
            first_point,
            next_point,
            near: Vec::new(),
            most,
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
        for triangle in &self.patches.new {
            let [p, x, y] = *triangle;
            at_input((p + x + y) / 3.0)?;
            for weights in grid(parts(triangle, self.distance).clamp(4, self.most.max(4))) {
                at_input(weighed(*triangle, weights))?;
            }
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

/// Into how many parts a triangle's longest side is to be cut, so that each is about a distance long.
fn parts([a, b, c]: &[DVec3; 3], distance: f64) -> u32 {
    let longest = a.distance(*b).max(b.distance(*c)).max(c.distance(*a));
    (longest / distance).ceil() as u32
}

/// The weights of the points of a triangle whose sides are cut into equal parts, but for its corners;
/// those near the first corner first, where what has moved is.
fn grid(parts: u32) -> impl Iterator<Item = [u32; 3]> {
    (0..=parts)
        .rev()
        .flat_map(move |i| (0..=parts - i).map(move |j| [i, j, parts - i - j]))
        .filter(move |weights| !weights.contains(&parts))
}

fn weighed([a, b, c]: [DVec3; 3], [i, j, k]: [u32; 3]) -> DVec3 {
    (a * f64::from(i) + b * f64::from(j) + c * f64::from(k)) / f64::from(i + j + k)
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
