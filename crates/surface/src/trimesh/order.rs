//! Putting elements that are near in space near in memory.

use super::{TriMesh, with_room};
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
    /// vertex and triangle was. There is room for so many [`TriMesh::split`]s then. Costs O(mesh).
    pub fn put_in_order(&mut self, splits: usize) -> Order {
        let live: Vec<u32> =
            (0u32..).zip(&self.out).filter(|(_, out)| **out != NONE).map(|(v, _)| v).collect();
        let points: Vec<Vec3> = live.iter().map(|&v| self.position[v as usize].as_vec3()).collect();
        let vertices: Vec<u32> = morton::order(&points).into_iter().map(|i| live[i as usize]).collect();
        drop((points, live));
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
        for (old, corners) in (0u32..).zip(self.v.chunks_exact(3)) {
            if is_live(&corners) {
                let place = &mut starts[first(corners)];
                triangles[*place as usize] = old;
                *place += 1;
            }
        }
        drop(starts);
        // One column after the other, small ones first, and no map before it is needed: remeshing takes
        // most memory here.
        self.face_source = with_room(triangles.iter().map(|&f| self.face_source[f as usize]), 2 * splits);
        self.position = with_room(vertices.iter().map(|&v| self.position[v as usize]), splits);
        let corners = |column: &[u32]| -> Vec<u32> {
            if column.is_empty() {
                return Vec::new();
            }
            let mut gathered = Vec::with_capacity(3 * triangles.len() + 6 * splits);
            gathered.extend(triangles.iter().flat_map(|&f| [0, 1, 2].map(|k| column[3 * f as usize + k])));
            gathered
        };
        self.v = corners(&self.v);
        self.v.iter_mut().for_each(|v| *v = vertex[*v as usize]);
        drop(vertex);
        self.wedge = corners(&self.wedge);
        self.edge_source = corners(&self.edge_source);
        let mut triangle = vec![NONE; self.opp.len() / 3];
        for (new, &old) in (0u32..).zip(&triangles) {
            triangle[old as usize] = new;
        }
        let half = |h: u32| if h == NONE { NONE } else { 3 * triangle[h as usize / 3] + h % 3 };
        self.opp = corners(&self.opp);
        self.opp.iter_mut().for_each(|h| *h = half(*h));
        self.out = with_room(vertices.iter().map(|&v| half(self.out[v as usize])), splits);
        for column in &mut self.vertex_columns {
            column.values = column.values.gather(vertices.iter().copied(), column.default);
        }
        Order { vertices, triangles }
    }
}
