//! Dissolve vertex: the faces around it become one polygon without it.
//!
//! - Inside the mesh, with three faces or more: the polygon is their outline. It is one loop with different corners
//!   exactly if no two of the faces share more than one row of edges.
//! - Inside, with two faces: both stay and lose the corner, and the two edges become one. This undoes a split.
//!   Refused where a triangle would lose a corner.
//! - On the boundary: the polygon is the outline without the vertex. An edge joins the vertex's two neighbours on
//!   the boundary: one of its own if it had one face, else a new one. Refused where a triangle is all there is.
//!
//! Refused where an edge would be duplicated or another vertex left without a face.

use crate::attribute::keys;
use crate::edit::patch::{Corner, Patch, Plan};
use crate::edit::shared::outline;
use crate::edit::{Made, Refusal};
use crate::mesh::Mesh;
use crate::{FaceId, HalfedgeId, VertexId};
use rustc_hash::FxHashSet;

/// Whether [`dissolve_vertex`] would succeed.
pub fn can_dissolve_vertex(mesh: &Mesh, vertex: VertexId) -> Result<(), Refusal> {
    plan_dissolve(mesh, vertex).map(drop)
}

fn plan_dissolve(mesh: &Mesh, vertex: VertexId) -> Result<Plan, Refusal> {
    mesh.require_vertex(vertex)?;
    let faces: FxHashSet<FaceId> = mesh.vertex_faces(vertex).collect();
    let Some(&keep) = faces.iter().min() else {
        return Err(Refusal::LeftWithoutFace(vertex));
    };
    let inside = !mesh.is_boundary_vertex(vertex);
    // The neighbours that an edge will join: inside with two faces, and on the boundary.
    let ends: Vec<VertexId> = if inside && faces.len() > 2 {
        Vec::new()
    } else {
        mesh.outgoing(vertex)
            .filter(|h| inside || mesh.is_boundary_edge(h.edge()))
            .map(|h| mesh.to(h))
            .collect()
    };
    let mut patch = Patch::new(mesh);
    let mut corners_left = usize::MAX;
    if inside && faces.len() == 2 {
        for &face in &faces {
            let corners: Vec<Corner> = mesh
                .face_halfedges(face)
                .filter(|&h| mesh.from(h) != vertex)
                .map(|h| Corner::keep(mesh, h))
                .collect();
            corners_left = corners_left.min(corners.len());
            patch.replace_face(face, corners);
        }
    } else {
        patch.remove.extend(faces.iter().copied().filter(|&face| face != keep));
        let mut corners = Vec::new();
        for h in outline(mesh, &faces)?.into_iter().filter(|&h| mesh.from(h) != vertex) {
            let replaces = if mesh.to(h) != vertex {
                Some(h)
            } else if faces.len() == 1 {
                // The two edges become one, the sharper.
                let after = mesh.next(h);
                let crease = |h: HalfedgeId| mesh.get(keys::EDGE_CREASE, h.edge().index());
                Some(if crease(after) > crease(h) { after } else { h })
            } else {
                None
            };
            corners.push(Corner { replaces, ..Corner::keep(mesh, h) });
        }
        corners_left = corners.len();
        patch.replace_face(keep, corners);
    }
    if let &[a, b] = ends.as_slice()
        && corners_left >= 3
        && mesh.find_halfedge_between(a, b).is_some()
    {
        return Err(Refusal::AlreadyJoined(a, b));
    }
    patch.plan(mesh)
}

/// Makes the faces around a vertex one polygon, the face with the smallest id, and removes the vertex. A vertex
/// with two faces inside the mesh is only removed from both; see the module's text.
///
/// Other vertices whose edges all lie inside the polygon are removed too. Costs O(degrees of the faces + valences
/// of their corners). Attributes: the polygon keeps those of the face whose id it keeps; corners keep theirs. Of
/// edges that become one the sharper crease stays.
pub fn dissolve_vertex(mesh: &mut Mesh, vertex: VertexId) -> Result<Made, Refusal> {
    Ok(plan_dissolve(mesh, vertex)?.apply(mesh))
}
