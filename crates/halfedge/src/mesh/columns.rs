//! The mesh: flat columns of connectivity, positions and attributes.

use crate::attribute::{AttributeType, Column, Columns, Key, Value};
use crate::geometry::BitSet;
use crate::mesh::journal::{Change, ColumnPlace, Journal};
use crate::{EdgeId, Element, FaceId, HalfedgeId, NONE, VertexId};
use glam::Vec3;

/// A polygon mesh as plain data.
///
/// Half-edges `2e` and `2e + 1` are the sides of edge `e`; each knows the next and previous
/// half-edge of its loop, the vertex it points to, and its face, which is none for a boundary
/// half-edge. Boundary half-edges are stored and form loops like a face's. A vertex knows one
/// half-edge that leaves it, a boundary one if there is one; a face knows its first.
///
/// Removing an element marks it: ids of the others stay as they are until [`Mesh::compact`].
#[derive(Debug, Default)]
pub struct Mesh {
    pub(crate) positions: Vec<Vec3>,
    pub(crate) vertex_halfedge: Vec<u32>,
    pub(crate) next: Vec<u32>,
    pub(crate) prev: Vec<u32>,
    pub(crate) to: Vec<u32>,
    pub(crate) face: Vec<u32>,
    pub(crate) face_halfedge: Vec<u32>,
    pub(crate) removed_vertices: BitSet,
    pub(crate) removed_edges: BitSet,
    pub(crate) removed_faces: BitSet,
    pub(crate) columns: Columns,
    pub(crate) journal: Option<Journal>,
}

/// The connectivity and positions of a mesh as raw columns, for algorithms that build a whole mesh
/// at once and for sending a mesh elsewhere. [`NONE`] stands for "no face" and "no half-edge".
#[derive(Clone, Debug, Default, PartialEq)]
pub struct RawMesh {
    /// Per vertex: its position.
    pub positions: Vec<Vec3>,
    /// Per vertex: a half-edge leaving it, a boundary one if there is one, or [`NONE`] if isolated.
    pub vertex_halfedge: Vec<u32>,
    /// Per half-edge: the next in its loop.
    pub next: Vec<u32>,
    /// Per half-edge: the previous in its loop.
    pub prev: Vec<u32>,
    /// Per half-edge: the vertex it points to.
    pub to: Vec<u32>,
    /// Per half-edge: its face, or [`NONE`] on the boundary.
    pub face: Vec<u32>,
    /// Per face: its first half-edge, which leaves the face's first corner.
    pub face_halfedge: Vec<u32>,
    /// Attribute columns, each as long as its kind of element.
    pub columns: Columns,
}

/// The ids of removed elements, which still have their place in columns; each in ascending order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Gaps {
    /// Vertex ids.
    pub vertices: Vec<u32>,
    /// Edge ids.
    pub edges: Vec<u32>,
    /// Face ids.
    pub faces: Vec<u32>,
}

impl Clone for Mesh {
    /// A copy of the mesh without the journal being recorded.
    fn clone(&self) -> Self {
        Self {
            positions: self.positions.clone(),
            vertex_halfedge: self.vertex_halfedge.clone(),
            next: self.next.clone(),
            prev: self.prev.clone(),
            to: self.to.clone(),
            face: self.face.clone(),
            face_halfedge: self.face_halfedge.clone(),
            removed_vertices: self.removed_vertices.clone(),
            removed_edges: self.removed_edges.clone(),
            removed_faces: self.removed_faces.clone(),
            columns: self.columns.clone(),
            journal: None,
        }
    }
}

impl PartialEq for Mesh {
    /// The same ids, arrays and attributes, positions to the bit.
    fn eq(&self, other: &Self) -> bool {
        self.next == other.next
            && self.prev == other.prev
            && self.to == other.to
            && self.face == other.face
            && self.vertex_halfedge == other.vertex_halfedge
            && self.face_halfedge == other.face_halfedge
            && self.removed_vertices == other.removed_vertices
            && self.removed_edges == other.removed_edges
            && self.removed_faces == other.removed_faces
            && same_bits(&self.positions, &other.positions)
            && self.columns == other.columns
    }
}

impl Mesh {
    /// The most edges a mesh may have; one more would leave half-edge ids too few bits.
    pub const MAX_EDGES: usize = (u32::MAX / 2 - 1) as usize;

    /// A mesh with nothing in it.
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes raw columns as they are, without checking them: call [`Mesh::validate`] on anything
    /// that does not come from an algorithm known to be right.
    pub fn from_raw(raw: RawMesh) -> Self {
        let RawMesh { positions, vertex_halfedge, next, prev, to, face, face_halfedge, columns } = raw;
        Self { positions, vertex_halfedge, next, prev, to, face, face_halfedge, columns, ..Self::default() }
    }

    /// The raw columns. Removed elements still have their place in them: compact first where that
    /// matters.
    pub fn into_raw(self) -> RawMesh {
        RawMesh {
            positions: self.positions,
            vertex_halfedge: self.vertex_halfedge,
            next: self.next,
            prev: self.prev,
            to: self.to,
            face: self.face,
            face_halfedge: self.face_halfedge,
            columns: self.columns,
        }
    }

    /// Which ids are of removed elements; none for a compact mesh.
    pub fn gaps(&self) -> Gaps {
        let list = |removed: &BitSet| removed.iter().map(|at| at as u32).collect();
        Gaps {
            vertices: list(&self.removed_vertices),
            edges: list(&self.removed_edges),
            faces: list(&self.removed_faces),
        }
    }

    /// [`Mesh::from_raw`] with removed elements: with [`Mesh::into_raw`] and [`Mesh::gaps`] a mesh
    /// goes elsewhere and comes back equal. Ids past the end of the columns are passed over.
    pub fn from_raw_with_gaps(raw: RawMesh, gaps: &Gaps) -> Self {
        let mut mesh = Self::from_raw(raw);
        let lists = [
            (&mut mesh.removed_vertices, &gaps.vertices, mesh.positions.len()),
            (&mut mesh.removed_edges, &gaps.edges, mesh.next.len() / 2),
            (&mut mesh.removed_faces, &gaps.faces, mesh.face_halfedge.len()),
        ];
        for (marks, list, len) in lists {
            for &id in list.iter().filter(|&&id| (id as usize) < len) {
                marks.insert(id as usize);
            }
        }
        mesh
    }

    // Counts and ids.

    /// How many vertices there are, removed ones not counted.
    pub fn vertex_count(&self) -> usize {
        self.positions.len() - self.removed_vertices.len()
    }

    /// How many edges there are, removed ones not counted.
    pub fn edge_count(&self) -> usize {
        self.next.len() / 2 - self.removed_edges.len()
    }

    /// How many half-edges there are, boundary ones included: twice the edges.
    pub fn halfedge_count(&self) -> usize {
        self.edge_count() * 2
    }

    /// How many faces there are, removed ones not counted.
    pub fn face_count(&self) -> usize {
        self.face_halfedge.len() - self.removed_faces.len()
    }

    /// One more than the largest vertex id ever given: the length of vertex columns.
    pub fn vertex_capacity(&self) -> usize {
        self.positions.len()
    }

    /// One more than the largest edge id ever given.
    pub fn edge_capacity(&self) -> usize {
        self.next.len() / 2
    }

    /// One more than the largest half-edge id ever given.
    pub fn halfedge_capacity(&self) -> usize {
        self.next.len()
    }

    /// One more than the largest face id ever given.
    pub fn face_capacity(&self) -> usize {
        self.face_halfedge.len()
    }

    /// How many ids of a kind were ever given: the length of that kind's columns.
    pub fn capacity(&self, element: Element) -> usize {
        match element {
            Element::Vertex => self.vertex_capacity(),
            Element::Halfedge => self.halfedge_capacity(),
            Element::Edge => self.edge_capacity(),
            Element::Face => self.face_capacity(),
        }
    }

    /// How many elements of a kind there are.
    pub fn count(&self, element: Element) -> usize {
        match element {
            Element::Vertex => self.vertex_count(),
            Element::Halfedge => self.halfedge_count(),
            Element::Edge => self.edge_count(),
            Element::Face => self.face_count(),
        }
    }

    /// Whether no id is marked as removed, so that ids are exactly `0..count`.
    pub fn is_compact(&self) -> bool {
        self.removed_vertices.len() + self.removed_edges.len() + self.removed_faces.len() == 0
    }

    /// Whether the element with this number exists.
    pub fn exists(&self, element: Element, raw: u32) -> bool {
        let index = raw as usize;
        index < self.capacity(element)
            && !match element {
                Element::Vertex => self.removed_vertices.contains(index),
                Element::Halfedge => self.removed_edges.contains(index / 2),
                Element::Edge => self.removed_edges.contains(index),
                Element::Face => self.removed_faces.contains(index),
            }
    }

    /// The vertex with this number, if it exists.
    pub fn vertex(&self, raw: u32) -> Option<VertexId> {
        VertexId::from_raw(raw).filter(|v| self.has_vertex(*v))
    }

    /// The edge with this number, if it exists.
    pub fn edge(&self, raw: u32) -> Option<EdgeId> {
        EdgeId::from_raw(raw).filter(|e| self.has_edge(*e))
    }

    /// The half-edge with this number, if it exists.
    pub fn halfedge(&self, raw: u32) -> Option<HalfedgeId> {
        HalfedgeId::from_raw(raw).filter(|h| self.has_halfedge(*h))
    }

    /// The face with this number, if it exists.
    pub fn face(&self, raw: u32) -> Option<FaceId> {
        FaceId::from_raw(raw).filter(|f| self.has_face(*f))
    }

    /// Whether the vertex exists.
    pub fn has_vertex(&self, v: VertexId) -> bool {
        v.index() < self.positions.len() && !self.removed_vertices.contains(v.index())
    }

    /// Whether the edge exists.
    pub fn has_edge(&self, e: EdgeId) -> bool {
        e.index() < self.next.len() / 2 && !self.removed_edges.contains(e.index())
    }

    /// Whether the half-edge exists.
    pub fn has_halfedge(&self, h: HalfedgeId) -> bool {
        self.has_edge(h.edge())
    }

    /// Whether the face exists.
    pub fn has_face(&self, f: FaceId) -> bool {
        f.index() < self.face_halfedge.len() && !self.removed_faces.contains(f.index())
    }

    /// All vertices in order of id.
    pub fn vertices(&self) -> impl Iterator<Item = VertexId> + '_ {
        (0..self.positions.len()).filter(|&i| !self.removed_vertices.contains(i)).map(VertexId::new)
    }

    /// All edges in order of id.
    pub fn edges(&self) -> impl Iterator<Item = EdgeId> + '_ {
        (0..self.next.len() / 2).filter(|&i| !self.removed_edges.contains(i)).map(EdgeId::new)
    }

    /// All half-edges in order of id, boundary ones included.
    pub fn halfedges(&self) -> impl Iterator<Item = HalfedgeId> + '_ {
        self.edges().flat_map(EdgeId::halfedges)
    }

    /// All faces in order of id.
    pub fn faces(&self) -> impl Iterator<Item = FaceId> + '_ {
        (0..self.face_halfedge.len()).filter(|&i| !self.removed_faces.contains(i)).map(FaceId::new)
    }

    // Connectivity. Ids must exist; another mesh's ids panic when out of range, as any index does.

    /// The next half-edge in the face, or along the boundary loop.
    #[inline]
    pub fn next(&self, h: HalfedgeId) -> HalfedgeId {
        HalfedgeId::new(self.next[h.index()] as usize)
    }

    /// The previous half-edge in the face, or along the boundary loop.
    #[inline]
    pub fn prev(&self, h: HalfedgeId) -> HalfedgeId {
        HalfedgeId::new(self.prev[h.index()] as usize)
    }

    /// The vertex the half-edge points to.
    #[inline]
    pub fn to(&self, h: HalfedgeId) -> VertexId {
        VertexId::new(self.to[h.index()] as usize)
    }

    /// The vertex the half-edge leaves.
    #[inline]
    pub fn from(&self, h: HalfedgeId) -> VertexId {
        self.to(h.twin())
    }

    /// The face to the left of the half-edge, or none on the boundary.
    #[inline]
    pub fn face_of(&self, h: HalfedgeId) -> Option<FaceId> {
        FaceId::from_raw(self.face[h.index()])
    }

    /// A half-edge leaving the vertex, a boundary one if there is one; none for an isolated vertex.
    #[inline]
    pub fn halfedge_from(&self, v: VertexId) -> Option<HalfedgeId> {
        HalfedgeId::from_raw(self.vertex_halfedge[v.index()])
    }

    /// The face's first half-edge: it leaves the face's first corner.
    #[inline]
    pub fn halfedge_of(&self, f: FaceId) -> HalfedgeId {
        HalfedgeId::new(self.face_halfedge[f.index()] as usize)
    }

    /// The two ends of an edge: where its even half-edge leaves and where it points.
    #[inline]
    pub fn ends(&self, e: EdgeId) -> [VertexId; 2] {
        let h = e.halfedge();
        [self.from(h), self.to(h)]
    }

    /// Whether the half-edge has no face.
    #[inline]
    pub fn is_boundary_halfedge(&self, h: HalfedgeId) -> bool {
        self.face[h.index()] == NONE
    }

    /// Whether one side of the edge has no face.
    pub fn is_boundary_edge(&self, e: EdgeId) -> bool {
        e.halfedges().iter().any(|&h| self.is_boundary_halfedge(h))
    }

    /// Whether the vertex is on a boundary loop. An isolated vertex is not.
    pub fn is_boundary_vertex(&self, v: VertexId) -> bool {
        self.halfedge_from(v).is_some_and(|h| self.is_boundary_halfedge(h))
    }

    /// Whether the face has an edge on the boundary.
    pub fn is_boundary_face(&self, f: FaceId) -> bool {
        self.face_halfedges(f).any(|h| self.is_boundary_halfedge(h.twin()))
    }

    // Positions and attributes.

    /// The position of a vertex, in mesh units.
    #[inline]
    pub fn position(&self, v: VertexId) -> Vec3 {
        self.positions[v.index()]
    }

    /// The positions of all vertex ids, removed ones included.
    pub fn positions(&self) -> &[Vec3] {
        &self.positions
    }

    /// Moves a vertex. The position must be finite; commands check that.
    pub fn set_position(&mut self, v: VertexId, position: Vec3) {
        let old = std::mem::replace(&mut self.positions[v.index()], position);
        if bytemuck::bytes_of(&old) != bytemuck::bytes_of(&position) {
            self.record(Change::Position(v.raw(), old));
        }
    }

    /// Moves every vertex at once. The column must be as long as [`Mesh::vertex_capacity`];
    /// one that is not is refused by returning it.
    pub fn set_positions(&mut self, positions: Vec<Vec3>) -> Result<(), Vec<Vec3>> {
        if positions.len() != self.positions.len() {
            return Err(positions);
        }
        let old = std::mem::replace(&mut self.positions, positions);
        if !same_bits(&old, &self.positions) {
            self.record(Change::Positions(old.into_boxed_slice()));
        }
        Ok(())
    }

    /// All attribute columns.
    pub fn columns(&self) -> &Columns {
        &self.columns
    }

    /// A column's values, one per id, if the mesh has the column with that type.
    pub fn attribute<T: AttributeType>(&self, key: Key<T>) -> Option<&[T]> {
        let at = self.columns.position(key.element, key.name)?;
        T::slice(&self.columns.of(key.element).get(at)?.values)
    }

    /// One value of a column; the key's default where the mesh has no such column.
    pub fn get<T: AttributeType>(&self, key: Key<T>, index: usize) -> T {
        self.attribute(key).and_then(|values| values.get(index)).copied().unwrap_or(key.default)
    }

    /// The column of that name, with its labels.
    pub fn column(&self, element: Element, name: &str) -> Option<&Column> {
        let at = self.columns.position(element, name)?;
        self.columns.of(element).get(at)
    }

    /// Sets one value, making the column if the mesh doesn't have it, unless the value is the default.
    pub fn set<T: AttributeType>(&mut self, key: Key<T>, index: usize, value: T) {
        let at = match self.columns.position(key.element, key.name) {
            Some(at) => at,
            None if value.value().is_identical(key.default.value()) => return,
            None => self.insert_column(key.element, Column::new(key)),
        };
        self.set_value(key.element, at, index, value.value());
    }

    /// Sets one value of the column at this place among its element's.
    pub fn set_value(&mut self, element: Element, column: usize, index: usize, value: Value) {
        let Some(target) = self.columns.of_mut(element).get_mut(column) else { return };
        let Some(old) = target.values.get(index) else { return };
        if old.is_identical(value) {
            return;
        }
        target.values.set(index, value);
        self.record(Change::Attribute(ColumnPlace::new(element, column), index as u32, old));
    }

    /// Adds a column, or replaces the one of that name; it is made as long as the element's ids.
    /// Gives its place among the element's columns.
    pub fn insert_column(&mut self, element: Element, mut column: Column) -> usize {
        let blank = column.values.is_empty();
        column.values.resize(self.capacity(element), column.default);
        let old_at = self.columns.position(element, &column.name);
        let columns = self.columns.of_mut(element);
        match old_at {
            Some(at) => {
                if columns[at] == column && columns[at].default.is_identical(column.default) {
                    return at;
                }
                let old = std::mem::replace(&mut columns[at], column);
                self.record(Change::Column(ColumnPlace::new(element, at), Box::new(old)));
                at
            }
            None => {
                columns.push(column);
                let at = columns.len() - 1;
                self.record(Change::ColumnAdded(element, blank));
                at
            }
        }
    }

    /// Takes back the last [`Mesh::add_vertex`], for a caller that records nothing.
    pub(crate) fn pop_isolated_vertex(&mut self) {
        self.positions.pop();
        self.vertex_halfedge.pop();
        let len = self.positions.len();
        for column in self.columns.of_mut(Element::Vertex) {
            column.values.resize(len, column.default);
        }
    }

    /// Heap bytes of the mesh.
    pub fn bytes(&self) -> usize {
        self.positions.len() * size_of::<Vec3>()
            + (self.vertex_halfedge.len() + self.next.len() * 4 + self.face_halfedge.len()) * 4
            + self.columns.bytes()
            + self.removed_vertices.bytes()
            + self.removed_edges.bytes()
            + self.removed_faces.bytes()
    }
}

fn same_bits(a: &[Vec3], b: &[Vec3]) -> bool {
    bytemuck::cast_slice::<Vec3, u8>(a) == bytemuck::cast_slice::<Vec3, u8>(b)
}
