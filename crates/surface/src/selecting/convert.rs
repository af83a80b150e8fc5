//! The elements of one kind that belong to those of another.

use halfedge::geometry::BitSet;
use halfedge::{EdgeId, Element, FaceId, HalfedgeId, Mesh, VertexId};

/// Converts a set of elements of a kind to another kind: to the vertices, edges and half-edges of its elements, or to
/// the edges, half-edges and faces that have all their vertices (for faces, also all their edges or half-edges) in it.
/// Both half-edges of an edge stand for it; those of a face are the ones inside it. Costs O(set x valence).
pub fn convert(mesh: &Mesh, from: Element, to: Element, ids: &BitSet) -> BitSet {
    if from == to {
        return ids.clone();
    }
    match (from, to) {
        (_, Element::Vertex) => vertices_of(mesh, from, ids),
        (Element::Halfedge, Element::Edge) => ids.iter().map(|h| h / 2).collect(),
        (Element::Edge, Element::Halfedge) => ids.iter().flat_map(|e| [2 * e, 2 * e + 1]).collect(),
        (Element::Face, Element::Edge) => face_halfedges(mesh, ids).map(|h| h.edge().index()).collect(),
        (Element::Face, Element::Halfedge) => face_halfedges(mesh, ids).map(HalfedgeId::index).collect(),
        (Element::Edge, Element::Face) => {
            let all = |f: FaceId| mesh.face_halfedges(f).all(|h| ids.contains(h.edge().index()));
            faces_beside(mesh, ids.iter().flat_map(|e| EdgeId::new(e).halfedges()), all)
        }
        (Element::Halfedge, Element::Face) => {
            let all = |f: FaceId| mesh.face_halfedges(f).all(|h| ids.contains(h.index()));
            faces_beside(mesh, ids.iter().map(HalfedgeId::new), all)
        }
        _ => {
            let has = |v: VertexId| ids.contains(v.index());
            let mut contained = touching(mesh, to, ids);
            let out: Vec<usize> = contained.iter().filter(|&id| !vertices(mesh, to, id).all(has)).collect();
            out.into_iter().for_each(|id| {
                contained.remove(id);
            });
            contained
        }
    }
}

/// Converts like [`convert`], but to every edge, half-edge and face that has any of the elements: a vertex, or for faces
/// one of their edges or half-edges. Costs O(set x valence).
pub fn expand(mesh: &Mesh, from: Element, to: Element, ids: &BitSet) -> BitSet {
    match (from, to) {
        (Element::Vertex, Element::Edge | Element::Halfedge | Element::Face) => touching(mesh, to, ids),
        (Element::Edge, Element::Face) => {
            faces_beside(mesh, ids.iter().flat_map(|e| EdgeId::new(e).halfedges()), |_| true)
        }
        (Element::Halfedge, Element::Face) => faces_beside(mesh, ids.iter().map(HalfedgeId::new), |_| true),
        _ => convert(mesh, from, to, ids),
    }
}

/// The vertices of an element.
fn vertices(mesh: &Mesh, kind: Element, id: usize) -> Box<dyn Iterator<Item = VertexId> + '_> {
    match kind {
        Element::Vertex => Box::new(std::iter::once(VertexId::new(id))),
        Element::Edge => Box::new(mesh.ends(EdgeId::new(id)).into_iter()),
        Element::Halfedge => {
            Box::new([mesh.from(HalfedgeId::new(id)), mesh.to(HalfedgeId::new(id))].into_iter())
        }
        Element::Face => Box::new(mesh.face_vertices(FaceId::new(id))),
    }
}

/// The vertices of elements.
pub(super) fn vertices_of(mesh: &Mesh, kind: Element, ids: &BitSet) -> BitSet {
    ids.iter().flat_map(|id| vertices(mesh, kind, id)).map(VertexId::index).collect()
}

/// The elements of a kind that have one of these vertices.
pub(super) fn touching(mesh: &Mesh, kind: Element, vertices: &BitSet) -> BitSet {
    let mut found = BitSet::new();
    for v in vertices.iter().map(VertexId::new) {
        match kind {
            Element::Vertex => {
                found.insert(v.index());
            }
            Element::Edge => mesh.vertex_edges(v).for_each(|e| {
                found.insert(e.index());
            }),
            Element::Halfedge => mesh.outgoing(v).flat_map(|h| [h, h.twin()]).for_each(|h| {
                found.insert(h.index());
            }),
            Element::Face => mesh.vertex_faces(v).for_each(|f| {
                found.insert(f.index());
            }),
        }
    }
    found
}

fn face_halfedges<'a>(mesh: &'a Mesh, faces: &'a BitSet) -> impl Iterator<Item = HalfedgeId> + 'a {
    faces.iter().flat_map(|f| mesh.face_halfedges(FaceId::new(f)))
}

fn faces_beside(
    mesh: &Mesh,
    halfedges: impl Iterator<Item = HalfedgeId>,
    belongs: impl Fn(FaceId) -> bool,
) -> BitSet {
    halfedges.filter_map(|h| mesh.face_of(h)).filter(|&f| belongs(f)).map(FaceId::index).collect()
}
