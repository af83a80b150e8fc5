//! Faces joined along their sides: the last stage of building a mesh.

use crate::NONE;
use crate::geometry::BitSet;
use crate::mesh::RawMesh;
use glam::Vec3;

/// Faces whose matching sides are joined.
pub(crate) struct Assembly {
    /// The next of a face's half-edges; [`NONE`] for boundary half-edges until the end. Likewise `prev`.
    pub next: Vec<u32>,
    pub prev: Vec<u32>,
    pub to: Vec<u32>,
    pub face: Vec<u32>,
    pub face_halfedge: Vec<u32>,
    /// Per corner, its half-edge.
    pub corner_halfedge: Vec<u32>,
}

impl Assembly {
    pub(crate) fn with_capacity(faces: usize, corners: usize) -> Self {
        // A closed mesh has half as many edges as corners; boundaries add a few.
        let halfedges = corners + corners / 16 + 16;
        Self {
            next: Vec::with_capacity(halfedges),
            prev: Vec::with_capacity(halfedges),
            to: Vec::with_capacity(halfedges),
            face: Vec::with_capacity(halfedges),
            face_halfedge: Vec::with_capacity(faces),
            corner_halfedge: Vec::with_capacity(corners),
        }
    }

    /// Adds an edge whose even half-edge goes from `from` to `to`; returns that half-edge.
    #[inline]
    pub(crate) fn push_edge(&mut self, from: u32, to: u32) -> u32 {
        let h = self.to.len() as u32;
        self.to.push(to);
        self.to.push(from);
        self.face.push(NONE);
        self.face.push(NONE);
        self.next.push(NONE);
        self.next.push(NONE);
        self.prev.push(NONE);
        self.prev.push(NONE);
        h
    }

    #[inline]
    pub(crate) fn link(&mut self, h: u32, next: u32) {
        self.next[h as usize] = next;
        self.prev[next as usize] = h;
    }

    /// Links the half-edges in `corner_halfedge` from this corner on into a face.
    #[inline]
    pub(crate) fn close_face(&mut self, first_corner: usize) {
        let f = self.face_halfedge.len() as u32;
        let first = self.corner_halfedge[first_corner];
        let mut before = self.corner_halfedge[self.corner_halfedge.len() - 1];
        for corner in first_corner..self.corner_halfedge.len() {
            let h = self.corner_halfedge[corner];
            self.face[h as usize] = f;
            self.link(before, h);
            before = h;
        }
        self.face_halfedge.push(first);
    }

    /// Links the boundary loops, sets the vertices' half-edges, and separates vertices with several fans of
    /// faces: each fan but the first gets a copy at the end. Returns the columns, the original of each copy,
    /// and the half-edge of each corner.
    pub(crate) fn finish(mut self, positions: Vec<Vec3>) -> (RawMesh, Vec<u32>, Vec<u32>) {
        let halfedges = self.to.len();
        for h in 0..halfedges as u32 {
            if self.face[h as usize] != NONE {
                continue;
            }
            // Around the vertex that `h` points to, the next half-edge without a face.
            let mut out = h ^ 1;
            loop {
                out = self.prev[out as usize] ^ 1;
                if self.face[out as usize] == NONE {
                    break;
                }
            }
            self.link(h, out);
        }
        let (vertex_halfedge, several_fans) = self.first_fans(positions.len());
        let mut positions = positions;
        let mut vertex_halfedge = vertex_halfedge;
        let split = self.separate_fans(&several_fans, &mut positions, &mut vertex_halfedge);
        let raw = RawMesh {
            positions,
            vertex_halfedge,
            next: self.next,
            prev: self.prev,
            to: self.to,
            face: self.face,
            face_halfedge: self.face_halfedge,
            columns: Default::default(),
        };
        (raw, split, self.corner_halfedge)
    }

    /// Per vertex a half-edge that leaves it, a boundary one of its first fan if there is one; and the vertices
    /// with several fans.
    fn first_fans(&self, vertices: usize) -> (Vec<u32>, BitSet) {
        let mut halfedge = vec![NONE; vertices];
        let mut leaving = vec![0u32; vertices];
        for (edge, ends) in self.to.as_chunks::<2>().0.iter().enumerate() {
            for (side, from) in [(0, ends[1] as usize), (1, ends[0] as usize)] {
                leaving[from] += 1;
                if halfedge[from] == NONE {
                    halfedge[from] = (edge * 2 + side) as u32;
                }
            }
        }
        let mut several = BitSet::default();
        for (v, first) in halfedge.iter_mut().enumerate() {
            let start = *first;
            if start == NONE {
                continue;
            }
            let mut out = start;
            let mut met = 0;
            loop {
                met += 1;
                if self.face[out as usize] == NONE {
                    *first = out;
                }
                out = self.next[out as usize ^ 1];
                if out == start {
                    break;
                }
            }
            if met < leaving[v] {
                several.insert(v);
            }
        }
        (halfedge, several)
    }

    /// Gives each fan but the first of these vertices a copy of the vertex, in order of the fans' first
    /// half-edges; returns the original of each copy.
    fn separate_fans(
        &mut self,
        several: &BitSet,
        positions: &mut Vec<Vec3>,
        vertex_halfedge: &mut Vec<u32>,
    ) -> Vec<u32> {
        let mut split = Vec::new();
        if several.is_empty() {
            return split;
        }
        let mut seen = BitSet::default();
        let mut has_first = BitSet::default();
        for h in 0..self.to.len() as u32 {
            let v = self.to[h as usize ^ 1];
            if seen.contains(h as usize) || !several.contains(v as usize) {
                continue;
            }
            let mut first = h;
            let mut out = h;
            loop {
                seen.insert(out as usize);
                if self.face[out as usize] == NONE {
                    first = out;
                }
                out = self.next[out as usize ^ 1];
                if out == h {
                    break;
                }
            }
            if !has_first.contains(v as usize) {
                has_first.insert(v as usize);
                continue;
            }
            let copy = positions.len() as u32;
            positions.push(positions[v as usize]);
            vertex_halfedge.push(first);
            split.push(v);
            loop {
                self.to[out as usize ^ 1] = copy;
                out = self.next[out as usize ^ 1];
                if out == h {
                    break;
                }
            }
        }
        split
    }
}
