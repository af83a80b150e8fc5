//! Ear clipping: cutting corners off one after the other until a triangle is left (Meisters 1975).
//!
//! The polygon is projected along the axis nearest to its normal, which preserves the direction in which
//! corners turn and leaves coordinates unrounded. An ear is a convex corner whose triangle contains no
//! other corner. Any polygon that doesn't touch or cross itself has two ears, and cutting one off leaves
//! such a polygon.

use super::Allowed;
use glam::{DVec2, DVec3, Vec3};

/// The list of concave corners is rebuilt when it is longer than this and half of it has become convex.
const MIN_LISTED_CORNERS: usize = 16;

/// Clips ears, reusing its buffers from one polygon to the next.
#[derive(Clone, Debug, Default)]
pub(super) struct EarClipper {
    flat: Vec<DVec2>,
    next: Vec<u32>,
    prev: Vec<u32>,
    /// Corners that may lie inside an ear: those with an angle of 180 degrees or more, and some that have
    /// become convex.
    concave: Vec<u32>,
    is_concave: Vec<bool>,
}

impl EarClipper {
    /// Cuts a polygon into ears that touch no other corner, with allowed cuts only; returns whether it
    /// succeeded. If so, `triangles` has them in the order of cutting: each as the previous corner, the tip
    /// and the next corner; the last is the remaining triangle. Costs O(corners x concave corners).
    pub(super) fn clip(
        &mut self,
        corners: &[Vec3],
        normal: DVec3,
        allowed: &impl Allowed,
        triangles: &mut Vec<[u32; 3]>,
    ) -> bool {
        self.start(corners, normal);
        triangles.clear();
        let (mut at, mut left, mut refused) = (0, corners.len(), 0);
        while left > 3 {
            if self.turn(at) > 0.0 && self.is_ear(at, false) && allowed(self.before(at), self.after(at)) {
                (at, left, refused) = (self.cut_off(at, triangles), left - 1, 0);
            } else {
                at = self.after(at);
                refused += 1;
                if refused >= left {
                    return false;
                }
            }
        }
        self.push_last(at, triangles);
        self.turn(at) >= 0.0
    }

    /// Cuts any polygon into triangles: ears, which may touch other corners at the position of one of their
    /// own; if there are no ears, convex corners; if there are no convex corners, any.
    pub(super) fn clip_somehow(&mut self, corners: &[Vec3], normal: DVec3, triangles: &mut Vec<[u32; 3]>) {
        self.start(corners, normal);
        triangles.clear();
        let (mut at, mut left, mut refused) = (0, corners.len(), 0);
        while left > 3 {
            let is_ear = self.turn(at) > 0.0 && (refused >= left || self.is_ear(at, true));
            if is_ear || refused >= 2 * left {
                (at, left, refused) = (self.cut_off(at, triangles), left - 1, 0);
            } else {
                at = self.after(at);
                refused += 1;
            }
        }
        self.push_last(at, triangles);
    }

    fn start(&mut self, corners: &[Vec3], normal: DVec3) {
        let count = corners.len() as u32;
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
        self.flat.clear();
        self.flat.extend(corners.iter().map(|p| DVec2::new(f64::from(p[u]), f64::from(p[v]))));
        self.next.clear();
        self.next.extend((0..count).map(|i| if i + 1 == count { 0 } else { i + 1 }));
        self.prev.clear();
        self.prev.extend((0..count).map(|i| if i == 0 { count - 1 } else { i - 1 }));
        self.is_concave.clear();
        self.is_concave.resize(corners.len(), false);
        self.concave.clear();
        for i in 0..count {
            if self.turn(i) <= 0.0 {
                self.is_concave[i as usize] = true;
                self.concave.push(i);
            }
        }
    }

    fn before(&self, i: u32) -> u32 {
        self.prev[i as usize]
    }

    fn after(&self, i: u32) -> u32 {
        self.next[i as usize]
    }

    /// Twice the signed area at a corner; positive if it is convex.
    fn turn(&self, i: u32) -> f64 {
        let [a, b, c] = [self.before(i), i, self.after(i)].map(|k| self.flat[k as usize]);
        (b - a).perp_dot(c - b)
    }

    /// Whether no other corner lies in the triangle at a corner or on its sides; with `touching`, corners
    /// at the position of one of the triangle's own are ignored.
    fn is_ear(&self, i: u32, touching: bool) -> bool {
        let ear = [self.before(i), i, self.after(i)];
        let [a, b, c] = ear.map(|k| self.flat[k as usize]);
        let outside = |p: DVec2| {
            (b - a).perp_dot(p - a) < 0.0 || (c - b).perp_dot(p - b) < 0.0 || (a - c).perp_dot(p - c) < 0.0
        };
        self.concave.iter().all(|&k| {
            let p = self.flat[k as usize];
            let is_own = ear.contains(&k) || (touching && [a, b, c].contains(&p));
            !self.is_concave[k as usize] || is_own || outside(p)
        })
    }

    /// Cuts a corner off; returns where to continue the search.
    fn cut_off(&mut self, tip: u32, triangles: &mut Vec<[u32; 3]>) -> u32 {
        let (before, after) = (self.before(tip), self.after(tip));
        triangles.push([before, tip, after]);
        self.next[before as usize] = after;
        self.prev[after as usize] = before;
        self.is_concave[tip as usize] = false;
        for corner in [before, after] {
            if self.is_concave[corner as usize] && self.turn(corner) > 0.0 {
                self.is_concave[corner as usize] = false;
            }
        }
        if self.concave.len() > MIN_LISTED_CORNERS {
            let is_concave = &self.is_concave;
            let stale = self.concave.iter().filter(|&&i| !is_concave[i as usize]).count();
            if stale * 2 > self.concave.len() {
                self.concave.retain(|&i| is_concave[i as usize]);
            }
        }
        // Skips the neighbour: cutting every second corner gives rounder triangles.
        self.after(after)
    }

    fn push_last(&self, at: u32, triangles: &mut Vec<[u32; 3]>) {
        triangles.push([self.before(at), at, self.after(at)]);
    }
}
