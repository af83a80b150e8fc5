//! Triangulate: a polygon cut into triangles between its own corners.

use crate::edit::Refusal;
use crate::mesh::Mesh;
use crate::{EdgeId, FaceId};

/// What triangulating a face made; the face itself keeps its id as one of the triangles.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Triangulated {
    /// The cuts.
    pub edges: Vec<EdgeId>,
    /// The new triangles.
    pub faces: Vec<FaceId>,
}

/// Whether [`triangulate_face`] would succeed.
pub fn can_triangulate_face(mesh: &Mesh, face: FaceId) -> Result<(), Refusal> {
    mesh.need_face(face)?;
    let corners: Vec<_> = mesh.face_vertices(face).collect();
    // A fan joins the first corner to all but its neighbours in the face.
    let inner = corners.get(2..corners.len().saturating_sub(1)).unwrap_or_default();
    match inner.iter().find(|&&v| mesh.find_edge(corners[0], v).is_some()) {
        Some(&v) => Err(Refusal::AlreadyJoined(corners[0], v)),
        None => Ok(()),
    }
}

/// Cuts a face with n corners into a fan of n - 2 triangles from its first corner, with no new
/// vertex. A triangle is left as it is.
///
/// All ids survive. Costs O(n * valence of the first corner). Attributes: triangles copy the
/// face's, corners those of the corners they came from.
pub fn triangulate_face(mesh: &mut Mesh, face: FaceId) -> Result<Triangulated, Refusal> {
    can_triangulate_face(mesh, face)?;
    let mut made = Triangulated::default();
    let first = mesh.halfedge_of(face);
    for _ in 3..mesh.face_degree(face) {
        // Cut off the corner after the first: the new face is the triangle, the old one the rest.
        let start = mesh.halfedge_of(face);
        let third = mesh.next(mesh.next(start));
        let (across, triangle) = mesh.cut_face(start, third);
        made.edges.push(across.edge());
        made.faces.push(triangle);
    }
    debug_assert_eq!(mesh.from(mesh.halfedge_of(face)), mesh.from(first));
    Ok(made)
}
