//! Shortest paths between elements.

use glam::Vec3;
use halfedge::{EdgeId, Element, FaceId, HalfedgeId, Mesh, VertexId};
use rustc_hash::FxHashMap;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The share of the straight distance to the goal that counts as still to go: all of it, but for the rounding of sums.
const STRAIGHT_SHARE: f32 = 1.0 - 1e-4;

/// The elements of a kind on the shortest path from one to another, both included; none if they aren't connected.
/// Vertices, edges and half-edges are joined along edges, by their length; faces across edges, by the distance of their
/// centres. Costs O(k log k) for k elements from which the straight way to the second one may be shorter (A*: Hart, Nilsson and
/// Raphael 1968).
pub fn shortest_path(mesh: &Mesh, kind: Element, from: u32, to: u32) -> Option<Vec<u32>> {
    let [a, b] = [from as usize, to as usize];
    if !mesh.exists(kind, from) || !mesh.exists(kind, to) {
        return None;
    }
    if from == to {
        return Some(vec![from]);
    }
    let along_edges = |starts: &[VertexId], ends: &[VertexId]| {
        let at_ends = ends.iter().map(|v| mesh.position(*v));
        let straight = |v: VertexId| {
            at_ends.clone().map(|end| distance(mesh.position(v), end)).fold(f32::INFINITY, f32::min)
        };
        search(
            starts,
            |v| ends.contains(&v),
            straight,
            |v, visit| {
                for w in mesh.neighbors(v) {
                    visit(w, distance(mesh.position(v), mesh.position(w)));
                }
            },
        )
    };
    // The half-edges along a path of vertices, between two elements that may lie on it.
    let halfedges = |path: &[VertexId]| -> Vec<HalfedgeId> {
        path.iter().zip(path.iter().skip(1)).filter_map(|(&v, &w)| mesh.find_halfedge(v, w)).collect()
    };
    let mut ids: Vec<u32> = match kind {
        Element::Vertex => {
            along_edges(&[VertexId::new(a)], &[VertexId::new(b)])?.into_iter().map(VertexId::raw).collect()
        }
        Element::Edge => {
            let path = along_edges(&mesh.ends(EdgeId::new(a)), &mesh.ends(EdgeId::new(b)))?;
            halfedges(&path).into_iter().map(|h| h.edge().raw()).chain([from, to]).collect()
        }
        Element::Halfedge => {
            let [a, b] = [a, b].map(HalfedgeId::new);
            let path = along_edges(&[mesh.from(a), mesh.to(a)], &[mesh.from(b), mesh.to(b)])?;
            halfedges(&path).into_iter().map(HalfedgeId::raw).chain([from, to]).collect()
        }
        Element::Face => {
            let center = |f: FaceId| {
                let sum: Vec3 = mesh.face_vertices(f).map(|v| mesh.position(v)).sum();
                sum / mesh.face_degree(f) as f32
            };
            let goal = FaceId::new(b);
            let at_goal = center(goal);
            let path = search(
                &[FaceId::new(a)],
                |f| f == goal,
                |f| distance(center(f), at_goal),
                |f, visit| {
                    let here = center(f);
                    for next in mesh.face_halfedges(f).filter_map(|h| mesh.face_of(h.twin())) {
                        visit(next, distance(here, center(next)));
                    }
                },
            )?;
            path.into_iter().map(FaceId::raw).collect()
        }
    };
    ids.sort_unstable();
    ids.dedup();
    Some(ids)
}

/// The distance of two points, whose square may be out of the range of single precision.
fn distance(a: Vec3, b: Vec3) -> f32 {
    a.as_dvec3().distance(b.as_dvec3()) as f32
}

/// The nodes from a start to the nearest goal, in order. `straight` gives a node's straight distance to the nearest goal, and
/// `steps` visits the nodes next to one, with their distances.
fn search<N: Copy + Ord + std::hash::Hash>(
    starts: &[N],
    is_goal: impl Fn(N) -> bool,
    straight: impl Fn(N) -> f32,
    steps: impl Fn(N, &mut dyn FnMut(N, f32)),
) -> Option<Vec<N>> {
    let mut best: FxHashMap<N, (f32, Option<N>)> = starts.iter().map(|&node| (node, (0.0, None))).collect();
    // The whole way, as far as it is known. The bits of non-negative floats sort like their values.
    let whole = |distance: f32, node: N| (distance + straight(node) * STRAIGHT_SHARE).to_bits();
    let mut front: BinaryHeap<_> =
        starts.iter().map(|&node| Reverse((whole(0.0, node), 0.0f32.to_bits(), node))).collect();
    while let Some(Reverse((_, bits, node))) = front.pop() {
        let distance = f32::from_bits(bits);
        if best.get(&node).is_some_and(|&(known, _)| known < distance) {
            continue;
        }
        if is_goal(node) {
            let mut path = vec![node];
            let mut at = node;
            while let Some(&(_, Some(before))) = best.get(&at) {
                path.push(before);
                at = before;
            }
            path.reverse();
            return Some(path);
        }
        steps(node, &mut |next, length| {
            let there = distance + length;
            // A length that isn't finite leads nowhere.
            if there.is_finite() && best.get(&next).is_none_or(|&(known, _)| there < known) {
                best.insert(next, (there, Some(node)));
                front.push(Reverse((whole(there, next), there.to_bits(), next)));
            }
        });
    }
    None
}
