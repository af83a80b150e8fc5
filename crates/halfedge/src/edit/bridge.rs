//! Bridge: a band of faces between two boundary loops, or between two faces that it replaces.
//!
//! The band goes along both loops at once, in proportion to their lengths in edges. Where it goes on by an edge of both
//! loops there is a quad, where only the longer loop goes on a triangle; loops of equal length get quads only. Possible
//! exactly if no edge joins the loops where the band would have one: the loops have no vertex in common, the band takes
//! the free sides of their edges, and it joins each pair of vertices once.

use crate::edit::patch::{Corner, Patch, Plan};
use crate::edit::{Made, Refusal};
use crate::mesh::Mesh;
use crate::{Element, FaceId, HalfedgeId, VertexId};
use rustc_hash::FxHashSet;

/// The most distances that are measured to find how the loops fit best.
const MAX_MEASURED_DISTANCES: usize = 1 << 22;

/// Whether [`bridge`] would succeed.
pub fn can_bridge(mesh: &Mesh, halfedges: [HalfedgeId; 2]) -> Result<(), Refusal> {
    plan_bridge(mesh, halfedges).map(drop)
}

/// Whether [`bridge_faces`] would succeed.
pub fn can_bridge_faces(mesh: &Mesh, faces: [FaceId; 2]) -> Result<(), Refusal> {
    plan_bridge_faces(mesh, faces).map(drop)
}

fn plan_bridge(mesh: &Mesh, halfedges: [HalfedgeId; 2]) -> Result<Plan, Refusal> {
    for h in halfedges {
        mesh.require_halfedge(h)?;
        if !mesh.is_boundary_halfedge(h) {
            return Err(Refusal::NotABoundaryHalfedge(h));
        }
    }
    let [one, other] = halfedges;
    let loops = halfedges.map(|h| mesh.loop_of(h).collect::<Vec<_>>());
    if loops[0].contains(&other) {
        return Err(Refusal::SameLoop(one, other));
    }
    band(mesh, loops).plan(mesh)
}

fn plan_bridge_faces(mesh: &Mesh, faces: [FaceId; 2]) -> Result<Plan, Refusal> {
    for face in faces {
        mesh.require_face(face)?;
    }
    let [one, other] = faces;
    if one == other {
        return Err(Refusal::GivenTwice(Element::Face, one.raw()));
    }
    let loops = faces.map(|face| mesh.loop_of(mesh.halfedge_of(face)).collect::<Vec<_>>());
    let corners: FxHashSet<VertexId> = loops[0].iter().map(|&h| mesh.from(h)).collect();
    if let Some(shared) = loops[1].iter().map(|&h| mesh.from(h)).find(|v| corners.contains(v)) {
        return Err(Refusal::FacesTouch(one, other, shared));
    }
    let mut patch = band(mesh, loops);
    patch.remove = faces.to_vec();
    patch.plan(mesh)
}

/// The band between two loops of sides, which it takes.
fn band(mesh: &Mesh, [a, mut b]: [Vec<HalfedgeId>; 2]) -> Patch {
    // Seen from the band, the second loop runs backward.
    b.reverse();
    let turn = best_turn(mesh, &a, &b);
    b.rotate_left(turn);

    let (n, m) = (a.len(), b.len());
    let steps = n.max(m);
    let at_a = |i: usize| corner(mesh, a[i % n]);
    let at_b = |j: usize| corner(mesh, b[j % m]);
    let mut patch = Patch::new(mesh);
    for step in 0..steps {
        let (i, i2) = (step * n / steps, (step + 1) * n / steps);
        let (j, j2) = (step * m / steps, (step + 1) * m / steps);
        let mut corners = vec![at_a(i)];
        if i2 > i {
            corners.push(at_a(i2));
        }
        if j2 > j {
            corners.push(at_b(j2));
        }
        corners.push(at_b(j));
        let side = a[i % n];
        patch.add_face(mesh.face_of(side.twin()).or(mesh.face_of(side)), corners);
    }
    patch
}

/// The vertex that a side of a loop leaves, with the values of the face across it, or else of its own face.
fn corner(mesh: &Mesh, h: HalfedgeId) -> Corner {
    let across = if mesh.is_boundary_halfedge(h.twin()) { h } else { mesh.next(h.twin()) };
    Corner::new(mesh.from(h), across)
}

/// The number of edges by which to turn the second loop so that the edges across are short: the least sum of their
/// squared lengths, or for very long loops the vertex closest to the first vertex of the first loop.
fn best_turn(mesh: &Mesh, a: &[HalfedgeId], b: &[HalfedgeId]) -> usize {
    let (n, m) = (a.len(), b.len());
    let steps = n.max(m);
    let samples = if steps * m <= MAX_MEASURED_DISTANCES { steps } else { 1 };
    let position = |v: VertexId| mesh.position(v).as_dvec3();
    let cost = |turn: usize| -> f64 {
        (0..samples)
            .map(|k| {
                let (i, j) = (k * n / steps, (k * m / steps + turn) % m);
                position(mesh.from(a[i])).distance_squared(position(mesh.from(b[j])))
            })
            .sum()
    };
    let mut best = (f64::INFINITY, 0);
    for turn in 0..m {
        let here = cost(turn);
        if here < best.0 {
            best = (here, turn);
        }
    }
    best.1
}

/// Puts a band of quads and triangles between the boundary loops of two half-edges, turned so that the edges across are
/// short.
///
/// All ids survive. Costs O(product of the loops' lengths) up to 4 million, beyond that O(lengths), plus the valences of
/// the vertices. Attributes: faces copy those across the first loop, corners those of the faces across their loop.
pub fn bridge(mesh: &mut Mesh, halfedges: [HalfedgeId; 2]) -> Result<Made, Refusal> {
    Ok(plan_bridge(mesh, halfedges)?.apply(mesh))
}

/// Puts a band between two faces in place of them, as [`bridge`] does between loops: a handle, or a passage where they
/// face away from each other.
///
/// The faces are removed; all other ids survive. Cost and attributes are those of [`bridge`], with the faces' sides as
/// the loops.
pub fn bridge_faces(mesh: &mut Mesh, faces: [FaceId; 2]) -> Result<Made, Refusal> {
    Ok(plan_bridge_faces(mesh, faces)?.apply(mesh))
}
