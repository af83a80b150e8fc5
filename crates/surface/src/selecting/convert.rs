//! Sets that follow from a set, found at once.

use super::finding::Finding;
use halfedge::geometry::BitSet;
use halfedge::{Element, InParts, Mesh};

/// Converts a set of elements of a kind to another kind: to the vertices, edges and half-edges of its elements, or to
/// the edges, half-edges and faces that have all their vertices (for faces, also all their edges or half-edges) in it.
/// Both half-edges of an edge stand for it; those of a face are the ones inside it. Costs O(set x valence).
pub fn convert(mesh: &Mesh, from: Element, to: Element, ids: &BitSet) -> BitSet {
    Finding::convert(from, to, ids.clone()).finish(mesh)
}

/// Converts like [`convert`], but to every edge, half-edge and face that has any of the elements: a vertex, or for faces
/// one of their edges or half-edges. Costs O(set x valence).
pub fn expand(mesh: &Mesh, from: Element, to: Element, ids: &BitSet) -> BitSet {
    Finding::expand(from, to, ids.clone()).finish(mesh)
}

/// The set with its neighbours: elements that share a vertex with it; for vertices those that share a face or an edge
/// with one of them. Costs O(set x valence).
pub fn grow(mesh: &Mesh, kind: Element, ids: &BitSet) -> BitSet {
    Finding::grow(kind, ids.clone()).finish(mesh)
}

/// The set without the elements that have neighbours outside it, as [`grow`] counts neighbours. Elements at a boundary
/// of the mesh stay where only the boundary is beside them. Costs O(set x valence).
pub fn shrink(mesh: &Mesh, kind: Element, ids: &BitSet) -> BitSet {
    Finding::shrink(kind, ids.clone()).finish(mesh)
}

/// All elements of the connected pieces that have an element in the set. Costs O(pieces).
pub fn linked(mesh: &Mesh, kind: Element, ids: &BitSet) -> BitSet {
    Finding::linked(kind, ids.clone()).finish(mesh)
}

/// The edges between faces of a set and others, and boundary edges of its faces. Costs O(set x corners).
pub fn outline(mesh: &Mesh, faces: &BitSet) -> BitSet {
    Finding::outline(faces.clone()).finish(mesh)
}
