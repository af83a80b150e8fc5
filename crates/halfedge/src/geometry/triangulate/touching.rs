//! Ears: which corners of a polygon to cut off, one after the other, so that triangles are left.
//!
//! The polygon is seen along its Newell normal. An ear is a corner that turns left, whose triangle lies
//! inside and is entered by no side; any polygon without self-crossings has two, and cutting one off
//! leaves such a polygon. The signed areas of triangles add up to the polygon's: where all that are cut
//! off turn left and the last does too, nothing is covered twice. Where that can't be had this way (the
//! polygon touches or crosses itself, or existing edges forbid the cuts), all triangulations are
//! weighed, which finds one if there is one. Polygons too large for that lose corners without area too,
//! which one that touches itself may need. Meisters 1975; Klincsek 1980.

use glam::{DVec2, DVec3};

/// The most corners for which all triangulations are weighed, at O(n³).
const WEIGHED: usize = 128;

/// A corner to cut off, between its neighbours of that moment: numbers of corners.
pub(crate) type Ear = [usize; 3];

/// The ears of a polygon in the order to cut them: n - 3. `allowed` says which pairs of corners may
/// be joined by a cut. None if there is no way (or, with more than 128 corners, none was found).
/// Costs O(n²), or O(n³) where no more than 128 corners are weighed.
pub(crate) fn ears(corners: &[DVec3], allowed: impl Fn(usize, usize) -> bool) -> Option<Vec<Ear>> {
    let n = corners.len();
    let flat = project(corners);
    let mut clipping = Clipping::new(&flat, 0.0);
    if clipping.cut_ears(&allowed) {
        return Some(clipping.cut);
    }
    if n <= WEIGHED {
        return weigh(&flat, &(0..n).collect::<Vec<_>>(), allowed);
    }
    // In a tilted plane what touches is off by what single precision rounds away.
    let size = corners.iter().map(|p| p.abs().max_element()).fold(0.0, f64::max);
    for slack in [0.0, 2.0 * size * f64::from(f32::EPSILON)] {
        clipping = Clipping::new(&flat, slack);
        if clipping.cut_touching(&allowed) {
            return Some(clipping.cut);
        }
    }
    if clipping.left > 3 {
        let left: Vec<usize> = clipping.corners().collect();
        if left.len() > WEIGHED {
            return None;
        }
        clipping.cut.extend(weigh(&flat, &left, allowed)?);
    }
    Some(clipping.cut)
}

/// The polygon in its plane, counter-clockwise.
fn project(corners: &[DVec3]) -> Vec<DVec2> {
    let base = corners.first().copied().unwrap_or_default();
    let after = corners.iter().skip(1).chain(corners.first());
    let normal: DVec3 = corners.iter().zip(after).map(|(a, b)| (*a - base).cross(*b - base)).sum();
    let normal = normal.try_normalize().unwrap_or(DVec3::Z);
    let (x, y) = normal.any_orthonormal_pair();
    corners.iter().map(|p| DVec2::new((*p - base).dot(x), (*p - base).dot(y))).collect()
}

/// Twice the signed area of a triangle: positive where it turns left.
fn area(a: DVec2, b: DVec2, c: DVec2) -> f64 {
    (b - a).perp_dot(c - a)
}

/// A polygon that corners are being cut off.
struct Clipping<'a> {
    flat: &'a [DVec2],
    /// How far from a line a point counts as on it.
    slack: f64,
    next: Vec<usize>,
    prev: Vec<usize>,
    left: usize,
    /// A corner that is left: where the search goes on.
    at: usize,
    cut: Vec<Ear>,
    /// Corners that are known to be no ears until a neighbour is cut off.
    known: Vec<bool>,
    /// How many more ears may be tried, which bounds the time.
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
            known: vec![false; n],
            tries: 32 * n,
        }
    }

    /// Cuts ears that touch nothing until a triangle is left; whether it came to that and the triangle
    /// is not turned over.
    fn cut_ears(&mut self, allowed: &impl Fn(usize, usize) -> bool) -> bool {
        while self.left > 3 {
            let Some(ear) = self.find(|this, ear| this.is_ear(ear, false) && allowed(ear[0], ear[2])) else {
                return false;
            };
            self.cut_off(ear);
        }
        self.is_done()
    }

    /// Cuts ears that may touch other corners, and corners without area: first of all tips whose sides
    /// lie on each other, without which no side runs along another twice, and last those in a row.
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
            let mut found = self.find(|this, ear| this.is_ear(ear, true) && allowed(ear[0], ear[2]));
            if found.is_none() {
                // What such corners were in the way of is looked at again.
                self.known.fill(false);
                if !std::mem::take(&mut is_stale) {
                    found = self.find(|this, ear| this.is_flat(ear, false) && allowed(ear[0], ear[2]));
                    self.known.fill(false);
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

    /// The next corner that may be cut off.
    fn find(&mut self, mut may: impl FnMut(&mut Self, Ear) -> bool) -> Option<Ear> {
        for _ in 0..self.left {
            let ear = self.ear(self.at);
            if !self.known[self.at] && may(self, ear) {
                return Some(ear);
            }
            self.known[self.at] = true;
            self.at = ear[2];
        }
        None
    }

    fn cut_off(&mut self, ear: Ear) {
        let [before, _, after] = ear;
        self.cut.push(ear);
        self.next[before] = after;
        self.prev[after] = before;
        self.known[before] = false;
        self.known[after] = false;
        self.left -= 1;
        // Not the next corner but the one after: slivers from one corner are avoided.
        self.at = self.next[after];
    }

    fn ear(&self, tip: usize) -> Ear {
        [self.prev[tip], tip, self.next[tip]]
    }

    /// The corners that are left, in order.
    fn corners(&self) -> impl Iterator<Item = usize> {
        std::iter::successors(Some(self.at), |&i| Some(self.next[i])).take(self.left)
    }

    /// Twice the area of a triangle of corners, 0 where it is as good as none.
    fn turn(&self, [a, b, c]: Ear) -> f64 {
        let [a, b, c] = [a, b, c].map(|i| self.flat[i]);
        let turn = area(a, b, c);
        let none = self.slack > 0.0 && turn.abs() <= self.slack * (a.distance(b) + a.distance(c));
        if none { 0.0 } else { turn }
    }

    /// Whether a corner has no area; `tip`: and its sides lie on each other.
    fn is_flat(&self, ear: Ear, tip: bool) -> bool {
        let [a, b, c] = ear.map(|i| self.flat[i]);
        self.turn(ear) == 0.0 && (!tip || (a - b).dot(c - b) >= 0.0)
    }

    /// Whether a corner is an ear; `touching`: even where its triangle touches others.
    fn is_ear(&mut self, ear: Ear, touching: bool) -> bool {
        if self.turn(ear) <= 0.0 || self.tries == 0 {
            return false;
        }
        self.tries -= 1;
        let [a, b, c] = ear;
        // Nearly all of the others lie beyond the cut.
        let from_cut = |p: usize| self.turn([c, a, p]);
        let from_sides = |p: usize| [[a, b, p], [b, c, p]].map(|turn| self.turn(turn));
        let mut of_p = from_cut(self.at);
        for p in self.corners() {
            let q = self.next[p];
            let of_q = from_cut(q);
            // Another corner in the place of one of these is where the polygon touches itself.
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

    /// Whether a side of the polygon that is not all beyond the cut enters a triangle: neither of the
    /// other two sides is between them, nor the line along itself. `ends` is where its ends lie from
    /// those two.
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

/// The triangulation with the least area turned the wrong way, and of those the shortest cuts.
fn weigh(flat: &[DVec2], polygon: &[usize], allowed: impl Fn(usize, usize) -> bool) -> Option<Vec<Ear>> {
    let n = polygon.len();
    let at = |i: usize| flat[polygon[i]];
    let scale: f64 = (0..n).map(|i| at(i).distance_squared(at((i + 1) % n))).sum();
    // cost[i * n + j]: of the part of the polygon from corner i to corner j, and its third corner.
    let mut cost = vec![(f64::INFINITY, 0); n * n];
    for i in 0..n - 1 {
        cost[i * n + i + 1] = (0.0, 0);
    }
    for span in 2..n {
        for i in 0..n - span {
            let j = i + span;
            let is_cut = span < n - 1;
            if is_cut && !allowed(polygon[i], polygon[j]) {
                continue;
            }
            let length = if is_cut { at(i).distance_squared(at(j)) } else { 0.0 };
            for k in i + 1..j {
                let turned = area(at(i), at(k), at(j));
                let wrong = if turned > 0.0 { 0.0 } else { (1e-9 * scale - turned) * 1e6 };
                let total = cost[i * n + k].0 + cost[k * n + j].0 + wrong + length;
                if total < cost[i * n + j].0 {
                    cost[i * n + j] = (total, k);
                }
            }
        }
    }
    if !cost[n - 1].0.is_finite() {
        return None;
    }
    // Inner parts first: each triangle is then an ear of what is left. The last is not cut off.
    let mut ears = Vec::with_capacity(n);
    let mut stack = vec![(0, n - 1)];
    while let Some((i, j)) = stack.pop() {
        if j - i >= 2 {
            let k = cost[i * n + j].1;
            ears.push([polygon[i], polygon[k], polygon[j]]);
            stack.extend([(i, k), (k, j)]);
        }
    }
    ears.reverse();
    ears.pop();
    Some(ears)
}
