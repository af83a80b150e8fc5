//! The three changes of the mesh, and whether they may be made: splits, merges and flips.

use super::curves::Arc;
use super::work::{MIN_TURN_COS, Work, quality};
use crate::trimesh::{Role, make_room, next, prev};
use glam::DVec3;
use halfedge::NONE;

/// The least [`quality`] after a merge, unless it was worse before: a smallest angle of 10 degrees.
const MIN_MERGE_QUALITY: f64 = 0.03;
/// The least quality after a flip, unless it was worse before, which later moves can improve: 3 degrees.
const MIN_FLIP_QUALITY: f64 = 0.003;

/// A merge of an edge's ends at a point: `edge` leaves the vertex that stays.
#[derive(Clone, Copy)]
pub(super) struct Merge {
    pub edge: u32,
    pub at: DVec3,
}

impl Work {
    /// Walks from an edge to longer edges of its triangles, up to one that is the longest of both its triangles.
    /// Splitting that one first keeps triangles from becoming ever thinner (Rivara 1984).
    pub fn longest_near(&self, h: u32) -> u32 {
        let (mut best, mut length) = (h, self.length_squared(h));
        loop {
            let at = best;
            for side in [at, self.tri.opp(at)] {
                if side == NONE {
                    continue;
                }
                for other in [next(side), prev(side)] {
                    let squared = self.length_squared(other);
                    if squared > length {
                        (best, length) = (other, squared);
                    }
                }
            }
            if best == at {
                return best;
            }
        }
    }

    /// Whether an edge may be split. Its two apexes must differ, or two edges would join the new vertex to one apex. Its
    /// middle, rounded to floats, must shorten both halves: far from the origin there may be no float between the ends,
    /// and splitting would never end.
    pub fn can_split(&self, h: u32) -> bool {
        let across = self.tri.opp(h);
        if across != NONE && self.tri.apex(h) == self.tri.apex(across) {
            return false;
        }
        let (p, q) = (self.tri.at(self.tri.from(h)), self.tri.at(self.tri.to(h)));
        let middle = self.tri.frame.inward(self.tri.frame.outward((p + q) * 0.5));
        let length = p.distance_squared(q);
        middle.distance_squared(p) < length && middle.distance_squared(q) < length
    }

    /// Splits an edge in the middle; `h` becomes the half before the middle. The new vertex isn't projected yet, so
    /// that each half is shorter; on a curve it is the middle of that piece of the curve.
    pub fn split(&mut self, h: u32) {
        let across = self.tri.opp(h);
        let arc = self.arc.get(h);
        // A vertex on a curve doesn't tell on which side of it the edge lies; the triangle does.
        let free =
            [self.tri.from(h), self.tri.to(h)].into_iter().find(|&v| self.roles[v as usize] == Role::Free);
        let near = free.map_or(self.tri.face_source[h as usize / 3], |v| self.near[v as usize]);
        let m = self.tri.split(h);
        make_room(&mut self.near, 1);
        self.near.push(near);
        make_room(&mut self.stamps, 1);
        self.stamps.push(0);
        make_room(&mut self.roles, 1);
        self.arc.extend_to(self.tri.v.len() / 3);
        self.unordered += 2;
        let mut second = [NONE; 2];
        for (side, slot) in [h, across].into_iter().zip(&mut second) {
            if side != NONE {
                // The cut replaced the side after `side`, which belongs to the new triangle now.
                let cut = next(side);
                *slot = next(self.tri.opp(cut));
                self.arc.set(next(*slot), self.arc.get(cut));
                self.arc.set(cut, NONE);
            }
        }
        if arc == NONE {
            self.roles.push(Role::Free);
            return;
        }
        self.roles.push(Role::Curve);
        let (number, backward) = (arc / 2, arc % 2);
        let Arc { curve, ends } = self.arcs[number as usize];
        let middle = 0.5 * (ends[0] + ends[1]);
        let added = self.arcs.len() as u32;
        self.arcs.push(Arc { curve, ends });
        self.arcs[added as usize].ends[backward as usize] = middle;
        self.arcs[number as usize].ends[1 - backward as usize] = middle;
        self.arc.set(second[0], 2 * added + backward);
        if across != NONE {
            self.arc.set(across, 2 * added + (1 - backward));
            self.arc.set(second[1], 2 * number + (1 - backward));
        }
        let at = self.curves.at(curve, middle);
        if self.may_move(m, at) {
            self.tri.slide(m, at);
        }
    }

    /// The merges of an edge's ends that kept curves allow: a vertex on a curve may only move along it, to either
    /// end. Free vertices merge at a point on the input.
    pub fn merges_of(&self, h: u32) -> impl Iterator<Item = Merge> + use<> {
        let (a, b) = (self.tri.from(h), self.tri.to(h));
        let (p, q) = (self.tri.at(a), self.tri.at(b));
        let to_start = Some(Merge { edge: h, at: p });
        let to_end = Some(Merge { edge: h, at: q });
        let merges = match (self.roles[a as usize], self.roles[b as usize]) {
            (Role::Free, Role::Free) => [Some(Merge { edge: h, at: self.project(a, (p + q) * 0.5).0 }), None],
            (_, Role::Free) => [to_start, None],
            (Role::Free, _) => [Some(Merge { edge: self.tri.opp(h), at: q }), None],
            _ if !self.is_kept(h) => [None, None],
            (Role::Curve, Role::Curve) => [to_start, to_end],
            (Role::Fixed, Role::Curve) => [to_start, None],
            (Role::Curve, Role::Fixed) => [to_end, None],
            (Role::Fixed, Role::Fixed) => [None, None],
        };
        merges.into_iter().flatten()
    }

    /// Whether the ends of an edge may merge: that keeps the topology, makes no edge longer than the square root of
    /// `longest`, turns no triangle too far and makes none too thin.
    pub fn can_merge(&mut self, merge: Merge, longest: f64) -> bool {
        self.stamp += 1;
        self.tri.can_collapse(merge.edge, &mut self.stamps, self.stamp)
            && self.keeps_triangles_good(merge, longest)
    }

    /// Merges the ends of an edge. [`Work::can_merge`] must have allowed it.
    pub fn merge(&mut self, Merge { edge: h, at }: Merge) {
        let (a, b, across) = (self.tri.from(h), self.tri.to(h), self.tri.opp(h));
        let q = self.tri.at(b);
        if self.is_kept(h) {
            let [place_a, place_b] = self.places(h);
            let to_b = self.roles[a as usize] == Role::Curve && at == q;
            let (mover, by) = if to_b { (a, place_b - place_a) } else { (b, place_a - place_b) };
            // This also moves the end of the merged edge, which is removed.
            self.slide(mover, by);
            if to_b {
                self.roles[a as usize] = self.roles[b as usize];
            }
        }
        for side in [h, across] {
            if side == NONE {
                continue;
            }
            let (left, right) = (self.tri.opp(next(side)), self.tri.opp(prev(side)));
            // `left` leads from the apex to the end that is removed, `right` from that end back.
            let arc = match (self.arc.get(next(side)), self.arc.get(prev(side))) {
                (NONE, NONE) => continue,
                (NONE, to_end) => to_end,
                (from_end, _) => from_end ^ 1,
            };
            if left != NONE {
                self.arc.set(left, arc);
            }
            if right != NONE {
                self.arc.set(right, arc ^ 1);
            }
        }
        self.tri.collapse_to(h, at);
    }

    /// Whether all edges and triangles stay good in a merge.
    fn keeps_triangles_good(&self, Merge { edge: h, at }: Merge, longest: f64) -> bool {
        let tri = &self.tri;
        // Two kept edges next to the merged one must not become one.
        for side in [h, tri.opp(h)] {
            if side != NONE && self.is_kept(next(side)) && self.is_kept(prev(side)) {
                return false;
            }
        }
        let (a, b) = (tri.from(h), tri.to(h));
        let mut good = true;
        for (v, other) in [(a, b), (b, a)] {
            let here = tri.at(v);
            tri.around(v, |out| {
                let (x, y) = (tri.to(out), tri.apex(out));
                if !good {
                    return;
                }
                let (p, q) = (tri.at(x), tri.at(y));
                if x != other {
                    good = p.distance_squared(at) <= longest;
                }
                if y != other && tri.turn(out) == NONE {
                    good &= q.distance_squared(at) <= longest;
                }
                if x == other || y == other {
                    return;
                }
                let old = (p - here).cross(q - here);
                let new = (p - at).cross(q - at);
                let turned = new.dot(old);
                good &= (turned > 0.0
                    && turned * turned
                        > MIN_TURN_COS * MIN_TURN_COS * new.length_squared() * old.length_squared())
                    || (old == DVec3::ZERO && new != DVec3::ZERO);
                if good {
                    let shape = quality(at, p, q);
                    good = shape > MIN_MERGE_QUALITY || shape > quality(here, p, q);
                }
            });
        }
        good
    }

    /// Whether an edge has a poor triangle, and better ones after a flip.
    pub fn is_better_flipped(&self, h: u32) -> bool {
        let [a, b, c] = [self.tri.from(h), self.tri.to(h), self.tri.apex(h)].map(|v| self.tri.at(v));
        let d = self.tri.at(self.tri.apex(self.tri.opp(h)));
        let now = quality(a, b, c).min(quality(b, a, d));
        now < MIN_MERGE_QUALITY && quality(a, d, c).min(quality(d, b, c)) > now
    }

    /// Whether an edge may be flipped: it isn't kept, its apexes aren't joined, and no triangle turns too far or
    /// becomes a sliver.
    pub fn can_flip(&self, h: u32) -> bool {
        let across = self.tri.opp(h);
        if across == NONE || self.is_kept(h) {
            return false;
        }
        let (a, b) = (self.tri.from(h), self.tri.to(h));
        let (c, d) = (self.tri.apex(h), self.tri.apex(across));
        let mut joined = c == d;
        self.tri.neighbors(c, |w| joined |= w == d);
        if joined {
            return false;
        }
        let [a, b, c, d] = [a, b, c, d].map(|v| self.tri.at(v));
        let normal = (b - a).cross(c - a) + (d - a).cross(b - a);
        let faces = |t: DVec3| {
            let along = t.dot(normal);
            along > 0.0
                && along * along > MIN_TURN_COS * MIN_TURN_COS * t.length_squared() * normal.length_squared()
        };
        if !(faces((a - c).cross(d - c)) && faces((d - c).cross(b - c))) {
            return false;
        }
        let shape = quality(a, d, c).min(quality(d, b, c));
        shape > MIN_FLIP_QUALITY || shape > quality(a, b, c).min(quality(b, a, d))
    }

    /// Flips an edge, so that it joins its apexes.
    pub fn flip(&mut self, h: u32) {
        let across = self.tri.opp(h);
        let sides = [next(h), prev(h), next(across), prev(across)].map(|k| self.arc.get(k));
        self.tri.flip(h);
        // After `TriMesh::flip` h's triangle has the sides p and m, the other one q and n.
        for (k, arc) in
            [(next(h), sides[1]), (prev(h), sides[2]), (next(across), sides[3]), (prev(across), sides[0])]
        {
            self.arc.set(k, arc);
        }
    }
}
