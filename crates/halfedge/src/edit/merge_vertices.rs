//! Merge vertices: several become one.
//!
//! Faces lose the corners that become one; those left with fewer than three vanish. The result is a valid mesh exactly if
//! planning the patch of the faces round the vertices finds it so: no face has the new vertex at two corners, no edge has
//! two faces on one side, and the faces at each vertex form one fan. Vertices joined by edges shrink a piece of the surface
//! to a point. Vertices apart may sew boundaries together, and are refused if that would pinch the surface.

use crate::edit::patch::Plan;
use crate::edit::shared::{Blend, follow_merged, merge_corners};
use crate::edit::{Made, Refusal};
use crate::geometry::mean_position;
use crate::mesh::Mesh;
use crate::{Element, VertexId};
use glam::Vec3;
use rustc_hash::FxHashMap;

/// Whether [`merge_vertices`] would succeed.
pub fn can_merge_vertices(mesh: &Mesh, vertices: &[VertexId], position: Option<Vec3>) -> Result<(), Refusal> {
    plan_merge(mesh, vertices, position).map(drop)
}

/// The plan, and the vertices that become the first one.
fn plan_merge(
    mesh: &Mesh,
    vertices: &[VertexId],
    position: Option<Vec3>,
) -> Result<(Plan, FxHashMap<VertexId, VertexId>), Refusal> {
    mesh.require_vertices(vertices)?;
    let target = vertices[0];
    if let Some(position) = position
        && !position.is_finite()
    {
        return Err(Refusal::TooFarAway(target));
    }
    let becomes: FxHashMap<VertexId, VertexId> =
        vertices.iter().filter(|&&v| v != target).map(|&v| (v, target)).collect();
    if becomes.is_empty() {
        let why = if vertices.len() == 1 { Refusal::OnlyOne } else { Refusal::GivenTwice };
        return Err(why(Element::Vertex, target.raw()));
    }
    let plan = merge_corners(mesh, &becomes).plan(mesh)?.require_vertices(|v| becomes.contains_key(&v))?;
    Ok((plan, becomes))
}

/// Makes several vertices one: the first one given, at `position` or at their mean.
///
/// Isolated vertices can be merged too. Edges that keep different ends and faces that keep three corners keep their ids.
/// Costs O(valences + degrees of the faces round them). Attributes: the vertex gets the mean of all; its corners get the
/// values that their faces have at its place, and corners that shared a value still share one. Of edges that become one
/// the sharper crease stays.
pub fn merge_vertices(
    mesh: &mut Mesh,
    vertices: &[VertexId],
    position: Option<Vec3>,
) -> Result<Made, Refusal> {
    let (plan, becomes) = plan_merge(mesh, vertices, position)?;
    let followers = follow_merged(mesh, &plan, &becomes);
    let target = vertices[0];
    let mut all = vertices.to_vec();
    all.sort_unstable();
    all.dedup();
    let position = position.unwrap_or_else(|| mean_position(mesh, all.iter().copied()).as_vec3());
    let mut made = plan.apply(mesh);
    let blend = Blend::Mean(all.iter().map(|v| v.raw()).collect());
    mesh.blend_attributes(Element::Vertex, &blend, target.raw());
    mesh.set_position(target, position);
    followers.update(mesh);
    // Isolated vertices are in no patch.
    for v in all {
        if v != target && mesh.has_vertex(v) {
            mesh.mark(Element::Vertex, v.raw(), true);
            made.removed_vertices.push(v);
        }
    }
    Ok(made)
}
