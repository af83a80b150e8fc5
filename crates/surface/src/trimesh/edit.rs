//! Collapse, split and flip.

use super::values::{mix_into, push_copy};
use super::{TriMesh, make_room, next, prev};
use halfedge::NONE;

impl TriMesh {
    /// Whether collapsing an edge keeps a manifold of the same topology: the common neighbours of its ends are the
    /// apexes of its triangles (the link condition; Dey, Edelsbrunner et al. 1999), no apex loses its last
    /// triangle, and no two triangles end up back to back. `stamps` has a number per vertex; `stamp` is one that
    /// wasn't used before.
    pub fn can_collapse(&self, h: u32, stamps: &mut [u32], stamp: u32) -> bool {
        let (a, b, across) = (self.from(h), self.to(h), self.opp(h));
        let open = across == NONE;
        if !open && self.is_boundary_vertex(a) && self.is_boundary_vertex(b) {
            return false;
        }
        for side in [h, across] {
            if side == NONE {
                continue;
            }
            let (left, right) = (self.opp(next(side)), self.opp(prev(side)));
            if left == NONE && right == NONE {
                return false;
            }
            // An apex of three triangles would keep two, back to back.
            if left != NONE && right != NONE && self.opp(prev(left)) == next(right) {
                return false;
            }
        }
        self.neighbors(a, |w| stamps[w as usize] = stamp);
        let mut common = 0;
        self.neighbors(b, |w| common += usize::from(stamps[w as usize] == stamp));
        common == if open { 1 } else { 2 }
    }

    /// Merges the end of an edge into its start, which keeps its position, and removes the triangles of the edge.
    /// Attributes are interpolated at `t` between the two.
    pub fn collapse(&mut self, h: u32, t: f64) {
        let (a, b, across) = (self.from(h), self.to(h), self.opp(h));
        self.merge_attributes(h, t);
        let first = self.out[b as usize];
        let mut at = first;
        while at != NONE {
            self.v[at as usize] = a;
            at = self.turn(at);
            if at == first {
                break;
            }
        }
        self.out[b as usize] = NONE;
        let mut leaving = NONE;
        for side in [h, across] {
            if side == NONE {
                continue;
            }
            let (n, p) = (next(side), prev(side));
            let apex = self.v[p as usize];
            let (left, right) = (self.opp(n), self.opp(p));
            for (this, other) in [(left, right), (right, left)] {
                if this != NONE {
                    self.opp[this as usize] = other;
                }
            }
            if !self.edge_source.is_empty() && left != NONE && right != NONE {
                let source = self.edge_source[left as usize].min(self.edge_source[right as usize]);
                self.edge_source[left as usize] = source;
                self.edge_source[right as usize] = source;
            }
            for k in [side, n, p] {
                self.v[k as usize] = NONE;
            }
            self.faces -= 1;
            // At least one of the two outer sides exists: the left one leaves the apex, the right one the merged
            // vertex.
            self.set_out(apex, if left != NONE { left } else { next(right) });
            leaving = if right != NONE { right } else { next(left) };
        }
        self.set_out(a, leaving);
    }

    /// Splits an edge and its triangles in the middle. On each side the edge's half-edge becomes the half before
    /// the middle, and the side after it the cut; the new triangle has the half after the middle, the old side
    /// after it, and the cut, in this order. Returns the new vertex, which is the last one.
    pub fn split(&mut self, h: u32) -> u32 {
        let (a, b, across) = (self.from(h), self.to(h), self.opp(h));
        let m = self.position.len() as u32;
        make_room(&mut self.position, 1);
        make_room(&mut self.out, 1);
        self.position.push(self.frame.outward((self.at(a) + self.at(b)) * 0.5));
        self.out.push(NONE);
        for column in &mut self.vertex_columns {
            push_copy(column, a as usize);
            mix_into(column, m as usize, b as usize, 0.5);
        }
        let mut second = [NONE; 2];
        let mut wedges = (NONE, NONE, NONE);
        for (side, slot) in [h, across].into_iter().zip(&mut second) {
            if side == NONE {
                continue;
            }
            let (n, p) = (next(side), prev(side));
            let (end, apex) = (self.from(n), self.from(p));
            let first = self.v.len() as u32;
            let outer = self.opp(n);
            for corners in [&mut self.v, &mut self.opp] {
                make_room(corners, 3);
            }
            make_room(&mut self.face_source, 1);
            self.v.extend([m, end, apex]);
            self.opp.extend([NONE, outer, n]);
            if outer != NONE {
                self.opp[outer as usize] = first + 1;
            }
            self.opp[n as usize] = first + 2;
            self.v[n as usize] = m;
            self.face_source.push(self.face_source[side as usize / 3]);
            if !self.edge_source.is_empty() {
                let (edge, after) = (self.edge_source[side as usize], self.edge_source[n as usize]);
                make_room(&mut self.edge_source, 3);
                self.edge_source.extend([edge, after, NONE]);
                self.edge_source[n as usize] = NONE;
            }
            if !self.wedge.is_empty() {
                let (from, to) = (self.wedge[side as usize], self.wedge[n as usize]);
                // The middle has the same values on the other side where the ends do.
                if (wedges.0, wedges.1) != (to, from) {
                    wedges = (from, to, self.new_wedge(from, to));
                }
                make_room(&mut self.wedge, 3);
                self.wedge.extend([wedges.2, to, self.wedge[p as usize]]);
                self.wedge[n as usize] = wedges.2;
            }
            if self.out[end as usize] == n {
                self.out[end as usize] = first + 1;
            }
            *slot = first;
            self.faces += 1;
        }
        self.opp[second[0] as usize] = across;
        if across != NONE {
            self.opp[across as usize] = second[0];
            self.opp[second[1] as usize] = h;
            self.opp[h as usize] = second[1];
        }
        self.out[m as usize] = second[0];
        m
    }

    /// A new wedge with the values halfway between two.
    fn new_wedge(&mut self, from: u32, to: u32) -> u32 {
        let mut place = 0;
        for column in &mut self.corner_columns {
            place = column.values.len();
            push_copy(column, from as usize);
            mix_into(column, place, to as usize, 0.5);
        }
        place as u32
    }

    /// Flips an edge with two triangles, so that it joins their apexes. The half-edge then goes from the apex across
    /// to its own; its triangle's last side and the first one after the twin follow it.
    pub fn flip(&mut self, h: u32) {
        let t = self.opp(h);
        let (n, p, m, q) = (next(h), prev(h), next(t), prev(t));
        let (a, b, c, d) = (self.from(h), self.from(t), self.from(p), self.from(q));
        let moved = |old: [u32; 4], column: &[u32]| {
            let [at_n, at_p, at_m, at_q] = old.map(|k| column[k as usize]);
            [at_p, at_m, at_q, at_n]
        };
        let across = moved([n, p, m, q], &self.opp);
        for (k, outer) in [n, p, m, q].into_iter().zip(across) {
            self.opp[k as usize] = outer;
            if outer != NONE {
                self.opp[outer as usize] = k;
            }
        }
        if !self.edge_source.is_empty() {
            let sources = moved([n, p, m, q], &self.edge_source);
            for (k, source) in [n, p, m, q].into_iter().zip(sources) {
                self.edge_source[k as usize] = source;
            }
            self.edge_source[h as usize] = NONE;
            self.edge_source[t as usize] = NONE;
        }
        if !self.wedge.is_empty() {
            let [at_a, at_b, at_c, at_d] = [h, n, p, q].map(|k| self.wedge[k as usize]);
            for (k, wedge) in [(h, at_d), (n, at_c), (p, at_a), (t, at_c), (m, at_d), (q, at_b)] {
                self.wedge[k as usize] = wedge;
            }
        }
        for (k, v) in [(h, d), (n, c), (p, a), (t, c), (m, d), (q, b)] {
            self.v[k as usize] = v;
        }
        for (v, k) in [(a, p), (b, q), (c, n), (d, m)] {
            if [h, n, p, t, m, q].contains(&self.out[v as usize]) {
                self.set_out(v, k);
            }
        }
    }

    /// Sets `v`'s half-edge: the last clockwise from `h`, which is on the boundary if there is one.
    fn set_out(&mut self, v: u32, h: u32) {
        let mut at = h;
        loop {
            let across = self.opp(at);
            if across == NONE {
                break;
            }
            at = next(across);
            if at == h {
                break;
            }
        }
        self.out[v as usize] = at;
    }

    fn merge_attributes(&mut self, h: u32, t: f64) {
        let (a, b, across) = (self.from(h), self.to(h), self.opp(h));
        let t = t as f32;
        for column in &mut self.vertex_columns {
            mix_into(column, a as usize, b as usize, t);
        }
        if self.wedge.is_empty() {
            return;
        }
        let mut merged = [(NONE, NONE); 2];
        for (side, slot) in [h, across].into_iter().zip(&mut merged) {
            if side == NONE {
                continue;
            }
            let (at_a, at_b) = if side == h { (side, next(side)) } else { (next(side), side) };
            *slot = (self.wedge[at_a as usize], self.wedge[at_b as usize]);
        }
        if merged[1] == merged[0] {
            merged[1] = (NONE, NONE);
        }
        for (to, from) in merged {
            if to == NONE {
                continue;
            }
            for column in &mut self.corner_columns {
                mix_into(column, to as usize, from as usize, t);
            }
            let first = self.out[b as usize];
            let mut at = first;
            while at != NONE {
                if self.wedge[at as usize] == from {
                    self.wedge[at as usize] = to;
                }
                at = self.turn(at);
                if at == first {
                    break;
                }
            }
        }
    }
}
