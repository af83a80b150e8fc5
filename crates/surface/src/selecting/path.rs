//! Shortest paths between elements.

use glam::Vec3;
use halfedge::{EdgeId, Element, FaceId, HalfedgeId, Mesh, VertexId};
use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

/// The elements of a kind on the shortest path from one to another, both included; none if they aren't connected.
/// Vertices, edges and half-edges are joined along edges, by their length; faces across edges, by the distance of their
/// centres. Costs O(k log k) for k elements nearer than the second one (Dijkstra 1959).
pub fn shortest_path(mesh: &Mesh, kind: Element, from: u32, to: u32) -> Option<Vec<u32>> {
    let [a, b] = [from as usize, to as usize];
    if !mesh.exists(kind, from) || !mesh.exists(kind, to) {
        return None;
    }
    if from == to {
        return Some(vec![from]);
    }
    let along_edges = |starts: &[VertexId], ends: &[VertexId]| {
        search(
            starts,
            |v| ends.contains(&v),
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
            let path = search(
                &[FaceId::new(a)],
                |f| f == goal,
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

/// The nodes from a start to the nearest goal, in order. `steps` visits the nodes next to one, with their distances.
fn search<N: Copy + Ord + std::hash::Hash>(
    starts: &[N],
    is_goal: impl Fn(N) -> bool,
    steps: impl Fn(N, &mut dyn FnMut(N, f32)),
) -> Option<Vec<N>> {
    let mut best: HashMap<N, (f32, Option<N>)> = starts.iter().map(|&node| (node, (0.0, None))).collect();
    // The bits of non-negative floats sort like their values.
    let mut front: BinaryHeap<_> = starts.iter().map(|&node| Reverse((0.0f32.to_bits(), node))).collect();
    while let Some(Reverse((bits, node))) = front.pop() {
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
                front.push(Reverse((there.to_bits(), next)));
            }
        });
    }
    None
}
