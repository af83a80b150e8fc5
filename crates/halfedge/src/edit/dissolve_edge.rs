//! Dissolve edge: the two faces beside it become one.
//!
//! The new polygon is the outline of both. It is one loop with all corners different exactly where
//! the faces share one edge, or several in a row: those in between go with it, as do the vertices
//! between them, which have no other edges. Faces that meet along two edges apart would become a
//! ring that touches itself, and are refused; so are two faces that share all their edges.

use crate::edit::patch::{Corner, Patch, Plan, plan};
use crate::edit::region::outline;
use crate::edit::{Made, Refusal};
use crate::mesh::Mesh;
use crate::{EdgeId, FaceId};
use rustc_hash::FxHashSet;

/// Whether [`dissolve_edge`] would succeed.
pub fn can_dissolve_edge(mesh: &Mesh, edge: EdgeId) -> Result<(), Refusal> {
    plan_dissolve(mesh, edge).map(drop)
}

fn plan_dissolve(mesh: &Mesh, edge: EdgeId) -> Result<Plan, Refusal> {
    mesh.need_edge(edge)?;
    let [Some(left), Some(right)] = edge.halfedges().map(|h| mesh.face_of(h)) else {
        return Err(Refusal::BoundaryEdge(edge));
    };
    let faces: FxHashSet<FaceId> = [left, right].into_iter().collect();
    let rim = outline(mesh, &faces)?;
    let mut patch = Patch::new(mesh);
    patch.remove.push(right);
    let corners = rim.iter().map(|&h| Corner::keep(mesh, h)).collect();
    patch.replace_face(left, corners, false);
    plan(mesh, patch)
}

/// Makes the two faces beside an edge one polygon: the face of the even half-edge.
///
/// Costs O(degrees of the faces + valences of their corners). Attributes: the polygon keeps those
/// of the face whose id it keeps; corners keep theirs.
pub fn dissolve_edge(mesh: &mut Mesh, edge: EdgeId) -> Result<Made, Refusal> {
    Ok(plan_dissolve(mesh, edge)?.apply(mesh))
}
