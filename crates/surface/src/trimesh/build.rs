//! Making the triangles of a mesh.

use super::values::push_copy;
use super::{Frame, TriMesh};
use crate::CornerTriangulator;
use glam::DVec3;
use halfedge::attribute::Value;
use halfedge::{Element, Mesh, NONE};

impl TriMesh {
    /// The triangles of a mesh, its polygons cut. Isolated vertices are not taken over.
    pub fn new(mesh: &Mesh) -> Self {
        let frame = Frame::of(mesh);
        let mut position: Vec<DVec3> = mesh.positions().iter().map(|&p| frame.inward(p)).collect();
        let mut vertex_columns = mesh.columns().of(Element::Vertex).to_vec();
        let count: usize = mesh.halfedge_count();
        let mut v = Vec::with_capacity(count);
        // The mesh's half-edge that a side is, or NONE for a diagonal.
        let mut side: Vec<u32> = Vec::with_capacity(count);
        // The mesh's half-edge that leaves the corner of a side.
        let mut corner: Vec<u32> = Vec::with_capacity(count);
        let mut face_source = Vec::with_capacity(count / 3);
        let poked = clashing_polygons(mesh);
        let mut cut = CornerTriangulator::new();
        let mut diagonals: Vec<(u64, u32)> = Vec::new();
        let mut pairs: Vec<(u32, u32)> = Vec::new();
        for f in mesh.faces() {
            if poked.binary_search(&f.raw()).is_ok() {
                let first = mesh.halfedge_of(f);
                let middle = position.len() as u32;
                let center = crate::measure::face_center(mesh, f);
                position.push((center - frame.center) / frame.scale);
                for column in &mut vertex_columns {
                    push_copy(column, mesh.from(first).index());
                }
                let start = v.len() as u32;
                let degree = mesh.face_degree(f) as u32;
                for (i, h) in (0u32..).zip(mesh.face_halfedges(f)) {
                    let at = v.len() as u32;
                    v.extend([mesh.from(h).raw(), mesh.to(h).raw(), middle]);
                    side.extend([h.raw(), NONE, NONE]);
                    corner.extend([h.raw(), mesh.next(h).raw(), first.raw()]);
                    face_source.push(f.raw());
                    pairs.push((at + 1, start + 3 * ((i + 1) % degree) + 2));
                }
                continue;
            }
            diagonals.clear();
            for triangle in cut.of_face(mesh, f) {
                for k in 0..3 {
                    let (h, after) = (triangle[k], triangle[(k + 1) % 3]);
                    let (from, to) = (mesh.from(h), mesh.from(after));
                    if mesh.next(h) == after {
                        side.push(h.raw());
                    } else {
                        let (a, b) = (u64::from(from.raw()), u64::from(to.raw()));
                        diagonals.push((a.min(b) << 32 | a.max(b), v.len() as u32));
                        side.push(NONE);
                    }
                    corner.push(h.raw());
                    v.push(from.raw());
                }
                face_source.push(f.raw());
            }
            diagonals.sort_unstable();
            pairs.extend(diagonals.chunks_exact(2).map(|pair| (pair[0].1, pair[1].1)));
        }
        let mut opp = vec![NONE; v.len()];
        let mut of_side = vec![NONE; mesh.halfedge_capacity()];
        for (h, &s) in (0u32..).zip(&side) {
            if s != NONE {
                of_side[s as usize] = h;
            }
        }
        for (h, &s) in side.iter().enumerate() {
            if s != NONE {
                opp[h] = of_side[s as usize ^ 1];
            }
        }
        for (a, b) in pairs {
            opp[a as usize] = b;
            opp[b as usize] = a;
        }
        let mut edge_source = Vec::new();
        if !mesh.columns().of(Element::Edge).is_empty() {
            edge_source.extend(side.iter().map(|&s| if s == NONE { NONE } else { s / 2 }));
        }
        let corner_columns = mesh.columns().of(Element::Halfedge).to_vec();
        let wedge = if corner_columns.is_empty() { Vec::new() } else { corner };
        let faces = face_source.len();
        let mut tri = Self {
            out: vec![NONE; position.len()],
            v,
            opp,
            position,
            face_source,
            wedge,
            edge_source,
            corner_columns,
            vertex_columns,
            faces,
            frame,
        };
        for h in 0..tri.v.len() as u32 {
            let out = &mut tri.out[tri.v[h as usize] as usize];
            if *out == NONE || tri.opp[h as usize] == NONE {
                *out = h;
            }
        }
        tri.share_wedges();
        tri
    }

    /// Gives corners around a vertex that have the same values the same wedge.
    fn share_wedges(&mut self) {
        if self.wedge.is_empty() {
            return;
        }
        for v in 0..self.out.len() as u32 {
            let first = self.out[v as usize];
            if first == NONE {
                continue;
            }
            let mut before = first;
            let mut at = self.turn(first);
            while at != NONE && at != first {
                let (a, b) = (self.wedge[before as usize], self.wedge[at as usize]);
                if self.same_values(a, b) {
                    self.wedge[at as usize] = a;
                }
                before = at;
                at = self.turn(at);
            }
            // All the way round, the last may match the first.
            if at == first && self.same_values(self.wedge[before as usize], self.wedge[first as usize]) {
                let (from, to) = (self.wedge[before as usize], self.wedge[first as usize]);
                let mut h = first;
                loop {
                    if self.wedge[h as usize] == from {
                        self.wedge[h as usize] = to;
                    }
                    h = self.turn(h);
                    if h == first {
                        break;
                    }
                }
            }
        }
    }

    fn same_values(&self, a: u32, b: u32) -> bool {
        a == b
            || self.corner_columns.iter().all(|column| {
                match (column.values.get(a as usize), column.values.get(b as usize)) {
                    (Some(a), Some(b)) => same_bits(a, b),
                    _ => true,
                }
            })
    }
}

/// The faces, in order, one of whose diagonals would join vertices that another edge or diagonal
/// already joins: those get a vertex in the middle instead.
fn clashing_polygons(mesh: &Mesh) -> Vec<u32> {
    let mut cut = CornerTriangulator::new();
    let mut diagonals: Vec<(u32, u32, u32)> = Vec::new();
    let mut clashing = Vec::new();
    for f in mesh.faces() {
        let h = mesh.halfedge_of(f);
        if mesh.next(mesh.next(h)) == mesh.prev(h) {
            continue;
        }
        for triangle in cut.of_face(mesh, f) {
            for k in 0..3 {
                let (h, after) = (triangle[k], triangle[(k + 1) % 3]);
                if mesh.next(h) == after {
                    continue;
                }
                let (a, b) = (mesh.from(h), mesh.from(after));
                // Each diagonal is met from both its triangles; once is enough.
                if a < b {
                    diagonals.push((a.raw(), b.raw(), f.raw()));
                    if mesh.find_edge(a, b).is_some() {
                        clashing.push(f.raw());
                    }
                }
            }
        }
    }
    diagonals.sort_unstable();
    for pair in diagonals.windows(2) {
        if (pair[0].0, pair[0].1) == (pair[1].0, pair[1].1) {
            clashing.push(pair[1].2);
        }
    }
    clashing.sort_unstable();
    clashing.dedup();
    clashing
}

fn same_bits(a: Value, b: Value) -> bool {
    match (a, b) {
        (Value::F32(a), Value::F32(b)) => a.to_bits() == b.to_bits(),
        (Value::Vec2(a), Value::Vec2(b)) => a.to_array().map(f32::to_bits) == b.to_array().map(f32::to_bits),
        (Value::Vec3(a), Value::Vec3(b)) => a.to_array().map(f32::to_bits) == b.to_array().map(f32::to_bits),
        (Value::Color(a), Value::Color(b)) => a == b,
        (Value::U32(a), Value::U32(b)) => a == b,
        _ => false,
    }
}
