//! Bridge: a band of faces between two boundary loops.
//!
//! The loops are walked side by side, each in proportion to its length in edges: where both go on
//! by an edge there is a quad, where the longer one goes on alone a triangle. Loops of the same
//! length get quads only. Possible exactly where no edge joins the loops at a place where the band
//! would have one: boundary loops have no vertex in common, the band takes the free sides of their
//! edges, and each pair of vertices across is joined once.

use crate::edit::patch::{Corner, Patch, Plan};
use crate::edit::{Made, Refusal};
use crate::mesh::Mesh;
use crate::{HalfedgeId, VertexId};

/// Up to this many pairs of places, all ways of turning one loop against the other are measured.
const MEASURED: usize = 1 << 22;

/// Whether [`bridge`] would succeed.
pub fn can_bridge(mesh: &Mesh, halfedges: [HalfedgeId; 2]) -> Result<(), Refusal> {
    plan_bridge(mesh, halfedges).map(drop)
}

fn plan_bridge(mesh: &Mesh, halfedges: [HalfedgeId; 2]) -> Result<Plan, Refusal> {
    for h in halfedges {
        mesh.require_halfedge(h)?;
        if !mesh.is_boundary_halfedge(h) {
            return Err(Refusal::NotABoundaryHalfedge(h));
        }
    }
    let [one, other] = halfedges;
    let a: Vec<HalfedgeId> = mesh.loop_of(one).collect();
    let mut b: Vec<HalfedgeId> = mesh.loop_of(other).collect();
    if a.contains(&other) {
        return Err(Refusal::SameLoop(one, other));
    }
    // Seen from the band, the second loop runs the other way.
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
        patch.add_face(mesh.face_of(a[i % n].twin()), corners);
    }
    patch.plan(mesh)
}

/// The vertex a boundary half-edge leaves, with the corner there of the face across it.
fn corner(mesh: &Mesh, h: HalfedgeId) -> Corner {
    Corner::new(mesh.from(h), mesh.next(h.twin()))
}

/// By how much to turn the second loop so that the edges across are short: the least sum of their
/// squares, or for very long loops the vertex nearest to the first loop's first.
fn best_turn(mesh: &Mesh, a: &[HalfedgeId], b: &[HalfedgeId]) -> usize {
    let (n, m) = (a.len(), b.len());
    let steps = n.max(m);
    let samples = if steps * m <= MEASURED { steps } else { 1 };
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

/// Puts a band of quads and triangles between the boundary loops of two half-edges, turned so that
/// the edges across are short.
///
/// All ids survive. Costs O(product of the lengths) up to 4 million, then O(lengths), and the
/// valences of the vertices. Attributes: faces copy those across the first loop, corners those of
/// the faces across their loop.
pub fn bridge(mesh: &mut Mesh, halfedges: [HalfedgeId; 2]) -> Result<Made, Refusal> {
    Ok(plan_bridge(mesh, halfedges)?.apply(mesh))
}
