//! Putting elements that are near in space near in memory.

use super::TriMesh;
use crate::morton;
use glam::Vec3;
use halfedge::NONE;

/// What [`TriMesh::put_in_order`] did: the old number of each vertex and triangle.
pub(crate) struct Order {
    pub vertices: Vec<u32>,
    pub triangles: Vec<u32>,
}

impl TriMesh {
    /// Puts vertices in order along a curve through space, triangles in order of their first vertex, and
    /// leaves out what was removed: neighbours come to be near each other in memory. Says where each
    /// vertex and triangle was. Costs O(mesh).
    pub fn put_in_order(&mut self) -> Order {
        let live: Vec<u32> =
            (0u32..).zip(&self.out).filter(|(_, out)| **out != NONE).map(|(v, _)| v).collect();
        let points: Vec<Vec3> = live.iter().map(|&v| self.position[v as usize].as_vec3()).collect();
        let vertices: Vec<u32> = morton::order(&points).into_iter().map(|i| live[i as usize]).collect();
        let mut vertex = vec![NONE; self.out.len()];
        for (new, &old) in (0u32..).zip(&vertices) {
            vertex[old as usize] = new;
        }
        // Triangles by their smallest vertex, counted first.
        let first = |corners: &[u32]| {
            let [a, b, c] = [corners[0], corners[1], corners[2]].map(|v| vertex[v as usize]);
            a.min(b).min(c) as usize
        };
        let is_live = |corners: &&[u32]| corners[0] != NONE;
        let mut starts = vec![0u32; vertices.len() + 1];
        for corners in self.v.chunks_exact(3).filter(is_live) {
            starts[first(corners) + 1] += 1;
        }
        for v in 0..vertices.len() {
            starts[v + 1] += starts[v];
        }
        let mut triangles = vec![NONE; self.faces];
        let mut triangle = vec![NONE; self.v.len() / 3];
        for (old, corners) in (0u32..).zip(self.v.chunks_exact(3)) {
            if is_live(&corners) {
                let place = &mut starts[first(corners)];
                triangles[*place as usize] = old;
                triangle[old as usize] = *place;
                *place += 1;
            }
        }
        let half = |h: u32| if h == NONE { NONE } else { 3 * triangle[h as usize / 3] + h % 3 };
        let corners = |column: &[u32]| -> Vec<u32> {
            if column.is_empty() {
                return Vec::new();
            }
            triangles.iter().flat_map(|&f| [0, 1, 2].map(|k| column[3 * f as usize + k])).collect()
        };
        self.v = corners(&self.v).into_iter().map(|v| vertex[v as usize]).collect();
        self.opp = corners(&self.opp).into_iter().map(half).collect();
        self.wedge = corners(&self.wedge);
        self.edge_source = corners(&self.edge_source);
        self.out = vertices.iter().map(|&v| half(self.out[v as usize])).collect();
        self.position = vertices.iter().map(|&v| self.position[v as usize]).collect();
        self.face_source = triangles.iter().map(|&f| self.face_source[f as usize]).collect();
        for column in &mut self.vertex_columns {
            column.values = column.values.gather(vertices.iter().copied(), column.default);
        }
        Order { vertices, triangles }
    }
}
