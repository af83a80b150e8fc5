//! Keeping within a distance of the input.
//!
//! Two ways to know that a collapse does: adding what it moves the surface by ([`super::deviation`]) to
//! what came before, which holds for every point but adds up; and, where that is past the limit,
//! measuring ([`super::measurement`]). Measuring takes memory and time that adding does not, so everything
//! that adding allows is done first.

use super::Work;
use super::deviation::{Outline, Patches};
use super::measurement::Measured;
use halfedge::NONE;

/// The bookkeeping of a bound on the distance.
pub(super) struct Limit {
    /// In the frame of the triangles.
    pub distance: f64,
    /// Per triangle: how far at most it is from the input, and the input from it.
    pub error: Vec<f32>,
    /// Per vertex of the input: the one that it was merged into, or itself.
    pub into: Vec<u32>,
    pub patches: Patches,
    /// What to measure with, once there is no way on without.
    pub measured: Option<Measured>,
}

impl Limit {
    /// Nothing moved yet; `distance` in the frame.
    pub fn new(triangles: usize, vertices: usize, distance: f64) -> Self {
        Self {
            distance,
            error: vec![0.0; triangles],
            into: (0..vertices as u32).collect(),
            patches: Patches::default(),
            measured: None,
        }
    }
}

impl Work<'_> {
    /// The bound on the distance of the triangles that would be made; none if it is above the limit.
    pub(super) fn new_error(&mut self, h: u32, at: glam::DVec3) -> Option<f32> {
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
        let total = match &mut limit.measured {
            None if total <= limit.distance => total,
            None => return None,
            Some(measured) => {
                measured.collect(tri, h);
                // What is handed out to the new triangles is known then, measured or not.
                if total <= limit.distance { total } else { measured.distance(&limit.patches.new)? }
            }
        };
        // Rounded up.
        Some((total * (1.0 + 1e-6)) as f32 + f32::MIN_POSITIVE)
    }

    /// Notes that a vertex was merged into another, whose triangles are so far from the input at most.
    pub(super) fn note_merge(&mut self, gone: u32, kept: u32, error: f32) {
        let Some(limit) = &mut self.limit else { return };
        match &mut limit.measured {
            Some(measured) => measured.hand_out(&self.tri, kept),
            None => limit.into[gone as usize] = kept,
        }
        self.tri.around(kept, |out| limit.error[out as usize / 3] = error);
    }
}
