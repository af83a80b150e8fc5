//! Delete faces and delete vertices: they leave holes.
//!
//! Always possible: edges left with no face go, as do vertices left with none, and a vertex whose
//! faces left over touch only at it (a bow-tie) is *separated*: each group of faces but the first
//! gets a vertex of its own in the same place. So the result is a valid mesh whatever is deleted.

use crate::edit::patch::{Patch, plan};
use crate::edit::{Made, Refusal};
use crate::mesh::Mesh;
use crate::{Element, FaceId, VertexId};

/// Whether [`delete_faces`] would succeed: it does if the faces exist.
pub fn can_delete_faces(mesh: &Mesh, faces: &[FaceId]) -> Result<(), Refusal> {
    mesh.need_faces(faces)
}

/// Removes faces, and the edges and vertices that no face is left at. Bow-ties are separated: the
/// new vertices are in [`Made::vertices`], with the position and attributes of the old one.
///
/// Costs O(n log n) in the corners of the faces and the valences of their vertices.
pub fn delete_faces(mesh: &mut Mesh, faces: &[FaceId]) -> Result<Made, Refusal> {
    can_delete_faces(mesh, faces)?;
    let patch = Patch { remove: faces.to_vec(), separate: true, ..Patch::new(mesh) };
    Ok(plan(mesh, patch)?.apply(mesh))
}

/// Whether [`delete_vertices`] would succeed: it does if the vertices exist.
pub fn can_delete_vertices(mesh: &Mesh, vertices: &[VertexId]) -> Result<(), Refusal> {
    mesh.need_vertices(vertices)
}

/// Removes vertices with all faces round them, and the edges and other vertices that no face is
/// left at. Isolated vertices can be deleted too. Bow-ties are separated, as by [`delete_faces`].
///
/// Costs O(n log n) in the corners of the faces and the valences of their vertices.
pub fn delete_vertices(mesh: &mut Mesh, vertices: &[VertexId]) -> Result<Made, Refusal> {
    can_delete_vertices(mesh, vertices)?;
    let remove = vertices.iter().flat_map(|&v| mesh.vertex_faces(v)).collect();
    let patch = Patch { remove, separate: true, ..Patch::new(mesh) };
    let mut made = plan(mesh, patch)?.apply(mesh);
    for &v in vertices {
        if mesh.has_vertex(v) {
            mesh.mark(Element::Vertex, v.raw(), true);
            made.removed_vertices.push(v);
        }
    }
    Ok(made)
}
