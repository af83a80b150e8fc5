//! Delete faces and delete vertices: they leave holes.
//!
//! Always possible. Edges and vertices left without a face are removed. A vertex whose remaining faces touch only at
//! it (a bow-tie) is *separated*: each group of faces but the first gets a vertex of its own in the same place. So the
//! result is a valid mesh whatever is deleted.

use crate::edit::patch::Patch;
use crate::edit::{Made, Refusal};
use crate::mesh::Mesh;
use crate::{Element, FaceId, VertexId};

/// Whether [`delete_faces`] would succeed: it does if the faces exist.
pub fn can_delete_faces(mesh: &Mesh, faces: &[FaceId]) -> Result<(), Refusal> {
    mesh.require_faces(faces)
}

/// Removes faces, and edges and vertices that are left without a face. Bow-ties are separated: their new vertices, in
/// [`Made::vertices`], have the position and attributes of the old ones.
///
/// Costs O(n log n) in the corners of the faces and the valences of their vertices.
pub fn delete_faces(mesh: &mut Mesh, faces: &[FaceId]) -> Result<Made, Refusal> {
    can_delete_faces(mesh, faces)?;
    remove(mesh, faces.to_vec())
}

fn remove(mesh: &mut Mesh, faces: Vec<FaceId>) -> Result<Made, Refusal> {
    let mut patch = Patch::new(mesh);
    patch.remove = faces;
    patch.separates_fans = true;
    Ok(patch.plan(mesh)?.apply(mesh))
}

/// Whether [`delete_vertices`] would succeed: it does if the vertices exist.
pub fn can_delete_vertices(mesh: &Mesh, vertices: &[VertexId]) -> Result<(), Refusal> {
    mesh.require_vertices(vertices)
}

/// Removes vertices with all faces round them, and edges and other vertices that are left without a face. Isolated
/// vertices can be deleted too. Bow-ties are separated, as by [`delete_faces`].
///
/// Costs O(n log n) in the corners of the faces and the valences of their vertices.
pub fn delete_vertices(mesh: &mut Mesh, vertices: &[VertexId]) -> Result<Made, Refusal> {
    can_delete_vertices(mesh, vertices)?;
    let faces = vertices.iter().flat_map(|&v| mesh.vertex_faces(v)).collect();
    let mut made = remove(mesh, faces)?;
    for &v in vertices {
        if mesh.has_vertex(v) {
            mesh.mark(Element::Vertex, v.raw(), true);
            made.removed_vertices.push(v);
        }
    }
    Ok(made)
}
