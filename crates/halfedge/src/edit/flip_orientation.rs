//! Flip orientation: whole connected pieces are turned inside out.
//!
//! Two faces that share an edge must run along it in opposite directions, so either all faces of a piece turn or none. A
//! piece that turns as a whole stays a valid mesh: each loop runs the other way.

use crate::attribute::keys;
use crate::edit::Refusal;
use crate::mesh::Mesh;
use crate::{EdgeId, Element, FaceId, HalfedgeId, VertexId};
use rustc_hash::FxHashSet;

/// Whether [`flip_orientation`] would succeed. Costs O(corners of the faces).
pub fn can_flip_orientation(mesh: &Mesh, faces: &[FaceId]) -> Result<(), Refusal> {
    mesh.require_faces(faces)?;
    let chosen: FxHashSet<FaceId> = faces.iter().copied().collect();
    for &face in faces {
        let others = mesh.face_halfedges(face).filter_map(|h| mesh.face_of(h.twin()));
        if others.into_iter().any(|other| !chosen.contains(&other)) {
            return Err(Refusal::NotAWholePiece(face));
        }
    }
    Ok(())
}

/// Turns whole connected pieces inside out.
///
/// All ids survive, and each face keeps its first corner; half-edges are reversed and stay in their face. Costs O(n log n)
/// in the corners of the faces. Attributes: corner values stay with their corners, and corner normals are negated.
pub fn flip_orientation(mesh: &mut Mesh, faces: &[FaceId]) -> Result<(), Refusal> {
    can_flip_orientation(mesh, faces)?;
    let mut edges: Vec<EdgeId> = Vec::new();
    let mut vertices: Vec<VertexId> = Vec::new();
    for &face in faces {
        edges.extend(mesh.face_halfedges(face).map(HalfedgeId::edge));
        vertices.extend(mesh.face_vertices(face));
    }
    edges.sort_unstable();
    edges.dedup();
    vertices.sort_unstable();
    vertices.dedup();
    let mut chosen = faces.to_vec();
    chosen.sort_unstable();
    chosen.dedup();

    // A half-edge will leave the corner that it points to now, and get its values.
    let sides: Vec<HalfedgeId> = edges.iter().flat_map(|edge| edge.halfedges()).collect();
    let corners: Vec<(HalfedgeId, HalfedgeId)> =
        sides.iter().filter(|&&h| mesh.face_of(h).is_some()).map(|&h| (mesh.next(h), h)).collect();
    mesh.copy_corners(&corners);
    if mesh.column(Element::Halfedge, keys::CORNER_NORMAL.name).is_some() {
        for &(_, h) in &corners {
            let normal = mesh.get(keys::CORNER_NORMAL, h.index());
            mesh.set(keys::CORNER_NORMAL, h.index(), -normal);
        }
    }
    let firsts: Vec<(FaceId, HalfedgeId)> =
        chosen.iter().map(|&face| (face, mesh.prev(mesh.halfedge_of(face)))).collect();
    let leaving: Vec<(VertexId, HalfedgeId)> = vertices
        .iter()
        .filter_map(|&v| {
            // What leaves the vertex afterwards arrives at it now; on the boundary it is a boundary half-edge.
            Some((v, mesh.prev(mesh.halfedge_from(v)?)))
        })
        .collect();
    let links: Vec<(HalfedgeId, HalfedgeId)> = sides.iter().map(|&h| (mesh.next(h), h)).collect();
    for edge in edges {
        let [a, b] = mesh.ends(edge);
        let [h, twin] = edge.halfedges();
        mesh.set_to(h, a);
        mesh.set_to(twin, b);
    }
    for (h, next) in links {
        mesh.link(h, next);
    }
    for (face, h) in firsts {
        mesh.set_face_halfedge(face, h);
    }
    for (v, h) in leaving {
        mesh.set_vertex_halfedge(v, Some(h));
    }
    Ok(())
}
