//! What an edit made and took away.

use crate::mesh::Mesh;
use crate::{EdgeId, FaceId, VertexId};

/// The elements that an edit made and took away, by id. Those in neither list are still there,
/// perhaps with other neighbours.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Made {
    /// New vertices.
    pub vertices: Vec<VertexId>,
    /// New edges.
    pub edges: Vec<EdgeId>,
    /// New faces.
    pub faces: Vec<FaceId>,
    /// Vertices that are gone.
    pub removed_vertices: Vec<VertexId>,
    /// Edges that are gone.
    pub removed_edges: Vec<EdgeId>,
    /// Faces that are gone.
    pub removed_faces: Vec<FaceId>,
}

impl Made {
    /// Adds what a later edit made and took away. What was only there in between is in no list.
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

    /// By how much the edit changed [`Mesh::euler_characteristic`].
    pub fn euler_change(&self) -> i64 {
        let change = |made: usize, removed: usize| made as i64 - removed as i64;
        change(self.vertices.len(), self.removed_vertices.len())
            - change(self.edges.len(), self.removed_edges.len())
            + change(self.faces.len(), self.removed_faces.len())
    }

    /// The counts (vertices, edges, faces) that a mesh has after the edit.
    pub fn counts_after(&self, before: &Mesh) -> [usize; 3] {
        let after = |count: usize, made: usize, removed: usize| (count + made).saturating_sub(removed);
        [
            after(before.vertex_count(), self.vertices.len(), self.removed_vertices.len()),
            after(before.edge_count(), self.edges.len(), self.removed_edges.len()),
            after(before.face_count(), self.faces.len(), self.removed_faces.len()),
        ]
    }
}
