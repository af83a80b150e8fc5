//! Lines of edges and strips of faces that run straight through a mesh of quads.

use halfedge::edit::edge_ring;
use halfedge::geometry::BitSet;
use halfedge::{EdgeId, Element, FaceId, HalfedgeId, Mesh, VertexId};

/// The edges that continue an edge in a straight line: through inner vertices with four edges, the opposite one; of a
/// boundary edge the boundary loop. The loop ends where it closes or at any other vertex. Costs O(edges of the loop).
pub fn edge_loop(mesh: &Mesh, edge: EdgeId) -> Vec<EdgeId> {
    let [start, back] = edge.halfedges();
    if let Some(h) = [start, back].into_iter().find(|&h| mesh.is_boundary_halfedge(h)) {
        return mesh.loop_of(h).map(HalfedgeId::edge).collect();
    }
    let onward = |h: HalfedgeId| {
        let v = mesh.to(h);
        (!mesh.is_boundary_vertex(v) && mesh.valence(v) == 4).then(|| mesh.next(mesh.next(h).twin()))
    };
    let mut edges = vec![edge];
    let mut at = start;
    while let Some(next) = onward(at) {
        if next == start {
            return edges;
        }
        edges.push(next.edge());
        at = next;
    }
    at = back;
    while let Some(next) = onward(at) {
        edges.push(next.edge());
        at = next;
    }
    edges
}

/// The quads that follow each other across an edge and the edges opposite it. Costs O(faces of the strip).
pub fn face_strip(mesh: &Mesh, edge: EdgeId) -> Vec<FaceId> {
    let (ring, _) = edge_ring(mesh, edge);
    let is_quad = |f: &FaceId| mesh.face_degree(*f) == 4;
    let mut faces: Vec<FaceId> = ring
        .iter()
        .flat_map(|&h| [mesh.face_of(h), mesh.face_of(h.twin())])
        .flatten()
        .filter(is_quad)
        .collect();
    faces.sort_unstable();
    faces.dedup();
    faces
}

/// The two kinds of lines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Line {
    /// Edges end to end ([`edge_loop`]) or their vertices; the half-edges of one face or boundary loop; faces that
    /// follow each other across edges ([`face_strip`]).
    Loop,
    /// Edges side by side across quads ([`edge_ring`]), their vertices, or their half-edges that point the same way;
    /// for faces the same as a loop.
    Ring,
}

/// The half-edges that give the direction of lines through a set: the selected ones, those of selected edges, of edges
/// between two selected vertices, and of edges between two selected faces. Costs O(set x valence).
pub fn directions(mesh: &Mesh, kind: Element, ids: &BitSet) -> Vec<HalfedgeId> {
    let set = ids.iter();
    match kind {
        Element::Halfedge => set.map(HalfedgeId::new).collect(),
        Element::Edge => set.map(|e| EdgeId::new(e).halfedge()).collect(),
        // Of the two half-edges of an edge, the one from the smaller id.
        Element::Vertex => set
            .map(VertexId::new)
            .flat_map(|v| mesh.outgoing(v).filter(move |&h| v < mesh.to(h)))
            .filter(|&h| ids.contains(mesh.to(h).index()))
            .collect(),
        Element::Face => set
            .map(FaceId::new)
            .flat_map(|f| mesh.face_halfedges(f).map(move |h| (f, h)))
            .filter(|&(f, h)| mesh.face_of(h.twin()).is_some_and(|g| f < g && ids.contains(g.index())))
            .map(|(_, h)| h)
            .collect(),
    }
}

/// The elements of a kind on the lines through some half-edges. Costs O(elements of the lines).
pub fn lines(mesh: &Mesh, kind: Element, through: &[HalfedgeId], line: Line) -> BitSet {
    let mut found = BitSet::new();
    // Edges, or half-edges of loops, that a line has passed: each lies on one line only.
    let mut passed = BitSet::new();
    for &h in through {
        if kind == Element::Halfedge && line == Line::Loop {
            if !passed.contains(h.index()) {
                for side in mesh.loop_of(h) {
                    passed.insert(side.index());
                    found.insert(side.index());
                }
            }
            continue;
        }
        if passed.contains(h.edge().index()) {
            continue;
        }
        let ring = || {
            let (ring, _) = edge_ring(mesh, h.edge());
            // All point the way of one of them.
            if ring.contains(&h) { ring } else { ring.into_iter().map(HalfedgeId::twin).collect() }
        };
        let halfedges: Vec<HalfedgeId> = match (kind, line) {
            (Element::Face, _) | (_, Line::Ring) => ring(),
            (_, Line::Loop) => edge_loop(mesh, h.edge()).into_iter().map(EdgeId::halfedge).collect(),
        };
        halfedges.iter().for_each(|h| {
            passed.insert(h.edge().index());
        });
        match kind {
            Element::Vertex => halfedges.iter().flat_map(|&h| [mesh.from(h), mesh.to(h)]).for_each(|v| {
                found.insert(v.index());
            }),
            Element::Edge => halfedges.iter().for_each(|h| {
                found.insert(h.edge().index());
            }),
            Element::Halfedge => halfedges.iter().for_each(|h| {
                found.insert(h.index());
            }),
            Element::Face => face_strip(mesh, h.edge()).iter().for_each(|f| {
                found.insert(f.index());
            }),
        }
    }
    found
}
