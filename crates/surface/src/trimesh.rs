//! The compact triangle structure that simplifying and remeshing work on.
//!
//! Half-edge `3f + k` is the `k`-th side of triangle `f` and leaves its `k`-th corner, so a triangle is
//! three vertices and three half-edges across, 24 bytes, and nothing else needs storing. The mesh is
//! written back at the end in one pass.

use crate::CornerTriangulator;
use glam::DVec3;
use halfedge::attribute::{Column, Columns, Value, keys, mix};
use halfedge::{Element, Mesh, NONE, RawMesh};

/// The next side of the same triangle.
#[inline]
pub(crate) fn next(h: u32) -> u32 {
    if h % 3 == 2 { h - 2 } else { h + 1 }
}

/// The previous side of the same triangle.
#[inline]
pub(crate) fn prev(h: u32) -> u32 {
    if h.is_multiple_of(3) { h + 2 } else { h - 1 }
}

/// Triangles with what lies across their sides, and where their attributes come from.
pub(crate) struct TriMesh {
    /// Per half-edge: the vertex it leaves; [`NONE`] for removed triangles.
    pub v: Vec<u32>,
    /// Per half-edge: the one across the edge, or [`NONE`] on the boundary.
    pub opp: Vec<u32>,
    /// Per vertex: a half-edge leaving it, the boundary one if there is one; [`NONE`] if it has no face.
    pub out: Vec<u32>,
    /// Per vertex: its position in the frame of [`Frame`].
    pub position: Vec<DVec3>,
    /// Per triangle: the face it comes from.
    pub face_source: Vec<u32>,
    /// Per half-edge: the place of its corner's values in `corner_columns`; equal values around a
    /// vertex share one. Empty where the mesh has no corner attributes.
    pub wedge: Vec<u32>,
    /// Per half-edge: the edge it comes from, or [`NONE`]. Empty where edges have no attributes.
    pub edge_source: Vec<u32>,
    /// Values by `wedge`.
    pub corner_columns: Vec<Column>,
    /// Values by vertex.
    pub vertex_columns: Vec<Column>,
    /// How many triangles there are.
    pub faces: usize,
    pub frame: Frame,
}

/// Coordinates around zero and about one in size, so that sums of squares keep their digits. Only
/// shifts by a float and scales by a power of two: positions that don't change come back as they were.
#[derive(Clone, Copy)]
pub(crate) struct Frame {
    center: DVec3,
    /// Mesh units per unit of the frame.
    pub scale: f64,
}

impl Frame {
    fn of(mesh: &Mesh) -> Self {
        let bounds = crate::measure::bounding_box(mesh);
        let (center, size) = bounds.map_or((DVec3::ZERO, 1.0), |b| (b.center().as_dvec3(), b.diagonal()));
        let mut scale = 1.0f64;
        while scale < size && scale < 1e300 {
            scale *= 2.0;
        }
        while scale > 2.0 * size && size > 0.0 {
            scale *= 0.5;
        }
        Self { center, scale }
    }

    pub fn inward(&self, p: glam::Vec3) -> DVec3 {
        (p.as_dvec3() - self.center) / self.scale
    }

    pub fn outward(&self, p: DVec3) -> glam::Vec3 {
        (p * self.scale + self.center).as_vec3()
    }
}

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

    #[inline]
    pub fn from(&self, h: u32) -> u32 {
        self.v[h as usize]
    }

    #[inline]
    pub fn to(&self, h: u32) -> u32 {
        self.v[next(h) as usize]
    }

    /// The vertex across from a side in its triangle.
    #[inline]
    pub fn apex(&self, h: u32) -> u32 {
        self.v[prev(h) as usize]
    }

    #[inline]
    pub fn opp(&self, h: u32) -> u32 {
        self.opp[h as usize]
    }

    #[inline]
    pub fn at(&self, v: u32) -> DVec3 {
        self.position[v as usize]
    }

    /// The next half-edge leaving the same vertex, counter-clockwise; [`NONE`] past the last of a
    /// boundary vertex.
    #[inline]
    pub fn turn(&self, h: u32) -> u32 {
        self.opp(prev(h))
    }

    /// Whether the triangle of a half-edge still exists.
    #[inline]
    pub fn is_alive(&self, h: u32) -> bool {
        self.v[h as usize] != NONE
    }

    #[inline]
    pub fn is_boundary_vertex(&self, v: u32) -> bool {
        let out = self.out[v as usize];
        out != NONE && self.opp(out) == NONE
    }

    /// The name of an edge: the smaller of its half-edges.
    #[inline]
    pub fn edge(&self, h: u32) -> u32 {
        h.min(self.opp(h))
    }

    /// Calls `visit` with each half-edge leaving a vertex, counter-clockwise. An edge on the boundary
    /// whose half-edge comes in has none that leaves: it is `prev` of the last.
    #[inline]
    pub fn around(&self, v: u32, mut visit: impl FnMut(u32)) {
        let first = self.out[v as usize];
        let mut h = first;
        while h != NONE {
            visit(h);
            h = self.turn(h);
            if h == first {
                break;
            }
        }
    }

    /// Calls `visit` with each neighbour of a vertex.
    #[inline]
    pub fn neighbors(&self, v: u32, mut visit: impl FnMut(u32)) {
        self.around(v, |h| {
            visit(self.to(h));
            if self.turn(h) == NONE {
                visit(self.apex(h));
            }
        });
    }

    /// Whether an edge's corner values differ across it, at either end.
    pub fn is_seam(&self, h: u32) -> bool {
        let across = self.opp(h);
        !self.wedge.is_empty()
            && across != NONE
            && (self.wedge[h as usize] != self.wedge[next(across) as usize]
                || self.wedge[next(h) as usize] != self.wedge[across as usize])
    }

    /// Whether merging an edge's ends keeps a manifold with as many pieces, handles and holes: their
    /// common neighbours are the apexes of the edge's triangles (the link condition; Dey, Edelsbrunner
    /// et al. 1999), no apex loses its last face, and no two triangles end up back to back. `stamps` has
    /// a number per vertex, `stamp` is one that was never used.
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

    /// Moves the end of an edge into its start, which stays where it is, and removes the triangles of
    /// the edge. `t` is where between the two the merged attributes are taken.
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
            // Of the two outer sides one at least exists: the left one leaves the apex, the right one
            // the merged vertex.
            self.aim(apex, if left != NONE { left } else { next(right) });
            leaving = if right != NONE { right } else { next(left) };
        }
        self.aim(a, leaving);
    }

    /// Cuts an edge and its triangles at the middle. On each side the edge's half-edge becomes the half
    /// before the middle, the side after it the cut; a new triangle has the half after the middle, the
    /// old side after it, and the cut, in this order. Gives the new vertex, the last.
    pub fn split(&mut self, h: u32) -> u32 {
        let (a, b, across) = (self.from(h), self.to(h), self.opp(h));
        let m = self.position.len() as u32;
        self.position.push((self.at(a) + self.at(b)) * 0.5);
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
                self.edge_source.extend([edge, after, NONE]);
                self.edge_source[n as usize] = NONE;
            }
            if !self.wedge.is_empty() {
                let (from, to) = (self.wedge[side as usize], self.wedge[n as usize]);
                // The other side's middle has the same values where its ends do.
                if (wedges.0, wedges.1) != (to, from) {
                    wedges = (from, to, self.new_wedge(from, to));
                }
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

    /// A new place for corner values, halfway between two.
    fn new_wedge(&mut self, from: u32, to: u32) -> u32 {
        let mut place = 0;
        for column in &mut self.corner_columns {
            place = column.values.len();
            push_copy(column, from as usize);
            mix_into(column, place, to as usize, 0.5);
        }
        place as u32
    }

    /// Turns an edge with two triangles to their apexes. The half-edge comes to be from the apex across
    /// to its own; after it come its triangle's last side and the first one after the edge across.
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
                self.aim(v, k);
            }
        }
    }

    /// Makes a half-edge leaving `v` the one that is found first: turned clockwise to the boundary.
    pub fn aim(&mut self, v: u32, h: u32) {
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

    /// The mesh: vertices and faces in their order here, without gaps, with the attributes of `source`.
    pub fn to_mesh(&self, source: &Mesh) -> Mesh {
        let mut number = vec![NONE; self.out.len()];
        let mut kept = Vec::new();
        for (v, &out) in (0u32..).zip(&self.out) {
            if out != NONE {
                number[v as usize] = kept.len() as u32;
                kept.push(v);
            }
        }
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
            positions: kept.iter().map(|&v| self.frame.outward(self.at(v))).collect(),
            vertex_halfedge: vec![NONE; kept.len()],
            next: vec![NONE; len],
            prev: vec![NONE; len],
            to: vec![NONE; len],
            face: vec![NONE; len],
            face_halfedge: Vec::with_capacity(self.faces),
            columns: Columns::default(),
        };
        let mut faces = Vec::with_capacity(self.faces);
        let mut corner = if self.wedge.is_empty() { Vec::new() } else { vec![NONE; len] };
        let mut edge = if self.edge_source.is_empty() { Vec::new() } else { vec![NONE; edges as usize] };
        for f in 0..self.v.len() / 3 {
            let first = 3 * f as u32;
            if !self.is_alive(first) {
                continue;
            }
            let id = raw.face_halfedge.len() as u32;
            raw.face_halfedge.push(half[first as usize]);
            faces.push(self.face_source[f]);
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
                    // Round the vertex it comes from to the side that comes in on the boundary.
                    let mut last = h;
                    while self.turn(last) != NONE {
                        last = self.turn(last);
                    }
                    let after = half[prev(last) as usize] ^ 1;
                    raw.next[at ^ 1] = after;
                    raw.prev[after as usize] = at as u32 ^ 1;
                }
            }
        }
        for (v, &old) in kept.iter().enumerate() {
            let out = self.out[old as usize];
            // The boundary half-edge that leaves is the twin of the side that comes in.
            let mut last = out;
            if self.opp(out) == NONE {
                while self.turn(last) != NONE {
                    last = self.turn(last);
                }
                raw.vertex_halfedge[v] = half[prev(last) as usize] ^ 1;
            } else {
                raw.vertex_halfedge[v] = half[out as usize];
            }
        }
        let put = |columns: &mut Columns, element: Element, from: &[Column], indices: &[u32]| {
            columns.of_mut(element).extend(from.iter().map(|column| Column {
                name: column.name.clone(),
                values: column.values.gather(indices.iter().copied(), column.default),
                default: column.default,
                labels: column.labels.clone(),
            }));
        };
        put(&mut raw.columns, Element::Vertex, &self.vertex_columns, &kept);
        // Positions have moved: normals given by the file no longer fit.
        let corner_columns: Vec<Column> = self
            .corner_columns
            .iter()
            .filter(|column| column.name != keys::CORNER_NORMAL.name)
            .cloned()
            .collect();
        put(&mut raw.columns, Element::Halfedge, &corner_columns, &corner);
        put(&mut raw.columns, Element::Edge, source.columns().of(Element::Edge), &edge);
        put(&mut raw.columns, Element::Face, source.columns().of(Element::Face), &faces);
        Mesh::from_raw(raw)
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

fn set(column: &mut Column, index: usize, value: Value) {
    use halfedge::attribute::Values;
    match (&mut column.values, value) {
        (Values::F32(values), Value::F32(v)) => values[index] = v,
        (Values::Vec2(values), Value::Vec2(v)) => values[index] = v,
        (Values::Vec3(values), Value::Vec3(v)) => values[index] = v,
        (Values::Color(values), Value::Color(v)) => values[index] = v,
        (Values::U32(values), Value::U32(v)) => values[index] = v,
        _ => debug_assert!(false, "a value of another type"),
    }
}

fn push_copy(column: &mut Column, index: usize) {
    use halfedge::attribute::Values;
    match &mut column.values {
        Values::F32(values) => values.push(values[index]),
        Values::Vec2(values) => values.push(values[index]),
        Values::Vec3(values) => values.push(values[index]),
        Values::Color(values) => values.push(values[index]),
        Values::U32(values) => values.push(values[index]),
    }
}

fn mix_into(column: &mut Column, to: usize, from: usize, t: f32) {
    if let (Some(a), Some(b)) = (column.values.get(to), column.values.get(from)) {
        set(column, to, mix(a, b, t));
    }
}
