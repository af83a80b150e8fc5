//! Connect vertices: an edge between two corners cuts a face in two.
//!
//! Possible exactly if some face has both and no edge joins them (neighbours in a face are joined). Then both parts have
//! three corners or more, and the cut is a new edge with a face on either side.

use crate::edit::Refusal;
use crate::mesh::Mesh;
use crate::{EdgeId, FaceId, HalfedgeId, VertexId};

/// The result of connecting two vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Connected {
    /// The face that was cut. It keeps the part from the second vertex to the first.
    pub face: FaceId,
    /// The cut.
    pub edge: EdgeId,
    /// The new face.
    pub new_face: FaceId,
}

/// Whether [`connect_vertices`] would succeed.
pub fn can_connect_vertices(mesh: &Mesh, a: VertexId, b: VertexId) -> Result<(), Refusal> {
    corners(mesh, a, b).map(drop)
}

/// A face that has both vertices, and its corners there.
fn corners(mesh: &Mesh, a: VertexId, b: VertexId) -> Result<(FaceId, HalfedgeId, HalfedgeId), Refusal> {
    mesh.require_vertex(a)?;
    mesh.require_vertex(b)?;
    if a == b {
        return Err(Refusal::GivenTwice(crate::Element::Vertex, a.raw()));
    }
    if mesh.find_halfedge_between(a, b).is_some() {
        return Err(Refusal::AlreadyJoined(a, b));
    }
    for at_a in mesh.outgoing(a) {
        let Some(face) = mesh.face_of(at_a) else { continue };
        if let Some(at_b) = mesh.loop_of(at_a).find(|&h| mesh.from(h) == b) {
            return Ok((face, at_a, at_b));
        }
    }
    Err(Refusal::NotInOneFace(a, b))
}

/// Cuts the face that has both vertices from one to the other. Of several such faces it cuts the first one round `a`.
///
/// All ids survive. Costs O(valence of `a` * degree of the faces). Attributes: the new face copies the old one, the new
/// corners those of the old face at the vertices.
pub fn connect_vertices(mesh: &mut Mesh, a: VertexId, b: VertexId) -> Result<Connected, Refusal> {
    let (face, at_a, at_b) = corners(mesh, a, b)?;
    let (across, new_face) = mesh.cut_face(at_a, at_b);
    Ok(Connected { face, edge: across.edge(), new_face })
}
