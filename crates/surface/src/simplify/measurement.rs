//! Measuring how far triangles are from the input, from points all over either to the other.

use crate::SurfaceError;
use crate::face_tree::closest_in_triangle;
use crate::pace::Pace;
use crate::trimesh::{Foot, TriMesh, area_vector};
use glam::DVec3;
use halfedge::NONE;
use std::collections::VecDeque;

/// How much of a bound what is measured at points may be: in between it can be a little more.
const MEASURED: f64 = 0.85;

/// How often a triangle is quartered to measure it: at least, unless less is proof, and at most.
const COARSEST: u32 = 2;
const FINEST: u32 = 7;

/// How many points of the input are looked for where its triangles are large.
const POINTS: f64 = 2e5;

/// Points on the input: its vertices, the middles of its triangles, points on their sides, and on the
/// larger ones points inside. They are numbered, vertices first and then so many for each triangle, and
/// worked out when they are needed.
struct Points {
    input: TriMesh,
    /// In the frame.
    limit: f64,
    /// Into how many parts at most a side is cut to find points.
    most: u32,
    /// How many numbers each triangle has for its points.
    slots: u32,
}

impl Points {
    fn new(input: TriMesh, limit: f64) -> Self {
        // Few triangles are large ones, with much between points; of many, the middles are close enough.
        let most = (POINTS / input.faces.max(1) as f64).sqrt().clamp(2.0, 8.0) as u32;
        Self { input, limit, most, slots: weights(most).count() as u32 }
    }

    /// How many numbers there are.
    fn count(&self) -> usize {
        self.input.out.len() + self.input.faces * self.slots as usize
    }

    /// The number of a triangle's first point that is not a vertex.
    fn first_of(&self, f: u32) -> u32 {
        self.input.out.len() as u32 + f * self.slots
    }

    /// The weights of a triangle's points but for its corners.
    fn weights_in(&self, places: &[DVec3; 3]) -> impl Iterator<Item = [u32; 3]> + use<> {
        let parts = if self.most == 2 { 2 } else { parts(places, self.limit).clamp(2, self.most) };
        weights(parts)
    }

    /// Where a point is.
    fn at(&self, point: u32) -> DVec3 {
        let Some(inside) = point.checked_sub(self.first_of(0)) else { return self.input.at(point) };
        let places = self.input.places(inside / self.slots);
        let weights = self.weights_in(&places).nth((inside % self.slots) as usize);
        weighed(places, weights.unwrap_or(MIDDLE))
    }

    /// Calls `put` with the points of a triangle, those that it shares with others only from one of them.
    fn each(&self, f: u32, mut put: impl FnMut(u32, DVec3)) {
        for h in 3 * f..3 * f + 3 {
            let v = self.input.from(h);
            if self.input.out[v as usize] == h {
                put(v, self.input.at(v));
            }
        }
        let places = self.input.places(f);
        for (point, weights) in (self.first_of(f)..).zip(self.weights_in(&places)) {
            let [i, j, k] = weights;
            let side = [(k, 0), (i, 1), (j, 2)].into_iter().find(|(weight, _)| *weight == 0);
            if side.is_none_or(|(_, side)| 3 * f + side < self.input.opp(3 * f + side)) {
                put(point, weighed(places, weights));
            }
        }
    }

    /// The square of how far a triangle's points are from the input at most; none if it is above `most`.
    /// `feet` are where its corners are closest to the input, and `level` how often it was quartered.
    ///
    /// It is quartered until the corners of each part are closest to one triangle of the input, from which
    /// no point of the part is farther than the farthest of them (distance to what is convex is convex), or
    /// no point can be beyond the limit, as none is far from a corner, or the input bends too little for
    /// that within the part.
    fn farthest(&self, triangle: &[DVec3; 3], feet: [Foot; 3], level: u32, most: f64) -> Option<f64> {
        let worst = feet[0].squared.max(feet[1].squared).max(feet[2].squared);
        if worst > most {
            return None;
        }
        let side = longest_side(triangle);
        let is_over_one = feet[0].face == feet[1].face && feet[1].face == feet[2].face;
        if is_over_one || level == FINEST {
            return Some(worst);
        }
        // No point of a triangle is farther from all corners than that.
        let bound = square(worst.sqrt() + side / 3f64.sqrt());
        if bound <= most {
            return Some(bound);
        }
        if level >= COARSEST {
            let areas = feet.map(|foot| area_vector(&self.input.places(foot.face)));
            // Twice the area is about a side's square, but of slivers, whose neighbours are smaller than they
            // look. Where none lies between, the input bends once at most, by the angle of the two faces.
            if areas.iter().all(|area| side * side < area.length()) {
                let [p, q, r] = areas.map(|area| area.normalize_or_zero());
                let bend = p.cross(q).length().max(q.cross(r).length()).max(r.cross(p).length());
                let turned = p.dot(q).min(q.dot(r)).min(r.dot(p)) < 0.0;
                let bound = square(worst.sqrt() + 0.5 * side * if turned { 1.0 } else { bend });
                if bound <= most {
                    return Some(bound);
                }
            }
        }
        let [a, b, c] = *triangle;
        let middles = [(a + b) * 0.5, (b + c) * 0.5, (c + a) * 0.5];
        let [ab, bc, ca] = middles;
        let [on_ab, on_bc, on_ca] = [0, 1, 2].map(|k| {
            let foot = self.input.closest(feet[k].face, middles[k]);
            if foot.squared <= most {
                return foot;
            }
            // The walk may have ended in a fold: the other end may be on the right side of it.
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
            all = all.max(self.farthest(&part, feet, level + 1, most)?);
        }
        Some(all)
    }
}

/// The input with points on it, each of which belongs to one of the triangles made of it.
pub(super) struct Measured {
    points: Points,
    /// Per triangle: one of the input near it, to walk from.
    near: Vec<u32>,
    /// Per triangle: the first of the points that are closest to it, or [`NONE`].
    first_point: Vec<u32>,
    /// Per point: the next that belongs to the same triangle, or [`NONE`].
    next_point: Vec<u32>,
    /// Those around the edge looked at.
    found: Vec<(u32, DVec3)>,
    /// Where on the input the merged vertex would be nearest.
    foot: u32,
}

impl Measured {
    /// Points of `input` for the triangles made of it: `near` has one of the input's triangles for each
    /// of them, `error` how far it and the input are from each other at most, and `into` a vertex for each
    /// of the input's. `limit` is the distance, in the frame.
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
                // Triangles around what the corners have become are near.
                let around = [0, 1, 2].map(|k| tri.out[into(points.input.from(3 * f + k)) as usize]);
                let mut owner = around.into_iter().find(|&out| out != NONE).unwrap_or(0) / 3;
                points.each(f, |point, at| {
                    owner = owners.of(at, owner);
                    next_point[point as usize] = std::mem::replace(&mut first_point[owner as usize], point);
                });
            }
        })?;
        Ok(Self { points, near, first_point, next_point, found: Vec::new(), foot: 0 })
    }

    /// Notes the points of the triangles around an edge.
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

    /// A bound on the distance between the triangles that would replace those around an edge and the input,
    /// both ways; none if it is above the limit. In between the points it may be a little more than at them.
    pub fn distance(&mut self, new: &[[DVec3; 3]]) -> Option<f64> {
        let input = &self.points.input;
        let limit_squared = square(self.points.limit * MEASURED);
        let first = input.closest(self.foot, new.first()?[0]);
        self.foot = first.face;
        let mut worst = first.squared;
        for triangle in new {
            let [_, x, y] = *triangle;
            let second = input.closest(first.face, x);
            let feet = [first, second, input.closest(second.face, y)];
            worst = worst.max(self.points.farthest(triangle, feet, 0, limit_squared)?);
        }
        // There are many of these: last.
        for &(_, point) in &self.found {
            let squared = new.iter().map(|t| distance_squared(t, point)).reduce(f64::min)?;
            worst = worst.max(squared);
            if squared > limit_squared {
                return None;
            }
        }
        (worst <= limit_squared).then(|| worst.sqrt() / MEASURED)
    }

    /// Gives the points noted to the triangles around the merged vertex, each to the closest.
    pub fn hand_out(&mut self, tri: &TriMesh, v: u32) {
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

/// The search for the triangles that points of the input belong to.
struct Owners<'a> {
    tri: &'a TriMesh,
    error: &'a [f32],
    /// Per triangle: the last search that came to it.
    seen: Vec<u32>,
    asked: u32,
    waiting: VecDeque<u32>,
}

impl Owners<'_> {
    /// A triangle that is as near to `p` as its bound promises, found from one that is not far. There is
    /// one; that it is this which has the point makes sure that no collapse leaves the point behind.
    fn of(&mut self, p: DVec3, start: u32) -> u32 {
        let closest = self.tri.closest(start, p);
        if self.is_kept_by(closest.face, closest.squared) {
            return closest.face;
        }
        self.asked += 1;
        self.seen[closest.face as usize] = self.asked;
        self.waiting.clear();
        self.waiting.push_back(closest.face);
        while let Some(f) = self.waiting.pop_front() {
            if self.is_kept_by(f, distance_squared(&self.tri.places(f), p)) {
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

    fn is_kept_by(&self, f: u32, squared: f64) -> bool {
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

/// Into how many parts a triangle's longest side is to be cut, so that each is about a distance long.
fn parts(triangle: &[DVec3; 3], distance: f64) -> u32 {
    (longest_side(triangle) / distance).ceil() as u32
}

/// The weights of a triangle's middle.
const MIDDLE: [u32; 3] = [1, 1, 1];

/// The weights of a triangle's middle and of the points of it where its sides are cut into equal parts,
/// but for its corners; those near the first corner first, where what has moved is.
fn weights(parts: u32) -> impl Iterator<Item = [u32; 3]> {
    let grid = (0..=parts).rev().flat_map(move |i| (0..=parts - i).map(move |j| [i, j, parts - i - j]));
    std::iter::once(MIDDLE).chain(grid.filter(move |weights| !weights.contains(&parts)))
}

fn weighed([a, b, c]: [DVec3; 3], [i, j, k]: [u32; 3]) -> DVec3 {
    (a * f64::from(i) + b * f64::from(j) + c * f64::from(k)) / f64::from(i + j + k)
}

fn distance_squared(triangle: &[DVec3; 3], p: DVec3) -> f64 {
    let w = closest_in_triangle(*triangle, p);
    (triangle[0] * w.x + triangle[1] * w.y + triangle[2] * w.z).distance_squared(p)
}
