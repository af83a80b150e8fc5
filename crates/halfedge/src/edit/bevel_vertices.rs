//! Bevel vertices: each is cut off by a face through points on its edges.
//!
//! Each face round the vertex has the corner replaced by the points on its two edges there, and the
//! points round the vertex, counter-clockwise, are the new face's corners. On the boundary the new
//! face ends with a boundary edge from the last point to the first; a vertex of one face there is
//! just cut off its corner. Always possible but for a vertex inside with two edges, where the new
//! face would have two corners: new points are joined to their neighbours in the same face.
//!
//! A bevel wider than an edge is *clamped* to the edge's length, or half of it where both ends are
//! bevelled: [`Slide::limit`].

use crate::edit::patch::{Corner, Patch, Plan};
use crate::edit::shared::Followers;
use crate::edit::{Live, Refusal, Slide, SlideVertex};
use crate::mesh::Mesh;
use crate::{FaceId, HalfedgeId, VertexId};
use rustc_hash::FxHashMap;

/// Whether [`bevel_vertices`] would succeed.
pub fn can_bevel_vertices(mesh: &Mesh, vertices: &[VertexId]) -> Result<(), Refusal> {
    plan_bevel(mesh, vertices).map(drop)
}

/// The half-edges that leave a vertex, counter-clockwise; on the boundary from the edge after the
/// gap to the one before it.
pub(crate) fn counter_clockwise(mesh: &Mesh, v: VertexId) -> Vec<HalfedgeId> {
    let mut all: Vec<HalfedgeId> = mesh.outgoing(v).collect();
    all.reverse();
    all
}

fn plan_bevel(mesh: &Mesh, vertices: &[VertexId]) -> Result<(Plan, Vec<SlideVertex>), Refusal> {
    mesh.require_vertices(vertices)?;
    let mut vertices = vertices.to_vec();
    vertices.sort_unstable();
    vertices.dedup();
    let mut patch = Patch::new(mesh);
    // The point on each edge of a bevelled vertex, by the half-edge that leaves it.
    let mut points: FxHashMap<HalfedgeId, VertexId> = FxHashMap::default();
    let mut moves = Vec::new();
    let mut faces: Vec<FaceId> = Vec::new();
    for &v in &vertices {
        let around = counter_clockwise(mesh, v);
        if around.is_empty() {
            return Err(Refusal::LeftWithoutFace(v));
        }
        let boundary = mesh.is_boundary_vertex(v);
        if around.len() == 2 && !boundary {
            return Err(Refusal::ValenceTooLow(v, 2));
        }
        // The new face is like this one, so its corners follow this one's.
        let like =
            around.iter().copied().filter(|&h| mesh.face_of(h).is_some()).min_by_key(|&h| mesh.face_of(h));
        let mut cap = Vec::new();
        for &h in &around {
            let point = patch.copy_vertex(mesh, v);
            points.insert(h, point);
            moves.push(SlideVertex { vertex: point, from: mesh.position(v), by: mesh.direction(h) });
            cap.extend(like.map(|corner| Corner::new(point, corner)));
        }
        if cap.len() > 2 {
            patch.add_face(like.and_then(|h| mesh.face_of(h)), cap);
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

/// Cuts off vertices with a face each, of no size yet: the slide's amount is how far along each
/// edge the cut is, in mesh units.
///
/// Faces and edges keep their ids. Costs O(valences + degrees of the faces round the vertices).
/// Attributes: new vertices copy the bevelled one, corners the one they are cut from, and follow the slide
/// over the faces; each new face
/// copies the face with the smallest id round its vertex; its edges have default values.
pub fn bevel_vertices(mesh: &mut Mesh, vertices: &[VertexId]) -> Result<Live, Refusal> {
    let (plan, moves) = plan_bevel(mesh, vertices)?;
    let followers = plan.followers(mesh, moves.iter().map(|slide| slide.vertex));
    let followers = Followers::new(mesh, followers, |_, _| true);
    let made = plan.apply(mesh);
    Ok(Live { made, slide: Slide::limited(mesh, moves, followers) })
}
