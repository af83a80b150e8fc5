//! Bevel vertices: a face through points on its edges cuts each off.
//!
//! In each face round the vertex, the points on the corner's two edges replace the corner. The points round the vertex,
//! counter-clockwise, are the corners of the new face. On the boundary a boundary edge from the last point to the first
//! closes it; a boundary vertex with one face only loses its corner. Always possible, except for a vertex with two edges
//! inside the mesh, where the new face would have two corners: new edges join points of the same old face.
//!
//! A bevel wider than an edge is *clamped* to the edge's length, or to half of it if both ends are bevelled:
//! [`Slide::limit`].

use crate::edit::patch::{Corner, Patch, Plan};
use crate::edit::shared::{Followers, counter_clockwise};
use crate::edit::{Refusal, Slide, SlideVertex, SlidingEdit};
use crate::mesh::Mesh;
use crate::{FaceId, HalfedgeId, VertexId};
use rustc_hash::FxHashMap;

/// Whether [`bevel_vertices`] would succeed.
pub fn can_bevel_vertices(mesh: &Mesh, vertices: &[VertexId]) -> Result<(), Refusal> {
    plan_bevel(mesh, vertices).map(drop)
}

fn plan_bevel(mesh: &Mesh, vertices: &[VertexId]) -> Result<(Plan, Vec<SlideVertex>), Refusal> {
    mesh.require_vertices(vertices)?;
    let mut vertices = vertices.to_vec();
    vertices.sort_unstable();
    vertices.dedup();
    let mut patch = Patch::new(mesh);
    // The points on the edges of bevelled vertices, by the half-edges that leave those.
    let mut points: FxHashMap<HalfedgeId, VertexId> = FxHashMap::default();
    let mut moves = Vec::new();
    let mut faces: Vec<FaceId> = Vec::new();
    for &v in &vertices {
        let around = counter_clockwise(mesh, v);
        if around.is_empty() {
            return Err(Refusal::LeftWithoutFace(v));
        }
        if around.len() == 2 && !mesh.is_boundary_vertex(v) {
            return Err(Refusal::ValenceTooLow(v, 2));
        }
        // The new face has the attributes and corner values of the face at this corner.
        let source =
            around.iter().copied().filter(|&h| mesh.face_of(h).is_some()).min_by_key(|&h| mesh.face_of(h));
        let mut cap = Vec::new();
        for &h in &around {
            let point = patch.copy_vertex(mesh, v);
            points.insert(h, point);
            moves.push(SlideVertex { vertex: point, from: mesh.position(v), by: mesh.direction(h) });
            cap.extend(source.map(|corner| Corner::new(point, corner)));
        }
        if cap.len() > 2 {
            patch.add_face(source.and_then(|h| mesh.face_of(h)), cap);
        }
        faces.extend(mesh.vertex_faces(v));
    }
    faces.sort_unstable();
    faces.dedup();
    for face in faces {
        let mut corners = Vec::new();
        for h in mesh.face_halfedges(face) {
            match (points.get(&mesh.prev(h).twin()), points.get(&h)) {
                (Some(&before), Some(&after)) => {
                    corners.push(Corner::new(before, h));
                    corners.push(Corner::moved(after, h));
                }
                _ => corners.push(Corner::keep(mesh, h)),
            }
        }
        patch.replace_face(face, corners);
    }
    Ok((patch.plan(mesh)?, moves))
}

/// Cuts off each vertex with a face, without size: the slide's amount is the distance of the cut along each edge, in
/// mesh units.
///
/// Faces and edges keep their ids. Costs O(valences + degrees of the faces round the vertices). Attributes: new vertices
/// copy the bevelled one, new corners those that they are cut from, and both follow the slide over the faces. Each new
/// face copies the face with the smallest id round its vertex. New edges have default values.
pub fn bevel_vertices(mesh: &mut Mesh, vertices: &[VertexId]) -> Result<SlidingEdit, Refusal> {
    let (plan, moves) = plan_bevel(mesh, vertices)?;
    let followers = plan.followers(mesh, moves.iter().map(|slide| slide.vertex));
    let followers = Followers::new(mesh, followers, |_, _| true);
    let made = plan.apply(mesh);
    Ok(SlidingEdit { made, slide: Slide::limited(mesh, moves, followers) })
}
