//! Poke faces: a new vertex at each face's centroid, joined to all its corners.
//!
//! Always possible: the new edges join the new vertex, and a face of n corners becomes n triangles
//! that take its sides. The Euler characteristic stays, as does the boundary.

use crate::edit::patch::{Corner, Patch, Plan};
use crate::edit::shared::Blend;
use crate::edit::{Made, Refusal};
use crate::mesh::Mesh;
use crate::{FaceId, HalfedgeId};

/// Whether [`poke_faces`] would succeed: it does if the faces exist.
pub fn can_poke_faces(mesh: &Mesh, faces: &[FaceId]) -> Result<(), Refusal> {
    plan_poke(mesh, faces).map(drop)
}

fn plan_poke(mesh: &Mesh, faces: &[FaceId]) -> Result<Plan, Refusal> {
    mesh.require_faces(faces)?;
    let mut faces = faces.to_vec();
    faces.sort_unstable();
    faces.dedup();
    let mut patch = Patch::new(mesh);
    for &face in &faces {
        let sides: Vec<HalfedgeId> = mesh.face_halfedges(face).collect();
        let raw_sides: Vec<u32> = sides.iter().map(|h| h.raw()).collect();
        let corners = mesh.face_vertices(face).map(|v| v.raw()).collect();
        let center = patch.add_vertex(mesh.corner_mean(face), Blend::Mean(corners));
        for (i, &h) in sides.iter().enumerate() {
            let next = sides[(i + 1) % sides.len()];
            let tip = Corner { vertex: center, value: Blend::Mean(raw_sides.clone()), replaces: None };
            let triangle = vec![Corner::keep(mesh, h), Corner::new(mesh.from(next), next), tip];
            if i == 0 {
                patch.replace_face(face, triangle);
            } else {
                patch.add_face(Some(face), triangle);
            }
        }
    }
    patch.plan(mesh)
}

/// Cuts each face into triangles round a new vertex at its centroid (the mean of its corners).
///
/// A face keeps its id as the triangle at its first side. Costs O(corners + valences), and for a
/// face of n corners n more per attribute and triangle. Attributes: triangles copy the face's,
/// the new vertex and its corners have the mean of the corners'.
pub fn poke_faces(mesh: &mut Mesh, faces: &[FaceId]) -> Result<Made, Refusal> {
    Ok(plan_poke(mesh, faces)?.apply(mesh))
}
