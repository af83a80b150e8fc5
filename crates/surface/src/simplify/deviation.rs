//! An upper bound on how far a collapse moves the surface, from the patches before and after.
//!
//! Both patches fill the same ring. Seen along their common normal, each is a graph over the same polygon, and
//! the height between two piecewise linear graphs is largest at a corner of their overlay: a vertex of either,
//! or a crossing of their edges. Each point of one patch has a point of the other straight above or below it,
//! so that this height bounds the distance in both directions. If a patch folds over and is no graph, the
//! distance that the merged vertices travel is a bound too.

use crate::face_tree::along_segment;
use crate::trimesh::area_vector;
use glam::{DVec2, DVec3};

/// The triangles around an edge before and after a collapse. Its memory is reused from one collapse to the next.
#[derive(Default)]
pub(super) struct Patches {
    /// The triangles with either end of the edge, starting with that end.
    pub old: Vec<[DVec3; 3]>,
    /// The triangles after the collapse, starting with the new vertex.
    pub new: Vec<[DVec3; 3]>,
    old_flat: Vec<[Flat; 3]>,
    new_flat: Vec<[Flat; 3]>,
}

/// A point projected along the normal.
#[derive(Clone, Copy)]
struct Flat {
    at: DVec2,
    height: f64,
}

/// The boundary at the edge.
pub(super) struct Outline {
    /// The boundary before the collapse, from the neighbour before the edge to the one after it.
    pub old: [DVec3; 4],
    /// Whether the edge's start and end are on the boundary.
    pub ends: [bool; 2],
}

impl Patches {
    pub fn clear(&mut self) {
        self.old.clear();
        self.new.clear();
    }

    /// A bound on the distance between the patches if the ends `a` and `b` both move to `p`. On the boundary the
    /// patches' outlines differ too.
    pub fn bound(&mut self, a: DVec3, b: DVec3, p: DVec3, outline: Option<&Outline>) -> f64 {
        let travel = p.distance(a).max(p.distance(b));
        let Some(height) = self.height(a, b, p, outline) else { return travel };
        let rim = outline.map_or(0.0, |outline| outline.bound(p));
        travel.min(height + 2.0 * rim)
    }

    fn height(&mut self, a: DVec3, b: DVec3, p: DVec3, outline: Option<&Outline>) -> Option<f64> {
        let sum: DVec3 = self.old.iter().chain(&self.new).map(area_vector).sum();
        let normal = sum.try_normalize()?;
        let graph = |t: &[DVec3; 3]| area_vector(t).dot(normal) >= 0.05 * area_vector(t).length();
        if !self.old.iter().chain(&self.new).all(graph) {
            return None;
        }
        let (u, v) = normal.any_orthonormal_pair();
        let flat = |q: DVec3| {
            let r = q - p;
            Flat { at: DVec2::new(u.dot(r), v.dot(r)), height: normal.dot(r) }
        };
        self.old_flat.clear();
        self.old_flat.extend(self.old.iter().map(|t| t.map(flat)));
        self.new_flat.clear();
        self.new_flat.extend(self.new.iter().map(|t| t.map(flat)));
        let mut worst = 0.0f64;
        let (open, rim) = (outline.is_some(), outline.map_or([false; 2], |outline| outline.ends));
        for (point, patch, on_rim) in [
            (flat(a), &self.new_flat, rim[0]),
            (flat(b), &self.new_flat, rim[1]),
            (flat(p), &self.old_flat, open),
        ] {
            match height_over(patch, point.at) {
                Some(height) => worst = worst.max((height - point.height).abs()),
                // Outside the other patch, within the bound for the outline, which the caller adds.
                None if on_rim => {}
                None => return None,
            }
        }
        for old in &self.old_flat {
            for (i, j) in [(0, 1), (1, 2), (2, 0)] {
                for new in &self.new_flat {
                    // In a closed fan, each inner edge is the first side of one triangle.
                    if let Some(height) = crossing(old[i], old[j], new[0], new[1]) {
                        worst = worst.max(height);
                    }
                    if open && let Some(height) = crossing(old[i], old[j], new[0], new[2]) {
                        worst = worst.max(height);
                    }
                }
            }
        }
        Some(worst)
    }
}

impl Outline {
    fn bound(&self, p: DVec3) -> f64 {
        let [x, a, b, y] = self.old;
        let to_new = |q: DVec3| distance(q, x, p).min(distance(q, p, y));
        let to_old = distance(p, x, a).min(distance(p, a, b)).min(distance(p, b, y));
        to_new(a).max(to_new(b)).max(to_old)
    }
}

/// The distance from a point to a segment.
fn distance(q: DVec3, from: DVec3, to: DVec3) -> f64 {
    q.distance(from + (to - from) * along_segment(from, to, q))
}

/// The height of a patch at a point, if the patch covers it.
fn height_over(patch: &[[Flat; 3]], point: DVec2) -> Option<f64> {
    for [a, b, c] in patch {
        let weights = [
            (c.at - b.at).perp_dot(point - b.at),
            (a.at - c.at).perp_dot(point - c.at),
            (b.at - a.at).perp_dot(point - a.at),
        ];
        let sum = weights[0] + weights[1] + weights[2];
        if sum > 0.0 && weights.iter().all(|&w| w >= -1e-9 * sum) {
            return Some((weights[0] * a.height + weights[1] * b.height + weights[2] * c.height) / sum);
        }
    }
    None
}

/// The height between two edges at their crossing, if they cross.
fn crossing(a: Flat, b: Flat, c: Flat, d: Flat) -> Option<f64> {
    let (r, s) = (b.at - a.at, d.at - c.at);
    let det = r.perp_dot(s);
    if det == 0.0 {
        return None;
    }
    let t = (c.at - a.at).perp_dot(s) / det;
    let u = (c.at - a.at).perp_dot(r) / det;
    let within = -1e-9..=1.0 + 1e-9;
    if !within.contains(&t) || !within.contains(&u) {
        return None;
    }
    Some((a.height + (b.height - a.height) * t - c.height - (d.height - c.height) * u).abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Triangles from a middle to a ring of six.
    fn fan(middle: DVec3) -> Vec<[DVec3; 3]> {
        let ring: Vec<DVec3> = (0..6)
            .map(|i| {
                let (sin, cos) = crate::trig::sin_cos_turns(f64::from(i) / 6.0);
                DVec3::new(cos, sin, 0.0)
            })
            .collect();
        (0..6).map(|i| [middle, ring[i], ring[(i + 1) % 6]]).collect()
    }

    #[test]
    fn a_tip_that_comes_down_moves_the_surface_by_its_height() {
        let tip = DVec3::new(0.1, 0.0, 0.25);
        let mut patches = Patches { old: fan(tip), new: fan(DVec3::ZERO), ..Patches::default() };
        let bound = patches.bound(tip, tip, DVec3::ZERO, None);
        assert!((bound - 0.25).abs() < 1e-12, "{bound}");
    }

    #[test]
    fn sliding_in_a_plane_moves_nothing() {
        let from = DVec3::new(0.3, 0.2, 0.0);
        let mut patches = Patches { old: fan(from), new: fan(DVec3::ZERO), ..Patches::default() };
        assert!(patches.bound(from, from, DVec3::ZERO, None) < 1e-12);
    }
}
