//! Ordering the corners at each vertex of a patch into fans.

use super::Plan;
use crate::edit::Refusal;
use crate::{HalfedgeId, Mesh, VertexId};

/// A corner as a fan sees it: the sides that arrive at its vertex and leave it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Wedge {
    vertex: VertexId,
    arrives: HalfedgeId,
    leaves: HalfedgeId,
}

impl Plan {
    /// Orders the corners at each of these vertices, which are in order of id. `stays` tells whether a half-edge
    /// keeps its face.
    pub(super) fn order_fans(
        &mut self,
        mesh: &Mesh,
        vertices: &[VertexId],
        stays: impl Fn(HalfedgeId) -> bool,
    ) -> Result<(), Refusal> {
        let mut wedges = Vec::with_capacity(self.sides.len());
        let mut first = 0;
        for face in &self.patch.faces {
            let sides = &self.sides[first..first + face.corners.len()];
            let before = sides.iter().cycle().skip(sides.len() - 1);
            for ((corner, &leaves), &arrives) in face.corners.iter().zip(sides).zip(before) {
                wedges.push(Wedge { vertex: corner.vertex, arrives, leaves });
            }
            first += face.corners.len();
        }
        for &vertex in vertices.iter().filter(|v| v.index() < mesh.vertex_capacity()) {
            for leaves in mesh.outgoing(vertex).filter(|&h| stays(h)) {
                wedges.push(Wedge { vertex, arrives: mesh.prev(leaves), leaves });
            }
        }
        wedges.sort_unstable();
        let mut rest = wedges.as_slice();
        for &v in vertices {
            let (here, after) = rest.split_at(rest.partition_point(|wedge| wedge.vertex <= v));
            rest = after;
            if here.is_empty() {
                self.made.removed_vertices.push(v);
            } else {
                self.order_fan(mesh, v, here)?;
            }
        }
        Ok(())
    }

    /// Orders the corners at one vertex, which are sorted by the half-edge that arrives.
    fn order_fan(&mut self, mesh: &Mesh, v: VertexId, here: &[Wedge]) -> Result<(), Refusal> {
        // Clockwise: the edge that leaves a corner arrives at the next one.
        let after: Vec<Option<usize>> = here
            .iter()
            .map(|wedge| here.binary_search_by_key(&wedge.leaves.twin(), |wedge| wedge.arrives).ok())
            .collect();
        let mut is_first = vec![true; here.len()];
        for &next in after.iter().flatten() {
            is_first[next] = false;
        }
        let starts =
            (0..here.len()).filter(|&i| is_first[i]).chain((0..here.len()).filter(|&i| !is_first[i]));
        let mut visited = vec![false; here.len()];
        let mut fans = 0;
        for start in starts {
            if visited[start] {
                continue;
            }
            fans += 1;
            let vertex = match fans {
                1 => v,
                _ if self.patch.separates_fans => {
                    let copy = self.patch.copy_vertex(mesh, v);
                    self.made.vertices.push(copy);
                    copy
                }
                _ => return Err(Refusal::Pinched(v)),
            };
            let (mut at, mut last) = (Some(start), start);
            while let Some(i) = at.filter(|&i| !visited[i]) {
                visited[i] = true;
                last = i;
                if fans > 1 {
                    self.separated.extend([(here[i].arrives, vertex), (here[i].leaves.twin(), vertex)]);
                }
                at = after[i];
            }
            let leaves = if is_first[start] {
                let (arriving, leaving) = (here[last].leaves.twin(), here[start].arrives.twin());
                self.boundary_links.push((arriving, leaving));
                leaving
            } else {
                // Inside the mesh any half-edge will do. The vertex keeps its own if that still leaves it.
                let old = (fans == 1 && v.index() < mesh.vertex_capacity()).then(|| mesh.halfedge_from(v));
                let kept = old.flatten().filter(|&h| {
                    here.iter().zip(&visited).any(|(wedge, visited)| *visited && wedge.leaves == h)
                });
                kept.unwrap_or(here[start].leaves)
            };
            self.vertex_halfedges.push((vertex, leaves));
        }
        Ok(())
    }
}
