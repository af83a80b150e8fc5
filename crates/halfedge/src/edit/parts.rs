//! The few steps that edits are made of. Between two of them a mesh may be invalid; an edit
//! leaves it valid.

use crate::edit::Refusal;
use crate::mesh::Mesh;
use crate::{EdgeId, Element, FaceId, HalfedgeId, NONE, VertexId};
use glam::Vec3;

impl Mesh {
    pub(crate) fn need_vertex(&self, v: VertexId) -> Result<(), Refusal> {
        if self.has_vertex(v) { Ok(()) } else { Err(Refusal::NoSuchElement(Element::Vertex, v.raw())) }
    }

    pub(crate) fn need_halfedge(&self, h: HalfedgeId) -> Result<(), Refusal> {
        if self.has_halfedge(h) { Ok(()) } else { Err(Refusal::NoSuchElement(Element::Halfedge, h.raw())) }
    }

    pub(crate) fn need_edge(&self, e: EdgeId) -> Result<(), Refusal> {
        if self.has_edge(e) { Ok(()) } else { Err(Refusal::NoSuchElement(Element::Edge, e.raw())) }
    }

    pub(crate) fn need_face(&self, f: FaceId) -> Result<(), Refusal> {
        if self.has_face(f) { Ok(()) } else { Err(Refusal::NoSuchElement(Element::Face, f.raw())) }
    }

    /// Checks that there is something to act on and all of it exists.
    pub(crate) fn need_faces(&self, faces: &[FaceId]) -> Result<(), Refusal> {
        if faces.is_empty() {
            return Err(Refusal::NothingGiven(Element::Face));
        }
        faces.iter().try_for_each(|&f| self.need_face(f))
    }

    /// Checks that there is something to act on and all of it exists.
    pub(crate) fn need_edges(&self, edges: &[EdgeId]) -> Result<(), Refusal> {
        if edges.is_empty() {
            return Err(Refusal::NothingGiven(Element::Edge));
        }
        edges.iter().try_for_each(|&e| self.need_edge(e))
    }

    /// Checks that there is something to act on and all of it exists.
    pub(crate) fn need_vertices(&self, vertices: &[VertexId]) -> Result<(), Refusal> {
        if vertices.is_empty() {
            return Err(Refusal::NothingGiven(Element::Vertex));
        }
        vertices.iter().try_for_each(|&v| self.need_vertex(v))
    }

    /// The half-edge from one vertex to another, found by turning round both at once: costs
    /// O(smaller valence).
    pub(crate) fn joined(&self, from: VertexId, to: VertexId) -> Option<HalfedgeId> {
        let (mut out, mut into) = (self.outgoing(from), self.outgoing(to));
        loop {
            let h = out.next()?;
            if self.to(h) == to {
                return Some(h);
            }
            let h = into.next()?;
            if self.to(h) == from {
                return Some(h.twin());
            }
        }
    }

    /// A new vertex, in no face yet.
    pub fn add_vertex(&mut self, position: Vec3) -> VertexId {
        let v = VertexId::new(self.vertex_capacity());
        self.push_blank(Element::Vertex);
        self.set_position(v, position);
        v
    }

    /// A new edge with nothing linked; gives the side from `from` to `to`.
    pub(crate) fn add_edge(&mut self, from: VertexId, to: VertexId) -> HalfedgeId {
        let h = HalfedgeId::new(self.halfedge_capacity());
        self.push_blank(Element::Edge);
        self.set_to(h, to);
        self.set_to(h.twin(), from);
        h
    }

    /// A new face whose first half-edge is `h`; `h`'s loop is not told yet.
    pub(crate) fn add_face(&mut self, h: HalfedgeId) -> FaceId {
        let f = FaceId::new(self.face_capacity());
        self.push_blank(Element::Face);
        self.set_face_halfedge(f, h);
        f
    }

    /// Makes `next` follow `h`.
    pub(crate) fn link(&mut self, h: HalfedgeId, next: HalfedgeId) {
        self.write_next(h.raw(), next.raw());
        self.write_prev(next.raw(), h.raw());
    }

    pub(crate) fn set_to(&mut self, h: HalfedgeId, v: VertexId) {
        self.write_to(h.raw(), v.raw());
    }

    pub(crate) fn set_face(&mut self, h: HalfedgeId, f: Option<FaceId>) {
        self.write_face(h.raw(), f.map_or(NONE, FaceId::raw));
    }

    pub(crate) fn set_face_halfedge(&mut self, f: FaceId, h: HalfedgeId) {
        self.write_face_halfedge(f.raw(), h.raw());
    }

    pub(crate) fn set_vertex_halfedge(&mut self, v: VertexId, h: Option<HalfedgeId>) {
        self.write_vertex_halfedge(v.raw(), h.map_or(NONE, HalfedgeId::raw));
    }

    /// Keeps the boundary-first rule, `h` being some half-edge that leaves the vertex.
    pub(crate) fn settle_vertex(&mut self, v: VertexId, h: HalfedgeId) {
        self.set_vertex_halfedge(v, Some(h));
        let first = self.outgoing(v).find(|&h| self.is_boundary_halfedge(h)).unwrap_or(h);
        self.set_vertex_halfedge(v, Some(first));
    }

    /// Cuts a face in two from the corner of `a` to the corner of `b`, which must be half-edges of
    /// the same face, neither the next of the other. The face keeps `a`'s side of its loop from
    /// `b` on; the new face has `a` up to `b`. Gives the new edge's side in the old face, which
    /// leaves `a`'s corner, and the new face.
    ///
    /// The new face copies the face's attributes and the new corners those of the old corners.
    pub(crate) fn cut_face(&mut self, a: HalfedgeId, b: HalfedgeId) -> (HalfedgeId, FaceId) {
        let (va, vb) = (self.from(a), self.from(b));
        let old = self.face_of(a);
        let (before_a, before_b) = (self.prev(a), self.prev(b));
        let across = self.add_edge(va, vb);
        self.link(before_a, across);
        self.link(across, b);
        self.link(before_b, across.twin());
        self.link(across.twin(), a);
        let made = self.add_face(a);
        for h in self.loop_of(a).collect::<Vec<_>>() {
            self.set_face(h, Some(made));
        }
        self.set_face(across, old);
        if let Some(old) = old {
            // The first corner stays the first where the old face still has it.
            let first = self.halfedge_of(old);
            if self.face_of(first) != Some(old) {
                self.set_face_halfedge(old, across);
            }
            self.copy_attributes(Element::Face, old.raw(), made.raw());
        }
        self.copy_attributes(Element::Halfedge, a.raw(), across.raw());
        self.copy_attributes(Element::Halfedge, b.raw(), across.twin().raw());
        (across, made)
    }
}
