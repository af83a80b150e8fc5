//! Which elements a mesh has, and the links from one to the next.

use crate::mesh::Mesh;
use crate::{EdgeId, Element, FaceId, HalfedgeId, NONE, VertexId};

/// Counts and ids.
impl Mesh {
    /// The number of vertices, without removed ones.
    pub fn vertex_count(&self) -> usize {
        self.positions.len() - self.removed_vertices.len()
    }

    /// The number of edges, without removed ones.
    pub fn edge_count(&self) -> usize {
        self.next.len() / 2 - self.removed_edges.len()
    }

    /// The number of half-edges, with boundary ones: twice the number of edges.
    pub fn halfedge_count(&self) -> usize {
        self.edge_count() * 2
    }

    /// The number of faces, without removed ones.
    pub fn face_count(&self) -> usize {
        self.face_halfedge.len() - self.removed_faces.len()
    }

    /// One more than the largest vertex id ever used: the length of vertex columns.
    pub fn vertex_capacity(&self) -> usize {
        self.positions.len()
    }

    /// One more than the largest edge id ever used.
    pub fn edge_capacity(&self) -> usize {
        self.next.len() / 2
    }

    /// One more than the largest half-edge id ever used.
    pub fn halfedge_capacity(&self) -> usize {
        self.next.len()
    }

    /// One more than the largest face id ever used.
    pub fn face_capacity(&self) -> usize {
        self.face_halfedge.len()
    }

    /// How many ids of a kind were ever used: the length of that kind's columns.
    pub fn capacity(&self, element: Element) -> usize {
        match element {
            Element::Vertex => self.vertex_capacity(),
            Element::Halfedge => self.halfedge_capacity(),
            Element::Edge => self.edge_capacity(),
            Element::Face => self.face_capacity(),
        }
    }

    /// The number of elements of a kind, without removed ones.
    pub fn count(&self, element: Element) -> usize {
        match element {
            Element::Vertex => self.vertex_count(),
            Element::Halfedge => self.halfedge_count(),
            Element::Edge => self.edge_count(),
            Element::Face => self.face_count(),
        }
    }

    /// Whether no element is removed, so that the ids are `0..count`.
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

    /// All half-edges in order of id, with boundary ones.
    pub fn halfedges(&self) -> impl Iterator<Item = HalfedgeId> + '_ {
        self.edges().flat_map(EdgeId::halfedges)
    }

    /// All faces in order of id.
    pub fn faces(&self) -> impl Iterator<Item = FaceId> + '_ {
        (0..self.face_halfedge.len()).filter(|&i| !self.removed_faces.contains(i)).map(FaceId::new)
    }
}

/// Links. Ids must be of this mesh: those of another panic when they are out of range, as any index does.
impl Mesh {
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

    /// The face to the left of the half-edge; none on the boundary.
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

    /// The ends of an edge: the vertices that its even half-edge leaves and points to.
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

    /// Whether the edge has a face on one side only.
    pub fn is_boundary_edge(&self, e: EdgeId) -> bool {
        e.halfedges().iter().any(|&h| self.is_boundary_halfedge(h))
    }

    /// Whether the vertex is on a boundary loop; an isolated vertex isn't.
    pub fn is_boundary_vertex(&self, v: VertexId) -> bool {
        self.halfedge_from(v).is_some_and(|h| self.is_boundary_halfedge(h))
    }

    /// Whether the face has an edge on the boundary.
    pub fn is_boundary_face(&self, f: FaceId) -> bool {
        self.face_halfedges(f).any(|h| self.is_boundary_halfedge(h.twin()))
    }
}
