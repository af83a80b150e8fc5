//! Dissolve vertex: the faces around it become one polygon without it.
//!
//! - Inside, with three faces or more: the polygon is their outline. It is one loop with all
//!   corners different exactly where each two of the faces share no more than a row of edges.
//! - Inside, with two: both faces stay and lose the corner; the two edges become one. This undoes
//!   a split. Triangles have no corner to lose and refuse.
//! - On the boundary: the outline without the vertex, whose two boundary neighbours are joined by an
//!   edge: one that was at the vertex if it had only one face, else a new one. A lone triangle has no
//!   corner to lose and refuses.
//!
//! What would duplicate an edge, or leave another vertex with no face, is refused.

use crate::attribute::keys;
use crate::edit::patch::{Corner, Patch, Plan, plan};
use crate::edit::region::outline;
use crate::edit::{Made, Refusal};
use crate::mesh::Mesh;
use crate::{FaceId, HalfedgeId, VertexId};
use rustc_hash::FxHashSet;

/// Whether [`dissolve_vertex`] would succeed.
pub fn can_dissolve_vertex(mesh: &Mesh, vertex: VertexId) -> Result<(), Refusal> {
    plan_dissolve(mesh, vertex).map(drop)
}

fn plan_dissolve(mesh: &Mesh, vertex: VertexId) -> Result<Plan, Refusal> {
    mesh.need_vertex(vertex)?;
    let faces: FxHashSet<FaceId> = mesh.vertex_faces(vertex).collect();
    let Some(&keep) = faces.iter().min() else {
        return Err(Refusal::LeftWithoutFace(vertex));
    };
    let inside = !mesh.is_boundary_vertex(vertex);
    // Inside with two faces, and on the boundary, the two outer neighbours get an edge.
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
            patch.replace_face(face, corners, false);
        }
    } else {
        patch.remove.extend(faces.iter().copied().filter(|&face| face != keep));
        let mut corners = Vec::new();
        for h in outline(mesh, &faces)?.into_iter().filter(|&h| mesh.from(h) != vertex) {
            let like = if mesh.to(h) != vertex {
                Some(h)
            } else if faces.len() == 1 {
                // The two edges become one, the sharper.
                let after = mesh.next(h);
                let crease = |h: HalfedgeId| mesh.get(keys::EDGE_CREASE, h.edge().index());
                Some(if crease(after) > crease(h) { after } else { h })
            } else {
                None
            };
            corners.push(Corner { like, ..Corner::keep(mesh, h) });
        }
        corners_left = corners.len();
        patch.replace_face(keep, corners, false);
    }
    if let &[a, b] = ends.as_slice()
        && corners_left >= 3
        && mesh.joined(a, b).is_some()
    {
        return Err(Refusal::AlreadyJoined(a, b));
    }
    plan(mesh, patch)
}

/// Makes the faces around a vertex one polygon, the face with the smallest id, and removes the
/// vertex. One with two faces inside the mesh only goes from both; see the module's text.
///
/// Other vertices that had no edges but to the merged faces' insides go too. Costs O(degrees of
/// the faces + valences of their corners). Attributes: the polygon keeps those of the face whose
/// id it keeps; corners keep theirs.
pub fn dissolve_vertex(mesh: &mut Mesh, vertex: VertexId) -> Result<Made, Refusal> {
    Ok(plan_dissolve(mesh, vertex)?.apply(mesh))
}
