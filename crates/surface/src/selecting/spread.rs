//! Growing, shrinking, and whole connected pieces.

use super::convert::{touching, vertices_of};
use halfedge::geometry::BitSet;
use halfedge::{EdgeId, Element, FaceId, HalfedgeId, Mesh, VertexId};

/// The set with its neighbours: elements that share a vertex with it; for vertices those that share a face or an edge
/// with one of them. Costs O(set x valence).
pub fn grow(mesh: &Mesh, kind: Element, ids: &BitSet) -> BitSet {
    if kind != Element::Vertex {
        return touching(mesh, kind, &vertices_of(mesh, kind, ids));
    }
    let mut grown = ids.clone();
    for v in ids.iter().map(VertexId::new) {
        for w in mesh.neighbors(v).chain(mesh.vertex_faces(v).flat_map(|f| mesh.face_vertices(f))) {
            grown.insert(w.index());
        }
    }
    grown
}

/// The set without the elements that have neighbours outside it, as [`grow`] counts neighbours. Elements at a boundary
/// of the mesh stay where only the boundary is beside them. Costs O(set x valence).
pub fn shrink(mesh: &Mesh, kind: Element, ids: &BitSet) -> BitSet {
    let around = grow(mesh, kind, ids);
    let outside: BitSet = around.iter().filter(|&id| !ids.contains(id)).collect();
    let near = grow(mesh, kind, &outside);
    ids.iter().filter(|&id| !near.contains(id)).collect()
}

/// All elements of the connected pieces that have an element in the set. Costs O(pieces).
pub fn linked(mesh: &Mesh, kind: Element, ids: &BitSet) -> BitSet {
    let mut reached = vertices_of(mesh, kind, ids);
    let mut front: Vec<VertexId> = reached.iter().map(VertexId::new).collect();
    while let Some(v) = front.pop() {
        for w in mesh.neighbors(v) {
            if reached.insert(w.index()) {
                front.push(w);
            }
        }
    }
    let has = |v: VertexId| reached.contains(v.index());
    match kind {
        Element::Vertex => reached,
        // All vertices of an element lie in the same piece.
        Element::Edge => all(mesh, kind, |id| has(mesh.ends(EdgeId::new(id))[0])),
        Element::Halfedge => all(mesh, kind, |id| has(mesh.to(HalfedgeId::new(id)))),
        Element::Face => all(mesh, kind, |id| has(mesh.to(mesh.halfedge_of(FaceId::new(id))))),
    }
}

fn all(mesh: &Mesh, kind: Element, belongs: impl Fn(usize) -> bool) -> BitSet {
    (0..mesh.capacity(kind)).filter(|&id| mesh.exists(kind, id as u32) && belongs(id)).collect()
}
