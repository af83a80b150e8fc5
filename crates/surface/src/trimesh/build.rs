//! Making the triangles of a half-edge mesh.

use super::order::counting_sort;
use super::values::push_copy;
use super::{Frame, Renumbering, TriMesh};
use crate::morton;
use glam::Vec3;
use halfedge::attribute::Column;
use halfedge::geometry::PolygonTriangulator;
use halfedge::{Element, FaceId, HalfedgeId, Mesh, NONE, VertexId};

impl TriMesh {
    /// The triangles of a mesh after cutting its polygons, in the order of [`Self::put_in_order`]. Isolated
    /// vertices are dropped.
    pub fn new(mesh: &Mesh) -> Self {
        Self::of(mesh, true)
    }

    /// The same triangles as [`Self::new`] makes, without sources and attributes.
    pub fn bare(mesh: &Mesh) -> Self {
        Self::of(mesh, false)
    }

    fn of(mesh: &Mesh, with_attributes: bool) -> Self {
        let frame = Frame::of(mesh);
        let columns = |element| if with_attributes { mesh.columns().of(element) } else { &[] };
        let all = mesh.positions();
        let used = |v: &u32| mesh.vertex(*v).is_some_and(|v| mesh.halfedge_from(v).is_some());
        let used = (0..mesh.vertex_capacity() as u32).filter(used);
        let order = Renumbering(morton::order(used.map(|v| (v, frame.inward(all[v as usize]).as_vec3()))));
        let mut position: Vec<Vec3> = order.0.iter().map(|&v| all[v as usize]).collect();
        let mut vertex_columns: Vec<Column> =
            columns(Element::Vertex).iter().map(|column| column.gather(order.0.iter().copied())).collect();
        let number = order.new_numbers(mesh.vertex_capacity());
        drop(order);
        let number = |v: VertexId| number[v.index()];

        let (faces, sides) = (mesh.face_count(), mesh.halfedge_count());
        // A polygon has two triangles fewer than sides, unless it gets a vertex in the middle.
        let triangles = sides.saturating_sub(2 * faces);
        let mut v = Vec::with_capacity(3 * triangles);
        // Per half-edge of the mesh: its side here.
        let mut of_side = vec![NONE; mesh.halfedge_capacity()];
        // The mesh's half-edge that leaves the corner of a side, where corners have attributes.
        let corner_columns = columns(Element::Halfedge);
        let mut wedge: Vec<u32> = Vec::new();
        let mut put_corner = |h: HalfedgeId| {
            if !corner_columns.is_empty() {
                wedge.push(h.raw());
            }
        };
        let mut face_source = Vec::with_capacity(triangles);
        let poked = clashing_polygons(mesh);
        let mut cut = PolygonTriangulator::new();
        let mut diagonals: Vec<(u64, u32)> = Vec::new();
        let mut pairs: Vec<(u32, u32)> = Vec::with_capacity(triangles.saturating_sub(faces));
        let in_order = counting_sort(position.len(), || {
            mesh.faces().map(|f| (f.raw(), mesh.face_vertices(f).map(number).min().unwrap_or(0)))
        });
        for f in in_order.into_iter().filter_map(FaceId::from_raw) {
            if poked.binary_search(&f.raw()).is_ok() {
                let first = mesh.halfedge_of(f);
                let middle = position.len() as u32;
                position.push(crate::measure::face_center(mesh, f).as_vec3());
                for column in &mut vertex_columns {
                    push_copy(column, number(mesh.from(first)) as usize);
                }
                let start = v.len() as u32;
                let degree = mesh.face_degree(f) as u32;
                for (i, h) in (0u32..).zip(mesh.face_halfedges(f)) {
                    let at = v.len() as u32;
                    v.extend([number(mesh.from(h)), number(mesh.to(h)), middle]);
                    of_side[h.index()] = at;
                    [h, mesh.next(h), first].into_iter().for_each(&mut put_corner);
                    face_source.push(f.raw());
                    pairs.push((at + 1, start + 3 * ((i + 1) % degree) + 2));
                }
                continue;
            }
            diagonals.clear();
            for triangle in cut.triangulate_face(mesh, f) {
                for k in 0..3 {
                    let (h, after) = (triangle[k], triangle[(k + 1) % 3]);
                    let from = mesh.from(h);
                    if mesh.next(h) == after {
                        of_side[h.index()] = v.len() as u32;
                    } else {
                        let [a, b] = [from, mesh.from(after)].map(|v| u64::from(v.raw()));
                        diagonals.push((a.min(b) << 32 | a.max(b), v.len() as u32));
                    }
                    put_corner(h);
                    v.push(number(from));
                }
                face_source.push(f.raw());
            }
            diagonals.sort_unstable();
            pairs.extend(diagonals.chunks_exact(2).map(|pair| (pair[0].1, pair[1].1)));
        }
        let mut opp = vec![NONE; v.len()];
        for pair in of_side.as_chunks::<2>().0 {
            for (this, other) in [(pair[0], pair[1]), (pair[1], pair[0])] {
                if this != NONE {
                    opp[this as usize] = other;
                }
            }
        }
        for (a, b) in pairs {
            opp[a as usize] = b;
            opp[b as usize] = a;
        }
        let mut edge_source = Vec::new();
        if !columns(Element::Edge).is_empty() {
            edge_source.resize(v.len(), NONE);
            for (side, &h) in (0u32..).zip(&of_side) {
                if h != NONE {
                    edge_source[h as usize] = side / 2;
                }
            }
        }
        drop(of_side);
        let faces = face_source.len();
        if !with_attributes {
            face_source = Vec::new();
        }
        let mut tri = Self {
            out: vec![NONE; position.len()],
            v,
            opp,
            position,
            face_source,
            wedge,
            edge_source,
            corner_columns: Vec::new(),
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
        tri.share_wedges(corner_columns);
        tri
    }

    /// Lets corners around a vertex with the same values share a wedge, and copies the values of each wedge once.
    /// Wedges are indices into `columns` before, and into `corner_columns` after.
    fn share_wedges(&mut self, columns: &[Column]) {
        if self.wedge.is_empty() {
            return;
        }
        let same_values = |a: u32, b: u32| {
            let same = |column: &Column| match [a, b].map(|at| column.values.get(at as usize)) {
                [Some(a), Some(b)] => a.is_identical(b),
                _ => true,
            };
            a == b || columns.iter().all(same)
        };
        for v in 0..self.out.len() as u32 {
            let first = self.out[v as usize];
            if first == NONE {
                continue;
            }
            let mut before = first;
            let mut at = self.turn(first);
            while at != NONE && at != first {
                let (a, b) = (self.wedge[before as usize], self.wedge[at as usize]);
                if same_values(a, b) {
                    self.wedge[at as usize] = a;
                }
                before = at;
                at = self.turn(at);
            }
            // Around an inner vertex, the last may equal the first.
            if at == first && same_values(self.wedge[before as usize], self.wedge[first as usize]) {
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
        let mut place = vec![NONE; self.wedge.iter().max().map_or(0, |&most| most as usize + 1)];
        let mut sources = Vec::new();
        for wedge in &mut self.wedge {
            let place = &mut place[*wedge as usize];
            if *place == NONE {
                *place = sources.len() as u32;
                sources.push(*wedge);
            }
            *wedge = *place;
        }
        drop(place);
        self.corner_columns = columns.iter().map(|column| column.gather(sources.iter().copied())).collect();
    }
}

/// The faces, in order of id, with a diagonal between vertices that another edge or diagonal joins: those get a
/// vertex in the middle instead.
fn clashing_polygons(mesh: &Mesh) -> Vec<u32> {
    let mut cut = PolygonTriangulator::new();
    let mut diagonals: Vec<(u32, u32, u32)> = Vec::new();
    let mut clashing = Vec::new();
    for f in mesh.faces() {
        let h = mesh.halfedge_of(f);
        if mesh.next(mesh.next(h)) == mesh.prev(h) {
            continue;
        }
        for triangle in cut.triangulate_face(mesh, f) {
            for k in 0..3 {
                let (h, after) = (triangle[k], triangle[(k + 1) % 3]);
                if mesh.next(h) == after {
                    continue;
                }
                let (a, b) = (mesh.from(h), mesh.from(after));
                // Both triangles of a diagonal have it; one of them counts.
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
