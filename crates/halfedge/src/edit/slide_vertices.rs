//! Slide vertices: each along the one of its edges that points most in a direction.
//!
//! A vertex with no edge that points that way at all stays where it is. Always possible: only positions change, and they
//! stay between those of vertices.

use crate::edit::Refusal;
use crate::edit::shared::{Rail, check_amount, slide_along};
use crate::mesh::Mesh;
use crate::{Element, HalfedgeId, VertexId};
use glam::{DVec3, Vec3};

/// The least cosine of the angle between an edge and the direction in which it is taken.
const MIN_COSINE: f64 = 1e-3;

/// The rails of the vertices that have an edge which points in the direction. Costs O(valences).
///
/// # Errors
/// If a vertex doesn't exist, none is given, or the direction has no length.
pub fn vertex_rails(mesh: &Mesh, vertices: &[VertexId], direction: Vec3) -> Result<Vec<Rail>, Refusal> {
    if vertices.is_empty() {
        return Err(Refusal::NothingGiven(Element::Vertex));
    }
    mesh.require_vertices(vertices)?;
    let direction = direction.as_dvec3().try_normalize().ok_or(Refusal::NoDirection)?;
    let mut vertices = vertices.to_vec();
    vertices.sort_unstable();
    vertices.dedup();
    let best = vertices.iter().filter_map(|&v| best_edge(mesh, v, direction));
    Ok(best.map(|h| Rail::along_edge(mesh, h)).collect())
}

/// The half-edge that leaves a vertex and points most in a direction.
fn best_edge(mesh: &Mesh, v: VertexId, direction: DVec3) -> Option<HalfedgeId> {
    best_way(mesh.outgoing(v).map(|h| (mesh.direction(h), h)), direction)
}

/// Along which of some edges a vertex slides in a direction: the one that points most in it, of several the smallest by
/// id; none if none points that way at all. The edges are given by their directions, of length 1, and their ids.
pub fn best_way<Id: Ord>(edges: impl IntoIterator<Item = (Vec3, Id)>, direction: DVec3) -> Option<Id> {
    let cosines = edges.into_iter().map(|(edge, id)| (edge.as_dvec3().dot(direction), id));
    let ahead = cosines.filter(|(cosine, _)| *cosine > MIN_COSINE);
    ahead.max_by(|(a, h), (b, g)| a.total_cmp(b).then(g.cmp(h))).map(|(_, id)| id)
}

/// Whether [`slide_vertices`] would succeed.
pub fn can_slide_vertices(
    mesh: &Mesh,
    vertices: &[VertexId],
    direction: Vec3,
    amount: f32,
) -> Result<(), Refusal> {
    check_amount(amount)?;
    vertex_rails(mesh, vertices, direction).map(drop)
}

/// Moves each vertex along the one of its edges that points most in the direction: not at all at amount 0, to the edge's
/// other end at 1. A negative amount goes along the edges that point the other way. Returns how many vertices have moved.
///
/// Costs O(valences + degrees of the faces round the vertices). Attributes: corner and vertex values become those that the
/// faces had at the new places.
pub fn slide_vertices(
    mesh: &mut Mesh,
    vertices: &[VertexId],
    direction: Vec3,
    amount: f32,
) -> Result<usize, Refusal> {
    check_amount(amount)?;
    let way = if amount < 0.0 { -direction } else { direction };
    let rails = vertex_rails(mesh, vertices, way)?;
    slide_along(mesh, &rails, amount.abs());
    Ok(if amount == 0.0 { 0 } else { rails.len() })
}
