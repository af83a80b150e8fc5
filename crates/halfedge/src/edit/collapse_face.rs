//! Collapse face: all its corners become one vertex at its centroid.
//!
//! Each face round it loses a corner for each edge that they share; triangles across an edge vanish. The result is a
//! valid mesh under the conditions of [`merge_vertices`]: a face that touches two boundaries, or the same one twice,
//! would pinch the surface, for example.

use crate::edit::{Made, Refusal, can_merge_vertices, merge_vertices};
use crate::mesh::Mesh;
use crate::{FaceId, VertexId};

/// Whether [`collapse_face`] would succeed.
pub fn can_collapse_face(mesh: &Mesh, face: FaceId) -> Result<(), Refusal> {
    can_merge_vertices(mesh, &corners(mesh, face)?, None)
}

fn corners(mesh: &Mesh, face: FaceId) -> Result<Vec<VertexId>, Refusal> {
    mesh.require_face(face)?;
    Ok(mesh.face_vertices(face).collect())
}

/// Makes all corners of a face one vertex, the first one, at their mean.
///
/// Costs O(valences of the corners + degrees of the faces round them). Attributes: as in
/// [`merge_vertices`].
pub fn collapse_face(mesh: &mut Mesh, face: FaceId) -> Result<Made, Refusal> {
    let corners = corners(mesh, face)?;
    merge_vertices(mesh, &corners, None)
}
