//! The limit on the distance from the input.
//!
//! There are two ways to prove that a collapse keeps the limit: adding a bound on how far it moves the surface
//! ([`super::deviation`]) to the bounds of earlier collapses, which holds for every point but adds up; and
//! measuring ([`super::measurement`]) once the sum exceeds the limit. Measuring takes memory and time, so all
//! collapses that the sum allows are done first.

use super::deviation::{Outline, Patches};
use super::measurement::InputDistance;
use super::work::Work;
use halfedge::NONE;

/// The limit, and the bounds so far.
pub(super) struct Limit {
    /// The limit in the frame of the triangles.
    pub distance: f64,
    /// Per triangle: a bound on its distance from the input, and the input's from it.
    pub error: Vec<f32>,
    /// Per vertex of the input: the one that it was merged into, or itself.
    pub into: Vec<u32>,
    pub patches: Patches,
    /// Measures distances, once the bounds are used up.
    pub measured: Option<InputDistance>,
}

impl Limit {
    /// A limit in the frame, before any collapse.
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
    /// A bound on the distance of the triangles after a collapse; none if it exceeds the limit.
    pub(super) fn bound_error(&mut self, h: u32, at: glam::DVec3) -> Option<f32> {
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
            // The boundary leads to `a` and continues from `b`.
            let (before, after) = (tri.apex(tri.last_around(h)), tri.to(tri.out[b as usize]));
            outline = Some(Outline { old: [before, a, b, after].map(|v| tri.at(v)), ends: [true; 2] });
        } else if tri.is_boundary_vertex(a) || tri.is_boundary_vertex(b) {
            // A preserved boundary vertex stays; otherwise the outline moves with it.
            let v = if tri.is_boundary_vertex(a) { a } else { b };
            let out = tri.out[v as usize];
            let here = tri.at(v);
            outline = Some(Outline {
                old: [tri.at(tri.apex(tri.last_around(out))), here, here, tri.at(tri.to(out))],
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
                // This collects the points for the new triangles, even if nothing is measured.
                if total <= limit.distance { total } else { measured.distance(&limit.patches.new)? }
            }
        };
        // Rounded up.
        Some((total * (1.0 + 1e-6)) as f32 + f32::MIN_POSITIVE)
    }

    /// Records that a vertex was merged into another, and the bound for that one's triangles.
    pub(super) fn note_merge(&mut self, gone: u32, kept: u32, error: f32) {
        let Some(limit) = &mut self.limit else { return };
        match &mut limit.measured {
            Some(measured) => measured.assign_points(&self.tri, kept),
            None => limit.into[gone as usize] = kept,
        }
        self.tri.around(kept, |out| limit.error[out as usize / 3] = error);
    }
}
