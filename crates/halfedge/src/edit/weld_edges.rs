//! Weld edges: two boundary edges become one inner edge. The opposite of ripping.
//!
//! Their ends are merged in pairs, so that the free sides meet; edges that share an end are zipped. Possible exactly if
//! those vertices can be merged: see [`merge_vertices`](super::merge_vertices).

use crate::edit::patch::Plan;
use crate::edit::shared::{Blend, Followers, follow_merged, merge_corners};
use crate::edit::{Made, Refusal};
use crate::mesh::Mesh;
use crate::{EdgeId, Element, VertexId};
use rustc_hash::FxHashMap;

/// Whether [`weld_edges`] would succeed.
pub fn can_weld_edges(mesh: &Mesh, edges: [EdgeId; 2]) -> Result<(), Refusal> {
    plan_weld(mesh, edges).map(drop)
}

/// Two vertices that merge; the first stays.
type Pair = (VertexId, VertexId);

fn plan_weld(mesh: &Mesh, edges: [EdgeId; 2]) -> Result<(Plan, Followers, [Pair; 2]), Refusal> {
    mesh.require_edges(&edges)?;
    if edges[0] == edges[1] {
        return Err(Refusal::GivenTwice(Element::Edge, edges[0].raw()));
    }
    let mut sides = [edges[0].halfedge(); 2];
    for (side, edge) in sides.iter_mut().zip(edges) {
        *side = edge
            .halfedges()
            .into_iter()
            .find(|&h| mesh.is_boundary_halfedge(h))
            .ok_or(Refusal::NotOnBoundary(edge))?;
    }
    let [one, other] = sides;
    let pairs = [(mesh.from(one), mesh.to(other)), (mesh.to(one), mesh.from(other))];
    let becomes: FxHashMap<VertexId, VertexId> =
        pairs.iter().filter(|(stays, goes)| stays != goes).map(|&(stays, goes)| (goes, stays)).collect();
    let plan = merge_corners(mesh, &becomes).plan(mesh)?.require_vertices(|v| becomes.contains_key(&v))?;
    let followers = follow_merged(mesh, &plan, &becomes);
    Ok((plan, followers, pairs))
}

/// Makes two boundary edges one: the first, with each end halfway to the end that it merges with.
///
/// The first edge and its ends keep their ids. Costs O(valences of the ends + degrees of the faces there). Attributes:
/// vertices get the mean of the two, corners the values that their faces have at the new places, the edge the sharper
/// crease.
pub fn weld_edges(mesh: &mut Mesh, edges: [EdgeId; 2]) -> Result<Made, Refusal> {
    let (plan, followers, pairs) = plan_weld(mesh, edges)?;
    let middles = pairs.map(|(a, b)| mesh.position(a).midpoint(mesh.position(b)));
    let made = plan.apply(mesh);
    for ((stays, goes), middle) in pairs.into_iter().zip(middles) {
        if stays != goes {
            mesh.blend_attributes(Element::Vertex, &Blend::Mix(stays.raw(), goes.raw(), 0.5), stays.raw());
            mesh.set_position(stays, middle);
        }
    }
    followers.update(mesh);
    Ok(made)
}
