//! Rip edges: inner edges become pairs of boundary edges. The opposite of welding.
//!
//! The edges cut the faces round each of their vertices into groups, and each group but the first gets a vertex of its
//! own. The result is a valid mesh exactly if each edge has an end where it separates two groups. A single edge inside the
//! mesh has none: two edges would join the same vertices. Edges on a line of several, or with an end on the boundary, all
//! have one.

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
        // Clockwise from the gap or a cut, so that no group goes round the end.
        let mut corners: Vec<HalfedgeId> = mesh.outgoing(v).collect();
        let start = corners.iter().position(|h| mesh.is_boundary_halfedge(*h));
        match start.or_else(|| corners.iter().position(|h| cut.contains(&h.edge()))) {
            // The first corner lies after the half-edge of the gap or cut.
            Some(start) => corners.rotate_left(start + 1),
            None => continue,
        }
        let mut group = 0;
        let mut vertex = v;
        for (i, &h) in corners.iter().enumerate() {
            // The corner of h lies between its edge and the edge before it.
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

/// Cuts the mesh open along edges inside it. Their sides become boundary edges, and their vertices are doubled in place
/// where that separates faces.
///
/// Faces keep their ids, and each edge keeps its id on one side. Costs O(valences of the vertices + degrees of the faces
/// there). Attributes: new vertices and edges copy the old ones.
pub fn rip_edges(mesh: &mut Mesh, edges: &[EdgeId]) -> Result<Made, Refusal> {
    Ok(plan_rip(mesh, edges)?.apply(mesh))
}
