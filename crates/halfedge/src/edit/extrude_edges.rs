//! Extrude edges: boundary edges get quads beside them.
//!
//! Always possible for boundary edges: the quads lie where there was no face, on one new vertex for each vertex of the
//! edges. Quads of adjacent edges share the edge between them.

use crate::edit::patch::{Corner, Patch, Plan};
use crate::edit::shared::{Blend, Followers};
use crate::edit::{Refusal, Slide, SlideVertex, SlidingEdit};
use crate::mesh::Mesh;
use crate::{EdgeId, VertexId};
use glam::Vec3;
use rustc_hash::FxHashMap;

/// Whether [`extrude_edges`] would succeed.
pub fn can_extrude_edges(mesh: &Mesh, edges: &[EdgeId]) -> Result<(), Refusal> {
    plan_extrude(mesh, edges).map(drop)
}

fn plan_extrude(mesh: &Mesh, edges: &[EdgeId]) -> Result<(Plan, Vec<(VertexId, VertexId)>), Refusal> {
    mesh.require_edges(edges)?;
    let mut edges = edges.to_vec();
    edges.sort_unstable();
    edges.dedup();
    let mut patch = Patch::new(mesh);
    let mut copies: FxHashMap<VertexId, VertexId> = FxHashMap::default();
    let mut moved = Vec::new();
    for edge in edges {
        let Some(side) = edge.halfedges().into_iter().find(|&h| mesh.is_boundary_halfedge(h)) else {
            return Err(Refusal::NotOnBoundary(edge));
        };
        let (u, v) = (mesh.from(side), mesh.to(side));
        let [u2, v2] = [u, v].map(|old| {
            *copies.entry(old).or_insert_with(|| {
                let new = patch.copy_vertex(mesh, old);
                moved.push((new, old));
                new
            })
        });
        // The corners of the face beside the edge.
        let at_v = side.twin();
        let at_u = mesh.next(at_v);
        let far = Corner { vertex: v2, value: Blend::Copy(at_v.raw()), replaces: Some(side) };
        patch.add_face(
            mesh.face_of(at_v),
            vec![Corner::new(u, at_u), Corner::new(v, at_v), far, Corner::new(u2, at_u)],
        );
    }
    Ok((patch.plan(mesh)?, moved))
}

/// Puts a quad beside each of some boundary edges, without size: the slide moves the quads' far sides by `offset` at
/// amount 1.
///
/// All ids survive. Costs O(n log n) in the number of edges and the valences of their vertices. Attributes: quads copy
/// the face beside the edge; new vertices, corners and far edges copy the old ones. As the slide moves them, vertex and
/// corner values continue those of that face, as seen along its normal.
pub fn extrude_edges(mesh: &mut Mesh, edges: &[EdgeId], offset: Vec3) -> Result<SlidingEdit, Refusal> {
    let (plan, moved) = plan_extrude(mesh, edges)?;
    let moves: Vec<SlideVertex> = moved
        .into_iter()
        .map(|(vertex, old)| SlideVertex { vertex, from: mesh.position(old), by: offset })
        .collect();
    let followers = plan.followers(mesh, moves.iter().map(|slide| slide.vertex));
    let followers = Followers::new(mesh, followers, |_, _| true);
    Ok(SlidingEdit { made: plan.apply(mesh), slide: Slide::unlimited(moves, followers) })
}
