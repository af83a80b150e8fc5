//! Ears of polygons that touch or cross themselves.
//!
//! The polygon is projected along its normal. An ear is a convex corner whose triangle lies inside and is
//! entered by no side; any polygon that doesn't cross itself has two, and cutting one off leaves such a
//! polygon. The signed areas of the triangles add up to the polygon's, so if all ears turn left and the
//! last triangle does too, nothing is covered twice (Meisters 1975). If this fails (the polygon crosses
//! itself, or existing edges forbid the cuts), all triangulations are compared, which finds one if there is
//! one. Polygons too large for that may also lose corners without area, which one that touches itself may
//! need.

use super::Allowed;
use super::optimal::{MAX_OPTIMAL_CORNERS, find_optimal_triangles};
use glam::{DVec2, DVec3, Vec3};

/// The most tests of corners against ears, which bounds the time for a huge polygon.
const MAX_CORNER_TESTS: usize = 1 << 28;

/// A corner to cut off, between its current neighbours, as indices of corners.
type Ear = [usize; 3];

/// The triangles of a polygon of more than three corners: the ears in the order of cutting, then the
/// remaining triangle. None if there is no way, or none was found for more than 128 corners. Costs O(n²),
/// or O(n³) if the triangulations of up to 128 corners are compared.
pub(super) fn find_triangles(
    corners: &[Vec3],
    normal: DVec3,
    allowed: &impl Allowed,
) -> Option<Vec<[u32; 3]>> {
    let allowed = |i: usize, j: usize| allowed(i as u32, j as u32);
    let ears = find_ears(corners, normal, allowed)?;
    let mut is_left = vec![true; corners.len()];
    ears.iter().for_each(|&[_, tip, _]| is_left[tip] = false);
    let mut left = (0..corners.len()).filter(|&i| is_left[i]);
    let last = [left.next()?, left.next()?, left.next()?];
    Some(ears.into_iter().chain([last]).map(|triangle| triangle.map(|i| i as u32)).collect())
}

fn find_ears(corners: &[Vec3], normal: DVec3, allowed: impl Fn(usize, usize) -> bool) -> Option<Vec<Ear>> {
    let n = corners.len();
    let flat = project(corners, normal);
    let mut clipping = Clipping::new(&flat, 0.0);
    if clipping.cut_ears(&allowed) {
        return Some(clipping.cut);
    }
    if n <= MAX_OPTIMAL_CORNERS {
        return find_optimal_triangles(&flat, &(0..n).collect::<Vec<_>>(), allowed);
    }
    // In a tilted plane, touching points are apart by the rounding of single precision.
    let size = corners.iter().map(|p| p.as_dvec3().abs().max_element()).fold(0.0, f64::max);
    for slack in [0.0, 2.0 * size * f64::from(f32::EPSILON)] {
        clipping = Clipping::new(&flat, slack);
        if clipping.cut_touching(&allowed) {
            return Some(clipping.cut);
        }
    }
    if clipping.left > 3 {
        let left: Vec<usize> = clipping.corners().collect();
        if left.len() > MAX_OPTIMAL_CORNERS {
            return None;
        }
        clipping.cut.extend(find_optimal_triangles(&flat, &left, allowed)?);
    }
    Some(clipping.cut)
}

/// The polygon projected onto its plane, counter-clockwise.
fn project(corners: &[Vec3], normal: DVec3) -> Vec<DVec2> {
    let base = corners.first().map_or(DVec3::ZERO, |p| p.as_dvec3());
    let (x, y) = normal.try_normalize().unwrap_or(DVec3::Z).any_orthonormal_pair();
    corners.iter().map(|p| p.as_dvec3() - base).map(|p| DVec2::new(p.dot(x), p.dot(y))).collect()
}

/// Twice the signed area of a triangle; positive if it turns left.
pub(super) fn area(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

/// A polygon from which corners are being cut off.
struct Clipping<'a> {
    flat: &'a [DVec2],
    /// The distance from a line within which a point counts as on it.
    slack: f64,
    next: Vec<usize>,
    prev: Vec<usize>,
    left: usize,
    /// A remaining corner, where the search continues.
    at: usize,
    cut: Vec<Ear>,
    /// Corners that were tested and are not ears until a neighbour is cut off.
    rejected: Vec<bool>,
    /// The number of ears that may still be tested.
    tries: usize,
}

impl<'a> Clipping<'a> {
    fn new(flat: &'a [DVec2], slack: f64) -> Self {
        let n = flat.len();
        Self {
            flat,
            slack,
            next: (1..n).chain([0]).collect(),
            prev: (0..n).map(|i| (i + n - 1) % n).collect(),
            left: n,
            at: 0,
            cut: Vec::with_capacity(n),
            rejected: vec![false; n],
            tries: (32 * n).min(MAX_CORNER_TESTS / n.max(1)),
        }
    }

    /// Cuts ears that touch other corners only at the positions of their own, until a triangle is left;
    /// returns whether it succeeded and the triangle is not reversed.
    fn cut_ears(&mut self, allowed: &impl Fn(usize, usize) -> bool) -> bool {
        while self.left > 3 {
            let Some(ear) = self.find_ear(|this, ear| this.is_ear(ear, false) && allowed(ear[0], ear[2]))
            else {
                return false;
            };
            self.cut_off(ear);
        }
        self.is_done()
    }

    /// Cuts ears that may touch other corners, and corners without area: first those whose sides lie on
    /// each other, so that no side runs along another twice, and last those in a straight line.
    fn cut_touching(&mut self, allowed: &impl Fn(usize, usize) -> bool) -> bool {
        let mut tips: Vec<usize> = self.corners().collect();
        let mut is_stale = false;
        while self.left > 3 {
            if let Some(tip) = tips.pop() {
                let ear = self.ear(tip);
                let is_there = self.next[ear[0]] == tip;
                if is_there && self.is_flat(ear, true) && allowed(ear[0], ear[2]) {
                    self.cut_off(ear);
                    tips.extend([ear[0], ear[2]]);
                    is_stale = true;
                }
                continue;
            }
            let mut found = self.find_ear(|this, ear| this.is_ear(ear, true) && allowed(ear[0], ear[2]));
            if found.is_none() {
                // Corners that were rejected because of the cut tips are tested again.
                self.rejected.fill(false);
                if !std::mem::take(&mut is_stale) {
                    found = self.find_ear(|this, ear| this.is_flat(ear, false) && allowed(ear[0], ear[2]));
                    self.rejected.fill(false);
                    if found.is_none() {
                        return false;
                    }
                }
            }
            if let Some(ear) = found {
                self.cut_off(ear);
                tips.extend([ear[0], ear[2]]);
            }
        }
        self.is_done()
    }

    fn is_done(&self) -> bool {
        self.left <= 3 && (self.left < 3 || self.turn(self.ear(self.at)) >= 0.0)
    }

    /// The next corner that may be cut off, according to `may`.
    fn find_ear(&mut self, mut may: impl FnMut(&mut Self, Ear) -> bool) -> Option<Ear> {
        for _ in 0..self.left {
            let ear = self.ear(self.at);
            if !self.rejected[self.at] && may(self, ear) {
                return Some(ear);
            }
            self.rejected[self.at] = true;
            self.at = ear[2];
        }
        None
    }

    fn cut_off(&mut self, ear: Ear) {
        let [before, _, after] = ear;
        self.cut.push(ear);
        self.next[before] = after;
        self.prev[after] = before;
        self.rejected[before] = false;
        self.rejected[after] = false;
        self.left -= 1;
        // Skips the neighbour: cutting every second corner gives rounder triangles.
        self.at = self.next[after];
    }

    fn ear(&self, tip: usize) -> Ear {
        [self.prev[tip], tip, self.next[tip]]
    }

    /// The remaining corners, in order.
    fn corners(&self) -> impl Iterator<Item = usize> {
        std::iter::successors(Some(self.at), |&i| Some(self.next[i])).take(self.left)
    }

    /// Twice the signed area of a triangle of corners; 0 if it is within rounding error.
    fn turn(&self, [a, b, c]: Ear) -> f64 {
        let [a, b, c] = [a, b, c].map(|i| self.flat[i]);
        let turn = area(a, b, c);
        let is_rounding = self.slack > 0.0 && turn.abs() <= self.slack * (a.distance(b) + a.distance(c));
        if is_rounding { 0.0 } else { turn }
    }

    /// Whether a corner has no area; with `tip`, its sides must also lie on each other.
    fn is_flat(&self, ear: Ear, tip: bool) -> bool {
        let [a, b, c] = ear.map(|i| self.flat[i]);
        self.turn(ear) == 0.0 && (!tip || (a - b).dot(c - b) >= 0.0)
    }

    /// Whether a corner is an ear; with `touching`, even if its triangle touches other corners.
    fn is_ear(&mut self, ear: Ear, touching: bool) -> bool {
        if self.turn(ear) <= 0.0 || self.tries == 0 {
            return false;
        }
        self.tries -= 1;
        let [a, b, c] = ear;
        // Nearly all other corners lie beyond the cut.
        let from_cut = |p: usize| self.turn([c, a, p]);
        let from_sides = |p: usize| [[a, b, p], [b, c, p]].map(|turn| self.turn(turn));
        let mut of_p = from_cut(self.at);
        for p in self.corners() {
            let q = self.next[p];
            let of_q = from_cut(q);
            // If the polygon touches itself, another corner may be at the position of one of these.
            let is_own = || ear.into_iter().any(|i| i == p || self.flat[i] == self.flat[p]);
            if !touching && of_p >= 0.0 && from_sides(p).iter().all(|&d| d >= 0.0) && !is_own() {
                return false;
            }
            if (of_p > 0.0 || of_q > 0.0) && self.enters([p, q], ear, [from_sides(p), from_sides(q)]) {
                return false;
            }
            of_p = of_q;
        }
        self.is_inside(ear)
    }

    /// Whether a side of the polygon that isn't wholly beyond the cut enters an ear's triangle: it does
    /// unless one of the ear's two sides, or the line along the polygon's side, separates them. `ends`
    /// gives the positions of the side's ends relative to the ear's two sides.
    fn enters(&self, [p, q]: [usize; 2], ear: Ear, ends: [[f64; 2]; 2]) -> bool {
        if (0..2).any(|side| ends[0][side] <= 0.0 && ends[1][side] <= 0.0) {
            return false;
        }
        let corners = ear.map(|i| self.turn([p, q, i]));
        corners.iter().any(|&d| d > 0.0) && corners.iter().any(|&d| d < 0.0)
    }

    /// Whether the middle of a triangle that no side enters lies inside: the polygon winds round it.
    fn is_inside(&self, ear: Ear) -> bool {
        let [a, b, c] = ear.map(|i| self.flat[i]);
        let middle = a + ((b - a) + (c - a)) / 3.0;
        let turns = self.corners().map(|i| {
            let (p, q) = (self.flat[i], self.flat[self.next[i]]);
            let (above_p, above_q) = (p.y > middle.y, q.y > middle.y);
            let side = area(p, q, middle);
            i32::from(!above_p && above_q && side > 0.0) - i32::from(above_p && !above_q && side < 0.0)
        });
        turns.sum::<i32>() > 0
    }
}
