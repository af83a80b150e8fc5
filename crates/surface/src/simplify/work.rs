//! The mesh being simplified: where edges collapse to, what that costs, and whether it may be.

use super::limit::Limit;
use super::measurement::InputDistance;
use super::quadric::Quadric;
use super::queue::Queue;
use super::{Simplify, SimplifyTarget};
use crate::SurfaceError;
use crate::pace::Pace;
use crate::trimesh::{Borders, Order, Renumbering, Role, TriMesh, area_vector, next, prev};
use glam::DVec3;
use halfedge::{Mesh, NONE};

/// The weight of a vertex's own position relative to its planes: too small to move a point off its planes, but
/// enough to keep it from sliding along them.
const POSITION_WEIGHT: f64 = 1e-6;
/// The weight of each face in addition to its area, in mean areas.
const EQUAL_WEIGHT: f64 = 0.5;
/// The weight of planes along boundaries and seams relative to faces.
const CURVE_WEIGHT: f64 = 100.0;
/// The cosine of the largest angle by which a triangle may turn in a collapse.
const MIN_TURN_COS: f64 = 0.2;
/// The least shape of a triangle, unless it was worse before: twice its area over its longest side's square, which
/// is 0.87 for an equilateral one.
const MIN_SHAPE: f64 = 0.02;

/// The triangles with everything needed to collapse edges.
pub(super) struct Work<'a> {
    source: &'a Mesh,
    pub tri: TriMesh,
    quadrics: Vec<Quadric>,
    roles: Vec<Role>,
    pub queue: Queue,
    stamps: Vec<u32>,
    stamp: u32,
    /// Per vertex: whether a collapse at it was refused since its triangles last changed.
    pub refused: Vec<bool>,

    preserve_boundary: bool,
    preserve_seams: bool,
    pub limit: Option<Limit>,
}

/// Where the ends of an edge would merge, and at which cost.
pub(super) struct Target {
    pub cost: f64,
    pub at: DVec3,
}

impl<'a> Work<'a> {
    pub(super) fn new(mesh: &'a Mesh, tri: TriMesh, options: &Simplify) -> Self {
        let vertices = tri.out.len();
        let limit = match options.target {
            // Rounding positions to floats must not exceed the limit.
            SimplifyTarget::MaxError(error) => {
                Some(Limit::new(tri.v.len() / 3, vertices, error / tri.frame.scale - 1e-7))
            }
            _ => None,
        };
        let mut work = Self {
            source: mesh,
            quadrics: vec![Quadric::default(); vertices],
            roles: vec![Role::Free; vertices],
            queue: Queue::new(tri.v.len()),
            stamps: vec![0; vertices],
            stamp: 0,
            refused: vec![false; vertices],
            preserve_boundary: options.preserve_boundary,
            preserve_seams: options.preserve_seams,
            limit,
            tri,
        };
        work.add_faces();
        work.add_curves(mesh);
        work
    }

    /// Begins to measure distances, after freeing the memory of removed triangles.
    pub(super) fn begin_measuring(&mut self, pace: &mut Pace<'_, '_>) -> Result<(), SurfaceError> {
        let Some(limit) = &mut self.limit else { return Ok(()) };
        // Nothing can be measured below the rounding error.
        if limit.distance <= 0.0 {
            return Ok(());
        }
        self.queue.restart(0);
        self.stamps = Vec::new();
        let before = self.tri.out.len();
        let Order { vertices, triangles } = self.tri.put_in_order();
        vertices.apply(&mut self.quadrics);
        vertices.apply(&mut self.roles);
        vertices.apply(&mut self.refused);
        triangles.apply(&mut limit.error);
        let Renumbering(near) = triangles;
        let number = vertices.new_numbers(before);
        // The triangles are numbered as they were at first.
        let input = TriMesh::bare(self.source);
        let mut into = std::mem::take(&mut limit.into);
        let merged = |v: u32| {
            let mut v = v as usize;
            while into[v] as usize != v {
                into[v] = into[into[v] as usize];
                v = into[v] as usize;
            }
            number[v]
        };
        let measured =
            InputDistance::new(input, &self.tri, near, &limit.error, merged, limit.distance, pace)?;
        limit.measured = Some(measured);
        self.stamps = vec![0; self.tri.out.len()];
        self.stamp = 0;
        self.refused.fill(false);
        self.queue.restart(self.tri.v.len());
        Ok(())
    }

    /// The triangles; frees everything else.
    pub(super) fn finish(self) -> TriMesh {
        self.tri
    }

    fn add_faces(&mut self) {
        let tri = &self.tri;
        let faces = || (0..tri.faces as u32).map(|f| tri.places(f));
        let equal =
            EQUAL_WEIGHT * faces().map(|face| area_vector(&face).length()).sum::<f64>() / tri.faces as f64;
        for (corners, face) in tri.v.chunks_exact(3).zip(faces()) {
            let normal = area_vector(&face);
            let weight = normal.length() + equal;
            let plane = match normal.try_normalize() {
                Some(normal) => Quadric::plane(normal, face[0], weight),
                None => Quadric::default(),
            };
            for (&v, p) in corners.iter().zip(face) {
                let q = &mut self.quadrics[v as usize];
                q.add(&plane);
                q.add(&Quadric::point(p, weight * POSITION_WEIGHT));
            }
        }
    }

    /// Adds planes that keep boundaries, seams of corner attributes, creases, and borders between materials, groups
    /// and colours. Sets the roles of vertices on the first two.
    fn add_curves(&mut self, mesh: &Mesh) {
        let tri = &self.tri;
        let mut curves = vec![0u8; tri.out.len()];
        let borders = Borders::new(mesh);
        for h in 0..tri.v.len() as u32 {
            let across = tri.opp(h);
            let boundary = across == NONE;
            let seam = !boundary && self.preserve_seams && tri.is_seam(h);
            if !(boundary || seam || borders.has(tri, h)) {
                continue;
            }
            let (a, b) = (tri.from(h), tri.to(h));
            let strict = seam || (boundary && self.preserve_boundary);
            if strict {
                // A seam is visited from both sides.
                for v in [a, b] {
                    curves[v as usize] = curves[v as usize].saturating_add(if boundary { 2 } else { 1 });
                }
            }
            let (from, to, apex) = (tri.at(a), tri.at(b), tri.at(tri.apex(h)));
            let along = to - from;
            let face = along.cross(apex - from);
            if let Some(normal) = along.cross(face).try_normalize() {
                let weight = if boundary && !self.preserve_boundary { 1.0 } else { CURVE_WEIGHT };
                let plane = Quadric::plane(normal, from, along.length_squared() * weight);
                self.quadrics[a as usize].add(&plane);
                self.quadrics[b as usize].add(&plane);
            }
        }
        for (role, &sides) in self.roles.iter_mut().zip(&curves) {
            *role = match sides {
                0 => Role::Free,
                4 => Role::Curve,
                _ => Role::Fixed,
            };
        }
    }

    /// Whether an edge is part of a boundary or seam that is preserved.
    fn is_curve(&self, h: u32) -> bool {
        if self.tri.opp(h) == NONE {
            self.preserve_boundary
        } else {
            self.preserve_seams && self.tri.is_seam(h)
        }
    }

    /// Where the ends of an edge would merge; none if they may not.
    pub(super) fn find_target(&self, h: u32) -> Option<Target> {
        let (a, b) = (self.tri.from(h), self.tri.to(h));
        let sum = self.quadrics[a as usize].sum(&self.quadrics[b as usize]);
        let (p, q) = (self.tri.at(a), self.tri.at(b));
        let stay = |at: DVec3| Some(Target { cost: sum.at(at), at });
        let roles = (self.roles[a as usize], self.roles[b as usize]);
        match roles {
            (Role::Free, Role::Free) => {}
            (_, Role::Free) => return stay(p),
            (Role::Free, _) => return stay(q),
            _ if !self.is_curve(h) => return None,
            (Role::Curve, Role::Curve) => {}
            (Role::Fixed, Role::Curve) => return stay(p),
            (Role::Curve, Role::Fixed) => return stay(q),
            (Role::Fixed, Role::Fixed) => return None,
        }
        let middle = (p + q) * 0.5;
        let reach = 4.0 * p.distance_squared(q);
        if let Some(at) = sum.minimum()
            && at.distance_squared(middle) <= reach
        {
            return stay(at);
        }
        [p, q, middle]
            .into_iter()
            .map(|at| Target { cost: sum.at(at), at })
            .reduce(|best, other| if other.cost < best.cost { other } else { best })
    }

    /// Collapses an edge if the result is good; returns whether it did.
    pub(super) fn try_collapse(&mut self, h: u32, at: DVec3) -> bool {
        // The rounded position is checked.
        let at = self.tri.frame.inward(self.tri.frame.outward(at));
        self.stamp += 1;
        if !at.is_finite()
            || !self.tri.can_collapse(h, &mut self.stamps, self.stamp)
            || !self.keeps_triangles_good(h, at)
        {
            return false;
        }
        let Some(error) = self.bound_error(h, at) else { return false };
        let tri = &mut self.tri;
        let (a, b, across) = (tri.from(h), tri.to(h), tri.opp(h));
        // Two edges of each triangle become one, which costs at least as much as either: quadrics only grow.
        let mut joined = [(NONE, 0); 2];
        for (side, joined) in [h, across].into_iter().zip(&mut joined) {
            if side == NONE {
                continue;
            }
            self.queue.remove(tri.edge(side));
            let ranks = [next(side), prev(side)].map(|k| {
                let rank = self.queue.rank_of(tri.edge(k));
                self.queue.remove(tri.edge(k));
                rank
            });
            if let [Some(left), Some(right)] = ranks {
                *joined = (tri.opp(next(side)).min(tri.opp(prev(side))), left.max(right));
            }
        }
        tri.collapse_to(h, at);
        let merged = self.quadrics[b as usize];
        self.quadrics[a as usize].add(&merged);
        if self.roles[b as usize] == Role::Fixed || self.roles[a as usize] == Role::Free {
            self.roles[a as usize] = self.roles[b as usize];
        }
        self.note_merge(b, a, error);
        for (edge, rank) in joined {
            if edge != NONE {
                self.queue.put(edge, rank);
            }
        }
        let first = self.tri.out[a as usize];
        let mut around = first;
        loop {
            self.requeue_edge(self.tri.edge(around));
            self.retry_around(self.tri.to(around));
            let after = self.tri.turn(around);
            if after == NONE {
                self.requeue_edge(prev(around));
                self.retry_around(self.tri.apex(around));
                break;
            }
            if after == first {
                break;
            }
            around = after;
        }
        true
    }

    /// Queues the edges of a vertex whose triangles changed again, if one of them was refused.
    fn retry_around(&mut self, v: u32) {
        if !std::mem::take(&mut self.refused[v as usize]) {
            return;
        }
        let first = self.tri.out[v as usize];
        let mut around = first;
        loop {
            self.requeue_edge(self.tri.edge(around));
            let after = self.tri.turn(around);
            if after == NONE {
                self.requeue_edge(prev(around));
                break;
            }
            if after == first {
                break;
            }
            around = after;
        }
    }

    /// Whether no triangle around an edge turns over or becomes a sliver if its ends move to `at`.
    fn keeps_triangles_good(&self, h: u32, at: DVec3) -> bool {
        let tri = &self.tri;
        let (a, b) = (tri.from(h), tri.to(h));
        for (v, other) in [(a, b), (b, a)] {
            let here = tri.at(v);
            let mut good = true;
            tri.around(v, |out| {
                let (x, y) = (tri.to(out), tri.apex(out));
                if x == other || y == other || !good {
                    return;
                }
                let (x, y) = (tri.at(x), tri.at(y));
                let old = (x - here).cross(y - here);
                let new = (x - at).cross(y - at);
                let (old_squared, new_squared) = (old.length_squared(), new.length_squared());
                let turned = old.dot(new);
                if turned < 0.0 || turned * turned < MIN_TURN_COS * MIN_TURN_COS * old_squared * new_squared {
                    // A triangle without area has no direction.
                    good = old_squared == 0.0 && new_squared > 0.0;
                }
                let rim = x.distance_squared(y);
                let longest = rim.max(x.distance_squared(at)).max(y.distance_squared(at));
                if new_squared < MIN_SHAPE * MIN_SHAPE * longest * longest {
                    let was = rim.max(x.distance_squared(here)).max(y.distance_squared(here));
                    good &= new_squared > 0.0 && new_squared * was * was > old_squared * longest * longest;
                }
            });
            if !good {
                return false;
            }
        }
        true
    }
}
