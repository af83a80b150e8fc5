//! Fill hole: one polygon on a boundary loop.
//!
//! Always possible: a boundary loop passes each vertex once, because a vertex has one fan, and has three edges or more,
//! because no two edges join the same vertices. The polygon takes the free side of each edge and closes each vertex's
//! fan.

use crate::HalfedgeId;
use crate::edit::patch::{Corner, Patch, Plan};
use crate::edit::{Made, Refusal};
use crate::mesh::Mesh;

/// Whether [`fill_hole`] would succeed.
pub fn can_fill_hole(mesh: &Mesh, halfedge: HalfedgeId) -> Result<(), Refusal> {
    plan_fill(mesh, halfedge).map(drop)
}

fn plan_fill(mesh: &Mesh, halfedge: HalfedgeId) -> Result<Plan, Refusal> {
    mesh.require_halfedge(halfedge)?;
    if !mesh.is_boundary_halfedge(halfedge) {
        return Err(Refusal::NotABoundaryHalfedge(halfedge));
    }
    let corners = mesh.loop_of(halfedge).map(|h| Corner::new(mesh.from(h), mesh.next(h.twin()))).collect();
    let mut patch = Patch::new(mesh);
    patch.add_face(mesh.face_of(halfedge.twin()), corners);
    patch.plan(mesh)
}

/// Puts one polygon on the boundary loop of a half-edge. Its first corner is the vertex that the half-edge leaves.
///
/// All ids survive. Costs O(length of the loop + valences of its vertices). Attributes: the polygon copies the face
/// across the half-edge, each corner the face across its side.
pub fn fill_hole(mesh: &mut Mesh, halfedge: HalfedgeId) -> Result<Made, Refusal> {
    Ok(plan_fill(mesh, halfedge)?.apply(mesh))
}
