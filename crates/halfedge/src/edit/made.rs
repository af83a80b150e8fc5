//! What an edit added and removed.

use crate::mesh::Mesh;
use crate::{EdgeId, FaceId, VertexId};

/// The ids of the elements that an edit added and removed. All others still exist, perhaps with other neighbours.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Made {
    /// New vertices.
    pub vertices: Vec<VertexId>,
    /// New edges.
    pub edges: Vec<EdgeId>,
    /// New faces.
    pub faces: Vec<FaceId>,
    /// Removed vertices.
    pub removed_vertices: Vec<VertexId>,
    /// Removed edges.
    pub removed_edges: Vec<EdgeId>,
    /// Removed faces.
    pub removed_faces: Vec<FaceId>,
}

impl Made {
    /// Adds what a later edit added and removed. Elements that existed only in between are dropped.
    pub(crate) fn add(&mut self, later: Self) {
        fn add<T: Copy + PartialEq>(made: &mut Vec<T>, removed: &mut Vec<T>, more: Vec<T>, gone: Vec<T>) {
            made.extend(more);
            for id in gone {
                match made.iter().rposition(|&new| new == id) {
                    Some(at) => _ = made.remove(at),
                    None => removed.push(id),
                }
            }
        }
        add(&mut self.vertices, &mut self.removed_vertices, later.vertices, later.removed_vertices);
        add(&mut self.edges, &mut self.removed_edges, later.edges, later.removed_edges);
        add(&mut self.faces, &mut self.removed_faces, later.faces, later.removed_faces);
    }

    /// The change of [`Mesh::euler_characteristic`].
    pub fn euler_change(&self) -> i64 {
        let change = |made: usize, removed: usize| made as i64 - removed as i64;
        change(self.vertices.len(), self.removed_vertices.len())
            - change(self.edges.len(), self.removed_edges.len())
            + change(self.faces.len(), self.removed_faces.len())
    }

    /// The numbers of vertices, edges and faces after the edit.
    pub fn counts_after(&self, before: &Mesh) -> [usize; 3] {
        let after = |count: usize, made: usize, removed: usize| (count + made).saturating_sub(removed);
        [
            after(before.vertex_count(), self.vertices.len(), self.removed_vertices.len()),
            after(before.edge_count(), self.edges.len(), self.removed_edges.len()),
            after(before.face_count(), self.faces.len(), self.removed_faces.len()),
        ]
    }
}
