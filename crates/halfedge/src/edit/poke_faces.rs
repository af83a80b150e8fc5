//! Poke faces: a new vertex at each face's centre, joined to all its corners.
//!
//! Always possible: the new edges end at the new vertex, and a face of n corners becomes n triangles that take its sides.
//! The Euler characteristic and the boundary stay the same.

use crate::attribute::Value;
use crate::edit::patch::{Corner, Patch, Plan};
use crate::edit::shared::Blend;
use crate::edit::{Made, Refusal};
use crate::mesh::Mesh;
use crate::{Element, FaceId, HalfedgeId};

/// Whether [`poke_faces`] would succeed: it does if the faces exist.
pub fn can_poke_faces(mesh: &Mesh, faces: &[FaceId]) -> Result<(), Refusal> {
    plan_poke(mesh, faces).map(drop)
}

/// Per face and column of half-edges: the mean of the corners, which the corners at the centre get.
type Means = Vec<Vec<Option<Value>>>;

fn plan_poke(mesh: &Mesh, faces: &[FaceId]) -> Result<(Plan, Means), Refusal> {
    mesh.require_faces(faces)?;
    let mut faces = faces.to_vec();
    faces.sort_unstable();
    faces.dedup();
    let mut patch = Patch::new(mesh);
    let mut means = Vec::with_capacity(faces.len());
    for &face in &faces {
        let sides: Vec<HalfedgeId> = mesh.face_halfedges(face).collect();
        let mean = Blend::Mean(sides.iter().map(|h| h.raw()).collect());
        means.push(mesh.columns.of(Element::Halfedge).iter().map(|column| mean.of(column)).collect());
        let corners = mesh.face_vertices(face).map(|v| v.raw()).collect();
        let center = patch.add_vertex(mesh.corner_mean(face), Blend::Mean(corners));
        for (i, &h) in sides.iter().enumerate() {
            let next = sides[(i + 1) % sides.len()];
            let corners =
                vec![Corner::keep(mesh, h), Corner::new(mesh.from(next), next), Corner::new(center, h)];
            if i == 0 {
                patch.replace_face(face, corners);
            } else {
                patch.add_face(Some(face), corners);
            }
        }
    }
    Ok((patch.plan(mesh)?, means))
}

/// Cuts each face into triangles round a new vertex at the mean of its corners.
///
/// A face keeps its id as the triangle at its first side. Costs O(corners + valences). Attributes: triangles copy the
/// face; the new vertex and its corners have the mean of the old corners.
pub fn poke_faces(mesh: &mut Mesh, faces: &[FaceId]) -> Result<Made, Refusal> {
    let (plan, means) = plan_poke(mesh, faces)?;
    let made = plan.apply(mesh);
    // The mean is computed once per face, not for each of its triangles.
    for (&center, mean) in made.vertices.iter().zip(means) {
        let corners: Vec<HalfedgeId> = mesh.outgoing(center).collect();
        for (column, value) in mean.into_iter().enumerate() {
            let Some(value) = value else { continue };
            for h in &corners {
                mesh.set_value(Element::Halfedge, column, h.index(), value);
            }
        }
    }
    Ok(made)
}
