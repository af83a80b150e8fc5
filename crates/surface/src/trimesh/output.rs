//! Writing the result as a half-edge mesh.

use super::{TriMesh, next, prev};
use halfedge::attribute::{Column, Columns, keys};
use halfedge::{Element, Mesh, NONE, RawMesh};

impl TriMesh {
    /// The half-edge mesh: vertices and faces in their order here, without gaps, with the attributes of `source`.
    /// Columns are freed as soon as they are written, since both meshes together are large.
    pub fn into_mesh(mut self, source: &Mesh) -> Mesh {
        let mut number = vec![NONE; self.out.len()];
        let mut kept = Vec::new();
        for (v, &out) in (0u32..).zip(&self.out) {
            if out != NONE {
                number[v as usize] = kept.len() as u32;
                kept.push(v);
            }
        }
        let positions = kept.iter().map(|&v| self.position[v as usize]).collect();
        self.position = Vec::new();
        let mut half = vec![NONE; self.v.len()];
        let mut edges = 0u32;
        for h in 0..self.v.len() as u32 {
            let across = self.opp(h);
            if self.is_alive(h) && (across == NONE || h < across) {
                half[h as usize] = 2 * edges;
                if across != NONE {
                    half[across as usize] = 2 * edges + 1;
                }
                edges += 1;
            }
        }
        let len = 2 * edges as usize;
        let mut raw = RawMesh {
            positions,
            vertex_halfedge: vec![NONE; kept.len()],
            next: vec![NONE; len],
            prev: vec![NONE; len],
            to: vec![NONE; len],
            face: vec![NONE; len],
            face_halfedge: Vec::with_capacity(self.faces),
            columns: Columns::default(),
        };
        let has_attributes = !source.columns().of(Element::Face).is_empty();
        let mut faces = Vec::with_capacity(if has_attributes { self.faces } else { 0 });
        let mut corner = if self.wedge.is_empty() { Vec::new() } else { vec![NONE; len] };
        let mut edge = if self.edge_source.is_empty() { Vec::new() } else { vec![NONE; edges as usize] };
        for f in 0..self.v.len() / 3 {
            let first = 3 * f as u32;
            if !self.is_alive(first) {
                continue;
            }
            let id = raw.face_halfedge.len() as u32;
            raw.face_halfedge.push(half[first as usize]);
            if has_attributes {
                faces.push(self.face_source[f]);
            }
            for h in first..first + 3 {
                let at = half[h as usize] as usize;
                raw.next[at] = half[next(h) as usize];
                raw.prev[at] = half[prev(h) as usize];
                raw.to[at] = number[self.to(h) as usize];
                raw.face[at] = id;
                if !corner.is_empty() {
                    corner[at] = self.wedge[h as usize];
                }
                if !edge.is_empty() {
                    edge[at / 2] = edge[at / 2].min(self.edge_source[h as usize]);
                }
                if self.opp(h) == NONE {
                    raw.to[at ^ 1] = number[self.from(h) as usize];
                    // The boundary continues at the other end of the fan around the vertex that `h` leaves.
                    let after = half[prev(self.last_around(h)) as usize] ^ 1;
                    raw.next[at ^ 1] = after;
                    raw.prev[after as usize] = at as u32 ^ 1;
                }
            }
        }
        drop(number);
        for (v, &old) in kept.iter().enumerate() {
            let out = self.out[old as usize];
            raw.vertex_halfedge[v] = if self.opp(out) == NONE {
                // The boundary half-edge that leaves is the twin of the side that comes in.
                half[prev(self.last_around(out)) as usize] ^ 1
            } else {
                half[out as usize]
            };
        }
        let put = |columns: &mut Columns, element: Element, from: &[Column], indices: &[u32]| {
            // Positions have moved: corner normals no longer fit.
            let fits =
                |column: &&Column| element != Element::Halfedge || column.name != keys::CORNER_NORMAL.name;
            columns
                .of_mut(element)
                .extend(from.iter().filter(fits).map(|column| column.gather(indices.iter().copied())));
        };
        put(&mut raw.columns, Element::Vertex, &self.vertex_columns, &kept);
        put(&mut raw.columns, Element::Halfedge, &self.corner_columns, &corner);
        put(&mut raw.columns, Element::Edge, source.columns().of(Element::Edge), &edge);
        put(&mut raw.columns, Element::Face, source.columns().of(Element::Face), &faces);
        Mesh::from_raw(raw)
    }
}
