//! Measuring the distance between triangles and the input, from points on either to the other.

use crate::SurfaceError;
use crate::face_tree::closest_in_triangle;
use crate::pace::Pace;
use crate::trimesh::{Foot, TriMesh, area_vector};
use glam::DVec3;
use halfedge::NONE;
use std::collections::VecDeque;

/// The share of the limit that distances at points may reach: between the points they can be a little larger.
const MAX_MEASURED_SHARE: f64 = 0.85;

/// A triangle is quartered this often before the input's bend counts as a proof.
const MIN_QUARTERINGS: u32 = 2;
/// A triangle is quartered at most this often.
const MAX_QUARTERINGS: u32 = 7;

/// The number of points wanted on an input with few triangles.
const WANTED_POINTS: f64 = 2e5;

/// Points on the input: its vertices, the centroids of its triangles, points on their sides, and on large ones
/// points inside. They are numbered, vertices first and then the same number for each triangle, and computed
/// when needed.
struct Points {
    input: TriMesh,
    /// The limit in the frame.
    limit: f64,
    /// The most parts that a side is divided into.
    max_parts: u32,
    /// The weights of a triangle's points, by the number of parts of its sides.
    weights: Vec<Vec<[u32; 3]>>,
    /// The number of points per triangle.
    slots: u32,
}

impl Points {
    fn new(input: TriMesh, limit: f64) -> Self {
        // Few triangles are large and need more points; of many, the centroids are close enough.
        let max_parts = (WANTED_POINTS / input.faces.max(1) as f64).sqrt().clamp(2.0, 8.0) as u32;
        let weights: Vec<Vec<[u32; 3]>> = (0..=max_parts).map(|parts| weights(parts).collect()).collect();
        let slots = weights.last().map_or(0, Vec::len) as u32;
        Self { input, limit, max_parts, weights, slots }
    }

    /// The number of points.
    fn count(&self) -> usize {
        self.input.out.len() + self.input.faces * self.slots as usize
    }

    /// The number of a triangle's first point that isn't a vertex.
    fn first_of(&self, f: u32) -> u32 {
        self.input.out.len() as u32 + f * self.slots
    }

    /// The weights of a triangle's points, except its corners.
    fn weights_in(&self, places: &[DVec3; 3]) -> &[[u32; 3]] {
        let parts = if self.max_parts == 2 { 2 } else { parts(places, self.limit).clamp(2, self.max_parts) };
        &self.weights[parts as usize]
    }

    /// The position of a point.
    fn at(&self, point: u32) -> DVec3 {
        let Some(inside) = point.checked_sub(self.first_of(0)) else { return self.input.at(point) };
        let places = self.input.places(inside / self.slots);
        weighted_mean(places, self.weights_in(&places)[(inside % self.slots) as usize])
    }

    /// Calls `put` with the points of a triangle; points shared with others are passed for one of them only.
    fn for_each_point(&self, f: u32, mut put: impl FnMut(u32, DVec3)) {
        for h in 3 * f..3 * f + 3 {
            let v = self.input.from(h);
            if self.input.out[v as usize] == h {
                put(v, self.input.at(v));
            }
        }
        let places = self.input.places(f);
        for (point, &weights) in (self.first_of(f)..).zip(self.weights_in(&places)) {
            let [i, j, k] = weights;
            let side = [(k, 0), (i, 1), (j, 2)].into_iter().find(|(weight, _)| *weight == 0);
            if side.is_none_or(|(_, side)| 3 * f + side < self.input.opp(3 * f + side)) {
                put(point, weighted_mean(places, weights));
            }
        }
    }

    /// A bound on the squared distance of a triangle's points from the input; none if it exceeds `max_squared`.
    /// `feet` are the closest points of the input to its corners; `level` is how often it was quartered.
    ///
    /// It is quartered until one of three proofs holds for each part. Its corners are closest to a single triangle
    /// of the input: then the farthest corner gives the bound, as the distance to a convex set is convex. Or no
    /// point is far enough from a corner to exceed the limit. Or the input bends too little within the part.
    fn bound_squared(
        &self,
        triangle: &[DVec3; 3],
        feet: [Foot; 3],
        level: u32,
        max_squared: f64,
    ) -> Option<f64> {
        let worst = feet[0].squared.max(feet[1].squared).max(feet[2].squared);
        if worst > max_squared {
            return None;
        }
        let side = longest_side(triangle);
        let is_over_one = feet[0].face == feet[1].face && feet[1].face == feet[2].face;
        if is_over_one || level == MAX_QUARTERINGS {
            return Some(worst);
        }
        // No point of a triangle is farther from its nearest corner than side / sqrt(3).
        let bound = square(worst.sqrt() + side / 3f64.sqrt());
        if bound <= max_squared {
            return Some(bound);
        }
        if level >= MIN_QUARTERINGS {
            let areas = feet.map(|foot| area_vector(&self.input.places(foot.face)));
            // Twice the area is about a side's square, except for slivers, whose neighbours are smaller than they
            // seem. If no triangle lies between, the input bends at most once, by the angle of the two faces.
            if areas.iter().all(|area| side * side < area.length()) {
                let [p, q, r] = areas.map(|area| area.normalize_or_zero());
                let bend = p.cross(q).length().max(q.cross(r).length()).max(r.cross(p).length());
                let turned = p.dot(q).min(q.dot(r)).min(r.dot(p)) < 0.0;
                let bound = square(worst.sqrt() + 0.5 * side * if turned { 1.0 } else { bend });
                if bound <= max_squared {
                    return Some(bound);
                }
            }
        }
        let [a, b, c] = *triangle;
        let middles = [(a + b) * 0.5, (b + c) * 0.5, (c + a) * 0.5];
        let [ab, bc, ca] = middles;
        let [on_ab, on_bc, on_ca] = [0, 1, 2].map(|k| {
            let foot = self.input.closest(feet[k].face, middles[k]);
            if foot.squared <= max_squared {
                return foot;
            }
            // The walk may have ended in a fold; from the other end it may not.
            let other = self.input.closest(feet[(k + 1) % 3].face, middles[k]);
            if other.squared < foot.squared { other } else { foot }
        });
        let mut all = worst;
        for (part, feet) in [
            ([a, ab, ca], [feet[0], on_ab, on_ca]),
            ([ab, b, bc], [on_ab, feet[1], on_bc]),
            ([ca, bc, c], [on_ca, on_bc, feet[2]]),
            ([ab, bc, ca], [on_ab, on_bc, on_ca]),
        ] {
            all = all.max(self.bound_squared(&part, feet, level + 1, max_squared)?);
        }
        Some(all)
    }
}

/// Measures distances from the input: its points, each assigned to one of the current triangles.
pub(super) struct InputDistance {
    points: Points,
    /// Per triangle: a triangle of the input near it, where walks start.
    near: Vec<u32>,
    /// Per triangle: the first of its points, or [`NONE`].
    first_point: Vec<u32>,
    /// Per point: the next of the same triangle, or [`NONE`].
    next_point: Vec<u32>,
    /// The points of the triangles around the current edge.
    found: Vec<(u32, DVec3)>,
    /// The triangle of the input closest to the merged vertex.
    foot: u32,
}

impl InputDistance {
    /// Assigns the points of `input` to the current triangles. For each of these `near` has a triangle of the input,
    /// and `error` a bound on the distance from the input; `into` gives the current vertex for each vertex of the
    /// input. `limit` is in the frame.
    pub fn new(
        input: TriMesh,
        tri: &TriMesh,
        near: Vec<u32>,
        error: &[f32],
        mut into: impl FnMut(u32) -> u32,
        limit: f64,
        pace: &mut Pace<'_, '_>,
    ) -> Result<Self, SurfaceError> {
        let triangles = input.faces;
        let points = Points::new(input, limit);
        let mut first_point = vec![NONE; tri.v.len() / 3];
        let mut next_point = vec![NONE; points.count()];
        let mut owners =
            Owners { tri, error, seen: vec![0; tri.v.len() / 3], asked: 0, waiting: VecDeque::new() };
        pace.chunks(triangles, |range| {
            for f in range.start as u32..range.end as u32 {
                // Triangles around the vertices that the corners were merged into are near.
                let around = [0, 1, 2].map(|k| tri.out[into(points.input.from(3 * f + k)) as usize]);
                let mut owner = around.into_iter().find(|&out| out != NONE).unwrap_or(0) / 3;
                points.for_each_point(f, |point, at| {
                    owner = owners.of(at, owner);
                    next_point[point as usize] = std::mem::replace(&mut first_point[owner as usize], point);
                });
            }
        })?;
        Ok(Self { points, near, first_point, next_point, found: Vec::new(), foot: 0 })
    }

    /// Collects the points of the triangles around an edge.
    pub fn collect(&mut self, tri: &TriMesh, h: u32) {
        let (a, b) = (tri.from(h), tri.to(h));
        self.found.clear();
        for (v, other) in [(a, NONE), (b, a)] {
            tri.around(v, |out| {
                if tri.to(out) == other || tri.apex(out) == other {
                    return;
                }
                let mut point = self.first_point[out as usize / 3];
                while point != NONE {
                    self.found.push((point, self.points.at(point)));
                    point = self.next_point[point as usize];
                }
            });
        }
        self.foot = self.near[h as usize / 3];
    }

    /// A bound on the distance, in both directions, between the input and the triangles that would replace those
    /// around an edge; none if it exceeds the limit. Between the input's points it is approximate.
    pub fn distance(&mut self, new: &[[DVec3; 3]]) -> Option<f64> {
        let input = &self.points.input;
        let limit_squared = square(self.points.limit * MAX_MEASURED_SHARE);
        let first = input.closest(self.foot, new.first()?[0]);
        self.foot = first.face;
        let mut worst = first.squared;
        for triangle in new {
            let [_, x, y] = *triangle;
            let second = input.closest(first.face, x);
            let feet = [first, second, input.closest(second.face, y)];
            worst = worst.max(self.points.bound_squared(triangle, feet, 0, limit_squared)?);
        }
        // Last, as there are many points.
        for &(_, point) in &self.found {
            let squared = new.iter().map(|t| distance_squared(t, point)).reduce(f64::min)?;
            worst = worst.max(squared);
            if squared > limit_squared {
                return None;
            }
        }
        (worst <= limit_squared).then(|| worst.sqrt() / MAX_MEASURED_SHARE)
    }

    /// Assigns each of the collected points to the closest triangle around the merged vertex.
    pub fn assign_points(&mut self, tri: &TriMesh, v: u32) {
        let mut fan: Vec<(u32, [DVec3; 3])> = Vec::with_capacity(8);
        tri.around(v, |out| {
            self.first_point[out as usize / 3] = NONE;
            self.near[out as usize / 3] = self.foot;
            fan.push((out / 3, [tri.at(v), tri.at(tri.to(out)), tri.at(tri.apex(out))]));
        });
        for &(point, at) in &self.found {
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

/// The search for the triangles that points are assigned to.
struct Owners<'a> {
    tri: &'a TriMesh,
    error: &'a [f32],
    /// Per triangle: the last search that reached it.
    seen: Vec<u32>,
    asked: u32,
    waiting: VecDeque<u32>,
}

impl Owners<'_> {
    /// A triangle whose distance to `p` is within its error bound, searched from a triangle nearby. Such a triangle
    /// exists, and assigning the point to it ensures that no collapse loses the point.
    fn of(&mut self, p: DVec3, start: u32) -> u32 {
        let closest = self.tri.closest(start, p);
        if self.is_within_error(closest.face, closest.squared) {
            return closest.face;
        }
        self.asked += 1;
        self.seen[closest.face as usize] = self.asked;
        self.waiting.clear();
        self.waiting.push_back(closest.face);
        while let Some(f) = self.waiting.pop_front() {
            if self.is_within_error(f, distance_squared(&self.tri.places(f), p)) {
                return f;
            }
            for h in 3 * f..3 * f + 3 {
                let across = self.tri.opp(h);
                if across != NONE && self.seen[across as usize / 3] != self.asked {
                    self.seen[across as usize / 3] = self.asked;
                    self.waiting.push_back(across / 3);
                }
            }
        }
        closest.face
    }

    fn is_within_error(&self, f: u32, squared: f64) -> bool {
        // The input's positions are rounded to floats.
        let bound = f64::from(self.error[f as usize]) + 1e-7;
        squared <= bound * bound
    }
}

fn square(x: f64) -> f64 {
    x * x
}

fn longest_side([a, b, c]: &[DVec3; 3]) -> f64 {
    a.distance_squared(*b).max(b.distance_squared(*c)).max(c.distance_squared(*a)).sqrt()
}

/// The number of parts of a triangle's longest side that are about `distance` long.
fn parts(triangle: &[DVec3; 3], distance: f64) -> u32 {
    (longest_side(triangle) / distance).ceil() as u32
}

/// The weights of a triangle's centroid and of the grid points that divide its sides into equal parts, except its
/// corners. Points near the first corner, which is the one that moved, come first.
fn weights(parts: u32) -> impl Iterator<Item = [u32; 3]> {
    let grid = (0..=parts).rev().flat_map(move |i| (0..=parts - i).map(move |j| [i, j, parts - i - j]));
    std::iter::once([1, 1, 1]).chain(grid.filter(move |weights| !weights.contains(&parts)))
}

fn weighted_mean([a, b, c]: [DVec3; 3], [i, j, k]: [u32; 3]) -> DVec3 {
    (a * f64::from(i) + b * f64::from(j) + c * f64::from(k)) / f64::from(i + j + k)
}

fn distance_squared(triangle: &[DVec3; 3], p: DVec3) -> f64 {
    let w = closest_in_triangle(*triangle, p);
    (triangle[0] * w.x + triangle[1] * w.y + triangle[2] * w.z).distance_squared(p)
}
