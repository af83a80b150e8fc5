//! Rip edges: inner edges become pairs of boundary edges. The opposite of welding.
//!
//! The edges cut the faces round each of their vertices into groups; each group but the first gets
//! a vertex of its own. The result is a valid mesh exactly where each edge has an end that is cut
//! into two groups with the edge between them: an edge ripped alone inside the mesh would leave
//! two edges that join the same vertices. On a line of edges, or from the boundary, all have one.

use crate::edit::patch::{Corner, Patch, Plan};
use crate::edit::{Made, Refusal};
use crate::mesh::Mesh;
use crate::{EdgeId, FaceId, HalfedgeId, VertexId};
use rustc_hash::{FxHashMap, FxHashSet};

/// Whether [`rip_edges`] would succeed.
pub fn can_rip_edges(mesh: &Mesh, edges: &[EdgeId]) -> Result<(), Refusal> {
    plan_rip(mesh, edges).map(drop)
}

fn plan_rip(mesh: &Mesh, edges: &[EdgeId]) -> Result<Plan, Refusal> {
    mesh.require_edges(edges)?;
    let cut: FxHashSet<EdgeId> = edges.iter().copied().collect();
    if let Some(&edge) = edges.iter().find(|&&edge| mesh.is_boundary_edge(edge)) {
        return Err(Refusal::BoundaryEdge(edge));
    }
    let mut vertices: Vec<VertexId> = edges.iter().flat_map(|&edge| mesh.ends(edge)).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let mut patch = Patch::new(mesh);
    let mut moved: FxHashMap<HalfedgeId, VertexId> = FxHashMap::default();
    let mut faces: Vec<FaceId> = Vec::new();
    for v in vertices {
        // Clockwise, from a gap or a cut, so that no group goes round the end.
        let mut corners: Vec<HalfedgeId> = mesh.outgoing(v).collect();
        let start = corners.iter().position(|h| mesh.is_boundary_halfedge(*h));
        match start.or_else(|| corners.iter().position(|h| cut.contains(&h.edge()))) {
            // The corner after the gap, or after the cut, is the one that its half-edge's twin is beside.
            Some(start) => corners.rotate_left(start + 1),
            None => continue,
        }
        let mut group = 0;
        let mut vertex = v;
        for (i, &h) in corners.iter().enumerate() {
            // Corner h lies between its own edge and the one before it in this order.
            if i > 0 && cut.contains(&corners[i - 1].edge()) {
                group += 1;
                vertex = patch.copy_vertex(mesh, v);
            }
            if let Some(face) = mesh.face_of(h).filter(|_| group > 0) {
                moved.insert(h, vertex);
                faces.push(face);
            }
        }
    }
    let end = |h: HalfedgeId| moved.get(&h).copied().unwrap_or(mesh.from(h));
    for &edge in edges {
        let [h, twin] = edge.halfedges();
        if end(h) == end(mesh.next(twin)) && end(twin) == end(mesh.next(h)) {
            return Err(Refusal::StaysJoined(edge));
        }
    }
    faces.sort_unstable();
    faces.dedup();
    for face in faces {
        let corners = mesh.face_halfedges(face).map(|h| Corner::moved(end(h), h)).collect();
        patch.replace_face(face, corners);
    }
    patch.plan(mesh)
}

/// Cuts the mesh open along edges inside it: their sides become boundary edges, their vertices are
/// doubled in place where that parts their faces.
///
/// Faces keep their ids; an edge keeps its on one side. Costs O(valences of the vertices + degrees
/// of the faces there). Attributes: new vertices and edges copy those they came from.
pub fn rip_edges(mesh: &mut Mesh, edges: &[EdgeId]) -> Result<Made, Refusal> {
    Ok(plan_rip(mesh, edges)?.apply(mesh))
}
