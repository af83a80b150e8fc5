//! The mesh being worked on, and its three changes: split, collapse and flip, with the curves kept.

use super::curves::{Arc, Curves, Role};
use super::side_numbers::Sides;
use crate::trimesh::{Order, TriMesh, make_room, next, prev, with_room};
use glam::DVec3;
use halfedge::{Element, Mesh, NONE};

/// How far a triangle's normal may turn in a collapse or flip: acos of this.
const LEAST_COS: f64 = 0.5;

/// The least [`quality`] that a merge may leave: a smallest angle of 10 degrees.
const POOR: f64 = 0.03;
/// The least that a flip may leave, which later moves can mend: one of 3 degrees.
const THIN: f64 = 0.003;
/// With the usual limits, 4/3 and 4/5 of the length, edges come out a little longer than it on average;
/// with limits smaller by this factor, as long as asked for.
const EVEN: f64 = 0.97;

pub(super) struct Work {
    /// Its triangles' sources are triangles of the input.
    pub tri: TriMesh,
    pub curves: Curves,
    /// The input to put vertices back on, if they are.
    input: Option<TriMesh>,
    /// Per triangle of the input: its face of the mesh. Empty where faces have no attributes.
    face: Vec<u32>,
    /// Per half-edge and per kept edge, as in [`super::curves::Found`].
    pub arc: Sides,
    pub arcs: Vec<Arc>,
    /// Per vertex.
    pub roles: Vec<Role>,
    /// Per vertex: the triangle of the input it was last closest to.
    pub near: Vec<u32>,
    pub stamps: Vec<u32>,
    pub stamp: u32,
    /// Squares of the longest and the shortest edge to leave alone, in the frame.
    pub longest: f64,
    pub shortest: f64,
    /// How many triangles have been made since the arrays were last put in order.
    pub unordered: usize,
    /// How many edges were flipped last for their poor triangles alone.
    pub slivers: usize,
}

/// The square of the sine of the smallest angle, which lies across from the shortest side: 3/4 at best.
#[inline]
pub(super) fn quality(a: DVec3, b: DVec3, c: DVec3) -> f64 {
    let area = (b - a).cross(c - a).length_squared();
    let (x, y, z) = (a.distance_squared(b), b.distance_squared(c), c.distance_squared(a));
    let shortest = x.min(y).min(z);
    // The product of the two longer ones, without the shortest.
    let longer = if shortest == x {
        y * z
    } else if shortest == y {
        x * z
    } else {
        x * y
    };
    if longer > 0.0 { area / longer } else { 0.0 }
}

/// Where an edge's ends would merge: `edge` leaves the vertex that stays.
#[derive(Clone, Copy)]
pub(super) struct Merge {
    pub edge: u32,
    pub at: DVec3,
}

impl Work {
    /// Ready to start; `length` is that of edges, in the frame.
    pub fn new(mesh: &Mesh, mut tri: TriMesh, length: f64, least_cos: f64, project: bool) -> Self {
        let square = |x: f64| x * x;
        let longest = square(EVEN * length * 4.0 / 3.0);
        // Arrays that grow in turn leave holes in memory: there is room for the first splits at once, and
        // for a few more, as longer edges nearby are split before.
        let splits = (0..tri.v.len() as u32)
            .filter(|&h| h < tri.opp(h) && tri.at(tri.from(h)).distance_squared(tri.at(tri.to(h))) > longest);
        let splits = splits.count() * 17 / 16;
        let found = Curves::find(mesh, &tri, least_cos, length);
        let own = (0..tri.face_source.len() as u32).collect();
        let mut face = std::mem::replace(&mut tri.face_source, own);
        if mesh.columns().of(Element::Face).is_empty() {
            face = Vec::new();
        }
        tri.make_room(splits);
        Self {
            near: with_room(tri.out.iter().map(|out| out / 3), splits),
            input: project.then(|| tri.bare_copy()),
            face,
            curves: found.curves,
            arc: found.arc,
            arcs: found.arcs,
            roles: found.roles,
            stamps: with_room(tri.out.iter().map(|_| 0), splits),
            stamp: 0,
            longest,
            shortest: square(EVEN * length * 4.0 / 5.0),
            unordered: 0,
            slivers: usize::MAX,
            tri,
        }
    }

    /// The triangles; everything else goes, to make room for the result.
    pub fn finish(self) -> TriMesh {
        let Self { mut tri, face, .. } = self;
        if face.is_empty() {
            tri.face_source = Vec::new();
        }
        for source in &mut tri.face_source {
            *source = face[*source as usize];
        }
        tri
    }

    /// Puts what belongs together in space together in memory again, without what was removed.
    pub fn put_in_order(&mut self) {
        self.stamps = Vec::new();
        let Order { vertices, triangles } = self.tri.put_in_order();
        vertices.apply(&mut self.roles);
        vertices.apply(&mut self.near);
        self.stamps = vec![0; vertices.len()];
        self.stamp = 0;
        self.arc.reorder(&triangles);
        self.unordered = 0;
    }

    #[inline]
    pub fn is_kept(&self, h: u32) -> bool {
        self.arc.get(h) != NONE
    }

    #[inline]
    pub fn length_squared(&self, h: u32) -> f64 {
        self.tri.at(self.tri.from(h)).distance_squared(self.tri.at(self.tri.to(h)))
    }

    /// The places on its curve of a kept half-edge's start and end.
    pub fn places(&self, h: u32) -> [f64; 2] {
        let arc = self.arc.get(h);
        let [a, b] = self.arcs[arc as usize / 2].ends;
        if arc.is_multiple_of(2) { [a, b] } else { [b, a] }
    }

    /// Sets the place of a kept half-edge's start.
    fn set_start(&mut self, h: u32, place: f64) {
        let arc = self.arc.get(h);
        self.arcs[arc as usize / 2].ends[arc as usize % 2] = place;
    }

    fn set_end(&mut self, h: u32, place: f64) {
        let arc = self.arc.get(h);
        self.arcs[arc as usize / 2].ends[1 - arc as usize % 2] = place;
    }

    /// The kept half-edges at a vertex, the first two of them; those that come in where none leaves.
    pub fn kept_at(&self, v: u32) -> [u32; 2] {
        let (mut pair, mut count) = ([NONE; 2], 0);
        let mut put = |h: u32| {
            if let Some(slot) = pair.get_mut(count) {
                *slot = h;
            }
            count += 1;
        };
        self.tri.around(v, |out| {
            if self.is_kept(out) {
                put(out);
            }
            // On the boundary the last edge has a half-edge that comes in, and none that leaves.
            if self.tri.turn(out) == NONE {
                put(prev(out));
            }
        });
        pair
    }

    /// The point at a place on a kept half-edge's curve.
    pub fn curve_point(&self, h: u32, place: f64) -> DVec3 {
        self.curves.at(self.arcs[self.arc.get(h) as usize / 2].curve, place)
    }

    /// Notes that a vertex on a curve has moved along it.
    pub fn slide(&mut self, v: u32, by: f64) {
        for h in self.kept_at(v) {
            if h != NONE {
                let [place, _] = self.places_from(v, h);
                self.set_place(v, h, place + by);
            }
        }
    }

    /// The place at `v`, one of its ends, of a kept half-edge, and that of the other end.
    pub fn places_from(&self, v: u32, h: u32) -> [f64; 2] {
        let [a, b] = self.places(h);
        if self.tri.from(h) == v { [a, b] } else { [b, a] }
    }

    /// Moves the end of a kept half-edge that is at `v`.
    fn set_place(&mut self, v: u32, h: u32, place: f64) {
        if self.tri.from(h) == v { self.set_start(h, place) } else { self.set_end(h, place) }
    }

    /// From an edge on to longer ones of its triangles, up to one that is the longest of both. Cutting
    /// that one first keeps triangles from becoming ever thinner (Rivara 1984).
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

    /// Cuts an edge in the middle. `h` becomes the half before the middle. That is where it was, not yet
    /// on the input, so that each half is shorter; on a curve it is the middle of that piece of it.
    pub fn split(&mut self, h: u32) {
        let across = self.tri.opp(h);
        let arc = self.arc.get(h);
        // A vertex on a curve says nothing about the side of it that the edge is on; the triangle does.
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
                // The cut took the place of the side after, which went to the new triangle.
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
            self.tri.put(m, at);
        }
    }

    /// The point of the input for a point near a vertex, with its triangle.
    pub fn put_on(&self, v: u32, p: DVec3) -> (DVec3, u32) {
        let near = self.near[v as usize];
        match &self.input {
            Some(input) => {
                let foot = input.closest(near, p);
                (foot.at, foot.face)
            }
            None => (p, near),
        }
    }

    /// Whether no triangle of a vertex turns over when it moves.
    pub fn may_move(&self, v: u32, to: DVec3) -> bool {
        let tri = &self.tri;
        let here = tri.at(v);
        let mut good = true;
        tri.around(v, |out| {
            let (x, y) = (tri.at(tri.to(out)), tri.at(tri.apex(out)));
            let (old, new) = ((x - here).cross(y - here), (x - to).cross(y - to));
            good &= new.dot(old) > 0.0 || old == DVec3::ZERO;
        });
        good
    }

    /// The end of an edge that is not `v`.
    pub fn other_end(&self, v: u32, h: u32) -> u32 {
        if self.tri.from(h) == v { self.tri.to(h) } else { self.tri.from(h) }
    }

    /// How the ends of an edge may merge as far as kept curves go: what is on one may only move along it,
    /// to either end. Free vertices merge on the input.
    pub fn merges_of(&self, h: u32) -> impl Iterator<Item = Merge> + use<> {
        let (a, b) = (self.tri.from(h), self.tri.to(h));
        let (p, q) = (self.tri.at(a), self.tri.at(b));
        let to_start = Some(Merge { edge: h, at: p });
        let to_end = Some(Merge { edge: h, at: q });
        let merges = match (self.roles[a as usize], self.roles[b as usize]) {
            (Role::Free, Role::Free) => [Some(Merge { edge: h, at: self.put_on(a, (p + q) * 0.5).0 }), None],
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

    /// Whether the ends of an edge may merge: that keeps the topology, makes no edge longer than the
    /// square root of `longest` and turns no triangle too far.
    pub fn can_merge(&mut self, merge: Merge, longest: f64) -> bool {
        self.stamp += 1;
        self.tri.can_collapse(merge.edge, &mut self.stamps, self.stamp) && self.allows(merge, longest)
    }

    /// Merges the ends of an edge, which [`Work::can_merge`] allows.
    pub fn merge(&mut self, Merge { edge: h, at }: Merge) {
        let (a, b, across) = (self.tri.from(h), self.tri.to(h), self.tri.opp(h));
        let (p, q) = (self.tri.at(a), self.tri.at(b));
        if self.is_kept(h) {
            let [place_a, place_b] = self.places(h);
            let to_b = self.roles[a as usize] == Role::Curve && at == q;
            let (mover, by) = if to_b { (a, place_b - place_a) } else { (b, place_a - place_b) };
            // This also moves the merged edge's own end, which goes.
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
            // `left` goes from the apex to the end that is merged, `right` from the merged end back.
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
        let t = if at == p { 0.0 } else { (at - p).length() / (q - p).length() };
        self.tri.collapse(h, t.min(1.0));
        self.tri.put(a, at);
    }

    /// Whether merging an edge's ends leaves all edges and triangles good.
    fn allows(&self, Merge { edge: h, at }: Merge, longest: f64) -> bool {
        let tri = &self.tri;
        // A kept edge beside the merged one must not land on another one.
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
                    && turned * turned > LEAST_COS * LEAST_COS * new.length_squared() * old.length_squared())
                    || (old == DVec3::ZERO && new != DVec3::ZERO);
                if good {
                    let shape = quality(at, p, q);
                    good = shape > POOR || shape > quality(here, p, q);
                }
            });
        }
        good
    }

    /// Whether an edge has a poor triangle, and better ones if it is flipped.
    pub fn is_better_flipped(&self, h: u32) -> bool {
        let [a, b, c] = [self.tri.from(h), self.tri.to(h), self.tri.apex(h)].map(|v| self.tri.at(v));
        let d = self.tri.at(self.tri.apex(self.tri.opp(h)));
        let now = quality(a, b, c).min(quality(b, a, d));
        now < POOR && quality(a, d, c).min(quality(d, b, c)) > now
    }

    /// Whether an edge may be turned to its apexes: it is not kept, they are not joined yet, and no
    /// triangle would face elsewhere or become a sliver that none was.
    pub fn can_flip(&self, h: u32) -> bool {
        let across = self.tri.opp(h);
        if across == NONE || self.is_kept(h) {
            return false;
        }
        let (a, b) = (self.tri.from(h), self.tri.to(h));
        let (c, d) = (self.tri.apex(h), self.tri.apex(across));
        let mut joined = false;
        self.tri.neighbors(c, |w| joined |= w == d);
        if joined {
            return false;
        }
        let [a, b, c, d] = [a, b, c, d].map(|v| self.tri.at(v));
        let normal = (b - a).cross(c - a) + (d - a).cross(b - a);
        let faces = |t: DVec3| {
            let along = t.dot(normal);
            along > 0.0
                && along * along > LEAST_COS * LEAST_COS * t.length_squared() * normal.length_squared()
        };
        if !(faces((a - c).cross(d - c)) && faces((d - c).cross(b - c))) {
            return false;
        }
        let shape = quality(a, d, c).min(quality(d, b, c));
        shape > THIN || shape > quality(a, b, c).min(quality(b, a, d))
    }

    /// Turns an edge to its apexes.
    pub fn flip(&mut self, h: u32) {
        let across = self.tri.opp(h);
        let sides = [next(h), prev(h), next(across), prev(across)].map(|k| self.arc.get(k));
        self.tri.flip(h);
        // `TriMesh::flip`: h's triangle has the sides p and m after it, the other q and n.
        for (k, arc) in
            [(next(h), sides[1]), (prev(h), sides[2]), (next(across), sides[3]), (prev(across), sides[0])]
        {
            self.arc.set(k, arc);
        }
    }
}
