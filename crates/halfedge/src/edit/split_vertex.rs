//! Split vertex: the inverse of collapsing an edge.
//!
//! The faces round a vertex v, counter-clockwise from the first edge to the second, get a new vertex v' in its place. An
//! edge joins v and v', with a triangle on either side: one at each of the two edges. On the boundary the same edge may be
//! given twice: the faces counter-clockwise from it to the boundary get v', and there is one triangle. This undoes the
//! collapse of a boundary edge. At an edge on the boundary the triangle lies outside.
//!
//! Always possible for two edges of a vertex: the new edges join v' to v, to the far ends of the two edges and to those of
//! the edges between, each once. At v, v' and the far ends a triangle comes between two corners of one fan, or between a
//! corner and the boundary.

use crate::edit::patch::{Corner, Patch, Plan};
use crate::edit::shared::Followers;
use crate::edit::{Made, Refusal};
use crate::geometry::mean_position;
use crate::mesh::Mesh;
use crate::{EdgeId, Element, HalfedgeId, VertexId};
use glam::Vec3;

/// Whether [`split_vertex`] would succeed.
pub fn can_split_vertex(
    mesh: &Mesh,
    vertex: VertexId,
    edges: [EdgeId; 2],
    positions: Option<[Vec3; 2]>,
) -> Result<(), Refusal> {
    plan_split(mesh, vertex, edges, positions).map(drop)
}

fn plan_split(
    mesh: &Mesh,
    vertex: VertexId,
    edges: [EdgeId; 2],
    positions: Option<[Vec3; 2]>,
) -> Result<(Plan, [Vec3; 2]), Refusal> {
    mesh.require_vertex(vertex)?;
    let mut leaving = [HalfedgeId::new(0); 2];
    for (leaving, &edge) in leaving.iter_mut().zip(&edges) {
        mesh.require_edge(edge)?;
        *leaving = edge
            .halfedges()
            .into_iter()
            .find(|&h| mesh.from(h) == vertex)
            .ok_or(Refusal::NotAtVertex(edge, vertex))?;
    }
    if positions.is_some_and(|both| !both.iter().all(|p| p.is_finite())) {
        return Err(Refusal::TooFarAway(vertex));
    }
    let [first, second] = leaving;
    let to_boundary = first == second;
    if to_boundary && !mesh.is_boundary_vertex(vertex) {
        return Err(Refusal::GivenTwice(Element::Edge, edges[0].raw()));
    }
    // Counter-clockwise from the first edge: the faces that get the new vertex.
    let mut taken = Vec::new();
    let mut at = first;
    loop {
        match mesh.face_of(at) {
            Some(_) => taken.push(at),
            None if to_boundary => break,
            None => {}
        }
        at = mesh.prev(at).twin();
        if at == second {
            break;
        }
    }
    let mut patch = Patch::new(mesh);
    let others = mesh.outgoing(vertex).filter(|h| mesh.face_of(*h).is_some() && !taken.contains(h));
    let default = [position_for(mesh, vertex, others), position_for(mesh, vertex, taken.iter().copied())];
    let [_, at_new] = positions.unwrap_or(default);
    let new = patch.copy_vertex(mesh, vertex);
    if let Some(added) = patch.vertices.last_mut() {
        added.position = at_new;
    }
    for &h in &taken {
        let Some(face) = mesh.face_of(h) else { continue };
        let corners = mesh
            .face_halfedges(face)
            .map(|side| if side == h { Corner::moved(new, h) } else { Corner::keep(mesh, side) })
            .collect();
        patch.replace_face(face, corners);
    }
    // The new vertex lies counter-clockwise of the old one at the first edge, clockwise at the second.
    let triangle = |edge: HalfedgeId, from: VertexId, to: VertexId| {
        let side = if mesh.face_of(edge).is_some() { edge } else { edge.twin() };
        let corners = if side == edge { [side, mesh.next(side)] } else { [mesh.next(side), side] };
        let [near, far] = corners;
        vec![Corner::new(from, near), Corner::new(mesh.to(edge), far), Corner::new(to, near)]
    };
    let face_at = |edge: HalfedgeId| mesh.face_of(edge).or(mesh.face_of(edge.twin()));
    patch.add_face(face_at(first), triangle(first, vertex, new));
    if !to_boundary {
        patch.add_face(face_at(second), triangle(second, new, vertex));
    }
    Ok((patch.plan(mesh)?, positions.unwrap_or(default)))
}

/// A quarter of the way from a vertex to the mean of its neighbours in some of its faces.
fn position_for(mesh: &Mesh, vertex: VertexId, corners: impl Iterator<Item = HalfedgeId>) -> Vec3 {
    let mut far = corners.flat_map(|h| [mesh.to(h), mesh.from(mesh.prev(h))]).peekable();
    let here = mesh.position(vertex);
    if far.peek().is_none() { here } else { here.lerp(mean_position(mesh, far).as_vec3(), 0.25) }
}

/// Splits a vertex in two along two of its edges; see the module's text for the faces that go to the new one. `positions`
/// are those of the vertex and of the new one; by default each moves a quarter of the way to its neighbours.
///
/// All ids survive. Costs O(degrees of the faces round the vertex + valences of their corners). Attributes: the new vertex
/// copies the old one; triangles and their corners copy the face on their edge; of an edge that is doubled, the one with
/// the new id copies the other. Where the vertices move, vertex and corner values follow over the faces.
pub fn split_vertex(
    mesh: &mut Mesh,
    vertex: VertexId,
    edges: [EdgeId; 2],
    positions: Option<[Vec3; 2]>,
) -> Result<Made, Refusal> {
    let (plan, [at_old, _]) = plan_split(mesh, vertex, edges, positions)?;
    let followers = plan.followers(mesh, plan.made.vertices.iter().copied().chain([vertex]));
    let followers = Followers::new(mesh, followers, |_, _| true);
    let made = plan.apply(mesh);
    mesh.set_position(vertex, at_old);
    followers.update(mesh);
    Ok(made)
}
