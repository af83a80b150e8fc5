//! What single elements belong to and consist of.

use halfedge::geometry::BitSet;
use halfedge::{EdgeId, Element, FaceId, HalfedgeId, Mesh, VertexId};

/// How an element leads to others.
#[derive(Clone, Copy, Debug)]
pub(super) enum Part {
    /// An edge of a half-edge.
    EdgeOf,
    /// The half-edges of an edge.
    Sides,
    /// The half-edges inside a face.
    Halfedges,
    /// The edges of a face.
    Edges,
    /// The edges of a face beside faces that aren't in the first set.
    Outline,
    /// The faces beside an edge.
    FacesOfEdge,
    /// The face of a half-edge.
    FaceOf,
}

/// Visits the vertices of an element that exists; those of an edge or a half-edge from the start of the edge's even
/// half-edge.
pub fn vertices(mesh: &Mesh, kind: Element, id: usize, visit: impl FnMut(VertexId)) {
    match kind {
        Element::Vertex => std::iter::once(VertexId::new(id)).for_each(visit),
        Element::Edge => mesh.ends(EdgeId::new(id)).into_iter().for_each(visit),
        Element::Halfedge => mesh.ends(HalfedgeId::new(id).edge()).into_iter().for_each(visit),
        Element::Face => mesh.face_vertices(FaceId::new(id)).for_each(visit),
    }
}

/// Visits the elements of a kind that have a vertex.
pub(super) fn touching(mesh: &Mesh, kind: Element, v: VertexId, mut visit: impl FnMut(usize)) {
    match kind {
        Element::Vertex => visit(v.index()),
        Element::Edge => mesh.vertex_edges(v).for_each(|e| visit(e.index())),
        Element::Halfedge => mesh.outgoing(v).flat_map(|h| [h, h.twin()]).for_each(|h| visit(h.index())),
        Element::Face => mesh.vertex_faces(v).for_each(|f| visit(f.index())),
    }
}

pub(super) fn parts(mesh: &Mesh, part: Part, origin: &BitSet, id: usize, mut visit: impl FnMut(usize)) {
    match part {
        Part::EdgeOf => visit(id / 2),
        Part::Sides => [2 * id, 2 * id + 1].into_iter().for_each(visit),
        Part::Halfedges => mesh.face_halfedges(FaceId::new(id)).for_each(|h| visit(h.index())),
        Part::Edges => mesh.face_halfedges(FaceId::new(id)).for_each(|h| visit(h.edge().index())),
        Part::Outline => {
            let is_inside = |h: HalfedgeId| mesh.face_of(h).is_some_and(|f| origin.contains(f.index()));
            let sides = mesh.face_halfedges(FaceId::new(id));
            sides.filter(|h| !is_inside(h.twin())).for_each(|h| visit(h.edge().index()));
        }
        Part::FacesOfEdge => {
            let faces = EdgeId::new(id).halfedges().into_iter().filter_map(|h| mesh.face_of(h));
            faces.for_each(|f| visit(f.index()));
        }
        Part::FaceOf => mesh.face_of(HalfedgeId::new(id)).into_iter().for_each(|f| visit(f.index())),
    }
}

/// Whether all vertices of an element, or all edges or half-edges of a face, are in a set.
pub(super) fn is_within(mesh: &Mesh, of: Element, kind: Element, id: usize, set: &BitSet) -> bool {
    let mut all = true;
    match of {
        Element::Edge => all = mesh.face_halfedges(FaceId::new(id)).all(|h| set.contains(h.edge().index())),
        Element::Halfedge => all = mesh.face_halfedges(FaceId::new(id)).all(|h| set.contains(h.index())),
        Element::Vertex | Element::Face => {
            vertices(mesh, kind, id, |v| all &= set.contains(v.index()));
        }
    }
    all
}

/// Whether an element is hidden with a set of faces: it is one of them, or has faces and all are among them. A half-edge
/// without a face is hidden with its edge. Costs O(valence).
pub fn is_hidden(mesh: &Mesh, kind: Element, id: usize, hidden: &BitSet) -> bool {
    let contains = |f: FaceId| hidden.contains(f.index());
    let of_edge = |e: EdgeId| e.halfedges().into_iter().filter_map(|h| mesh.face_of(h)).all(contains);
    match kind {
        _ if hidden.is_empty() => false,
        Element::Face => hidden.contains(id),
        Element::Edge => of_edge(EdgeId::new(id)),
        Element::Halfedge => {
            let h = HalfedgeId::new(id);
            mesh.face_of(h).map_or_else(|| of_edge(h.edge()), contains)
        }
        Element::Vertex => {
            let mut faces = mesh.vertex_faces(VertexId::new(id)).peekable();
            faces.peek().is_some() && faces.all(contains)
        }
    }
}
