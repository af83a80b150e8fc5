//! The small steps that edits consist of. Between two steps a mesh may be invalid; every edit leaves it valid.

use crate::edit::Refusal;
use crate::mesh::Mesh;
use crate::{EdgeId, Element, FaceId, HalfedgeId, NONE, VertexId};
use glam::Vec3;

impl Mesh {
    pub(crate) fn require_vertex(&self, v: VertexId) -> Result<(), Refusal> {
        if self.has_vertex(v) { Ok(()) } else { Err(Refusal::NoSuchElement(Element::Vertex, v.raw())) }
    }

    pub(crate) fn require_halfedge(&self, h: HalfedgeId) -> Result<(), Refusal> {
        if self.has_halfedge(h) { Ok(()) } else { Err(Refusal::NoSuchElement(Element::Halfedge, h.raw())) }
    }

    pub(crate) fn require_edge(&self, e: EdgeId) -> Result<(), Refusal> {
        if self.has_edge(e) { Ok(()) } else { Err(Refusal::NoSuchElement(Element::Edge, e.raw())) }
    }

    pub(crate) fn require_face(&self, f: FaceId) -> Result<(), Refusal> {
        if self.has_face(f) { Ok(()) } else { Err(Refusal::NoSuchElement(Element::Face, f.raw())) }
    }

    /// Checks that at least one face is given and all exist.
    pub(crate) fn require_faces(&self, faces: &[FaceId]) -> Result<(), Refusal> {
        if faces.is_empty() {
            return Err(Refusal::NothingGiven(Element::Face));
        }
        faces.iter().try_for_each(|&f| self.require_face(f))
    }

    /// Checks that at least one edge is given and all exist.
    pub(crate) fn require_edges(&self, edges: &[EdgeId]) -> Result<(), Refusal> {
        if edges.is_empty() {
            return Err(Refusal::NothingGiven(Element::Edge));
        }
        edges.iter().try_for_each(|&e| self.require_edge(e))
    }

    /// Checks that at least one vertex is given and all exist.
    pub(crate) fn require_vertices(&self, vertices: &[VertexId]) -> Result<(), Refusal> {
        if vertices.is_empty() {
            return Err(Refusal::NothingGiven(Element::Vertex));
        }
        vertices.iter().try_for_each(|&v| self.require_vertex(v))
    }

    /// The half-edge from one vertex to another, if an edge joins them. Turns round both vertices at once, so it
    /// costs O(smaller valence).
    pub(crate) fn find_halfedge_between(&self, from: VertexId, to: VertexId) -> Option<HalfedgeId> {
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

    /// Adds a vertex, in no face yet.
    pub fn add_vertex(&mut self, position: Vec3) -> VertexId {
        let v = VertexId::new(self.vertex_capacity());
        self.push_blank(Element::Vertex);
        self.set_position(v, position);
        v
    }

    /// Adds an edge without links; returns its half-edge from `from` to `to`.
    pub(crate) fn add_edge(&mut self, from: VertexId, to: VertexId) -> HalfedgeId {
        let h = HalfedgeId::new(self.halfedge_capacity());
        self.push_blank(Element::Edge);
        self.set_to(h, to);
        self.set_to(h.twin(), from);
        h
    }

    /// Adds a face whose first half-edge is `h`. The half-edges of its loop don't know the face yet.
    pub(crate) fn add_face(&mut self, h: HalfedgeId) -> FaceId {
        let f = FaceId::new(self.face_capacity());
        self.push_blank(Element::Face);
        self.set_face_halfedge(f, h);
        f
    }

    /// Makes `next` the half-edge after `h`.
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

    /// Gives a vertex its half-edge: a boundary one if one leaves it, else `h`, which is any that leaves it.
    pub(crate) fn restore_vertex_halfedge(&mut self, v: VertexId, h: HalfedgeId) {
        self.set_vertex_halfedge(v, Some(h));
        let first = self.outgoing(v).find(|&h| self.is_boundary_halfedge(h)).unwrap_or(h);
        self.set_vertex_halfedge(v, Some(first));
    }

    /// Cuts a face in two between the corners of `a` and `b`, half-edges of the same face that are not
    /// neighbours. The face keeps the part from `b` on; a new face has the part from `a` up to `b`. Returns the
    /// new edge's half-edge in the old face, which leaves the corner of `a`, and the new face.
    ///
    /// The new face copies the attributes of the old one, and the new corners those of the old corners.
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
            // The first corner stays the first if the old face still has it.
            let first = self.halfedge_of(old);
            if self.face_of(first) != Some(old) {
                self.set_face_halfedge(old, across);
            }
            self.copy_attributes(Element::Face, old.raw(), made.raw());
            self.record_face_source(made, old);
        }
        self.copy_attributes(Element::Halfedge, a.raw(), across.raw());
        self.copy_attributes(Element::Halfedge, b.raw(), across.twin().raw());
        (across, made)
    }
}
