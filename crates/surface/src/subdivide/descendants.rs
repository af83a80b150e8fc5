//! Which elements come from which, by the numbers that the splits give their children.

use super::Split;
use halfedge::geometry::BitSet;
use halfedge::{Element, FaceId, Mesh};

/// The elements of a subdivided mesh that lie on elements of the mesh that was subdivided: the pieces of faces, the pieces
/// of edges and half-edges, and the vertices themselves. Costs O(mesh + result).
pub fn descendants(mesh: &Mesh, split: Split, levels: u32, element: Element, of: &BitSet) -> BitSet {
    let mut set = compact_ids(mesh, element, of);
    for level in 0..levels {
        set = match (element, split) {
            (Element::Vertex, _) => return set,
            (Element::Face, Split::Quads) if level == 0 => quads_of_faces(mesh, &set),
            (Element::Face, _) => collect(set.iter().flat_map(|f| 4 * f..4 * f + 4)),
            (Element::Edge, _) => collect(set.iter().flat_map(|e| [2 * e, 2 * e + 1])),
            (Element::Halfedge, _) => collect(set.iter().flat_map(|h| [2 * h, 2 * (h ^ 1) + 1])),
        };
    }
    set
}

/// The ids that elements have once the gaps are closed that removed ones left.
pub fn compact_ids(mesh: &Mesh, element: Element, of: &BitSet) -> BitSet {
    if mesh.is_compact() {
        return of.clone();
    }
    let existing = (0..mesh.capacity(element)).filter(|&id| mesh.exists(element, id as u32));
    collect(existing.enumerate().filter(|&(_, id)| of.contains(id)).map(|(number, _)| number))
}

/// The quads at the corners of faces, which are numbered in order of face.
fn quads_of_faces(mesh: &Mesh, set: &BitSet) -> BitSet {
    let mut corner = 0;
    let ranges = mesh.faces().enumerate().map(|(number, face): (usize, FaceId)| {
        let first = corner;
        corner += mesh.face_degree(face);
        (number, first..corner)
    });
    collect(ranges.filter(|(number, _)| set.contains(*number)).flat_map(|(_, quads)| quads))
}

fn collect(ids: impl Iterator<Item = usize>) -> BitSet {
    let mut set = BitSet::new();
    ids.for_each(|id| {
        set.insert(id);
    });
    set
}
