//! Set crease: how sharp edges and vertices stay in subdivision.

use crate::attribute::keys;
use crate::edit::Refusal;
use crate::mesh::Mesh;
use crate::{EdgeId, Element, NumberRange, VertexId};

/// Sharpness: 0 is smooth, 10 or more infinitely sharp.
pub const CREASE_SHARPNESS_RANGE: NumberRange = NumberRange::NOT_NEGATIVE;

/// Whether [`set_crease`] would succeed: it does for existing elements and a finite sharpness of 0 or more.
pub fn can_set_crease(
    mesh: &Mesh,
    edges: &[EdgeId],
    vertices: &[VertexId],
    sharpness: f32,
) -> Result<(), Refusal> {
    if edges.is_empty() && vertices.is_empty() {
        return Err(Refusal::NothingGiven(Element::Edge));
    }
    edges.iter().try_for_each(|&e| mesh.require_edge(e))?;
    vertices.iter().try_for_each(|&v| mesh.require_vertex(v))?;
    CREASE_SHARPNESS_RANGE.require("sharpness", sharpness)
}

/// Sets the sharpness of edges and vertices, in the columns [`keys::EDGE_CREASE`] and [`keys::VERTEX_CREASE`]: 0 is
/// smooth, 10 or more infinitely sharp. Costs O(elements), and O(mesh) the first time, to add a column.
pub fn set_crease(
    mesh: &mut Mesh,
    edges: &[EdgeId],
    vertices: &[VertexId],
    sharpness: f32,
) -> Result<(), Refusal> {
    can_set_crease(mesh, edges, vertices, sharpness)?;
    for edge in edges {
        mesh.set(keys::EDGE_CREASE, edge.index(), sharpness);
    }
    for v in vertices {
        mesh.set(keys::VERTEX_CREASE, v.index(), sharpness);
    }
    Ok(())
}
