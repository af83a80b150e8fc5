//! Traversal: loops and one-rings.
//!
//! Every traversal ends after as many steps as the mesh has half-edges, so that an invalid mesh (see
//! [`Mesh::validate`]) can't cause an endless loop.

use crate::mesh::Mesh;
use crate::{EdgeId, FaceId, HalfedgeId, VertexId};

impl Mesh {
    /// The half-edges of the loop through `h`, starting with `h`: a face's loop or a boundary loop.
    pub fn loop_of(&self, h: HalfedgeId) -> impl Iterator<Item = HalfedgeId> + '_ {
        self.walk(Some(h), |h| self.next(h))
    }

    /// The half-edges of a face; each leaves one corner, the first one the first corner.
    pub fn face_halfedges(&self, f: FaceId) -> impl Iterator<Item = HalfedgeId> + '_ {
        self.loop_of(self.halfedge_of(f))
    }

    /// The corners of a face in order.
    pub fn face_vertices(&self, f: FaceId) -> impl Iterator<Item = VertexId> + '_ {
        self.face_halfedges(f).map(|h| self.from(h))
    }

    /// The number of a face's corners.
    pub fn face_degree(&self, f: FaceId) -> usize {
        self.face_halfedges(f).count()
    }

    /// The half-edges leaving a vertex, clockwise as seen from outside, starting with a boundary one if there
    /// is one. There are as many as edges at the vertex, since boundary half-edges are stored.
    pub fn outgoing(&self, v: VertexId) -> impl Iterator<Item = HalfedgeId> + '_ {
        self.walk(self.halfedge_from(v), |h| self.next(h.twin()))
    }

    /// The half-edges leaving `h`'s from-vertex in the order of [`Mesh::outgoing`], starting with `h`.
    pub fn turn_from(&self, h: HalfedgeId) -> impl Iterator<Item = HalfedgeId> + '_ {
        self.walk(Some(h), |h| self.next(h.twin()))
    }

    /// The half-edges arriving at a vertex, in the order of [`Mesh::outgoing`].
    pub fn incoming(&self, v: VertexId) -> impl Iterator<Item = HalfedgeId> + '_ {
        self.outgoing(v).map(HalfedgeId::twin)
    }

    /// The half-edge before `h` among those leaving its from-vertex, in the order of
    /// [`Mesh::outgoing`].
    pub fn prev_around_from(&self, h: HalfedgeId) -> HalfedgeId {
        self.prev(h).twin()
    }

    /// The vertices joined to a vertex by an edge.
    pub fn neighbors(&self, v: VertexId) -> impl Iterator<Item = VertexId> + '_ {
        self.outgoing(v).map(|h| self.to(h))
    }

    /// The edges at a vertex.
    pub fn vertex_edges(&self, v: VertexId) -> impl Iterator<Item = EdgeId> + '_ {
        self.outgoing(v).map(HalfedgeId::edge)
    }

    /// The faces at a vertex.
    pub fn vertex_faces(&self, v: VertexId) -> impl Iterator<Item = FaceId> + '_ {
        self.outgoing(v).filter_map(|h| self.face_of(h))
    }

    /// The number of a vertex's edges.
    pub fn valence(&self, v: VertexId) -> usize {
        self.outgoing(v).count()
    }

    /// The half-edge from one vertex to another, if an edge joins them. Costs O(valence).
    pub fn find_halfedge(&self, from: VertexId, to: VertexId) -> Option<HalfedgeId> {
        self.outgoing(from).find(|&h| self.to(h) == to)
    }

    /// The edge between two vertices, if there is one. Costs O(valence).
    pub fn find_edge(&self, a: VertexId, b: VertexId) -> Option<EdgeId> {
        self.find_halfedge(a, b).map(HalfedgeId::edge)
    }

    /// Vertices - edges + faces.
    pub fn euler_characteristic(&self) -> i64 {
        self.vertex_count() as i64 - self.edge_count() as i64 + self.face_count() as i64
    }

    fn walk(
        &self,
        start: Option<HalfedgeId>,
        step: impl Fn(HalfedgeId) -> HalfedgeId,
    ) -> impl Iterator<Item = HalfedgeId> {
        let mut at = start;
        let mut left = self.halfedge_capacity();
        std::iter::from_fn(move || {
            let here = at?;
            left = left.checked_sub(1)?;
            let after = step(here);
            at = (Some(after) != start).then_some(after);
            Some(here)
        })
    }
}
