//! All connected components but the largest.

use halfedge::geometry::BitSet;
use halfedge::{Budget, Mesh, VertexId};

/// Finds the vertices outside the component with the most faces, some vertices at a time. Of components of equal size the
/// one with more vertices counts as larger, and then the one with the smallest vertex.
#[derive(Clone, Debug, Default)]
pub(super) struct SmallerComponents {
    /// The number from which on a vertex may be in a component that was not reached yet.
    next: usize,
    reached: BitSet,
    /// Vertices whose neighbours are still to be reached.
    front: Vec<VertexId>,
    /// The component that is being walked, and the largest so far.
    current: Component,
    largest: Component,
}

#[derive(Clone, Debug, Default)]
struct Component {
    faces: usize,
    vertices: Vec<VertexId>,
}

impl Component {
    fn size(&self) -> (usize, usize) {
        (self.faces, self.vertices.len())
    }
}

impl SmallerComponents {
    /// Reads more vertices and adds those of smaller components to what was found; returns whether those were the last.
    pub fn advance(&mut self, mesh: &Mesh, found: &mut BitSet, budget: &mut Budget) -> bool {
        loop {
            while let Some(v) = self.front.pop() {
                if budget.take(1) == 0 {
                    self.front.push(v);
                    return false;
                }
                self.current.vertices.push(v);
                for h in mesh.outgoing(v) {
                    // Each face counts at its first half-edge.
                    let is_first = mesh.face_of(h).is_some_and(|face| mesh.halfedge_of(face) == h);
                    self.current.faces += usize::from(is_first);
                    if self.reached.insert(mesh.to(h).index()) {
                        self.front.push(mesh.to(h));
                    }
                }
            }
            let mut smaller = std::mem::take(&mut self.current);
            if smaller.size() > self.largest.size() {
                std::mem::swap(&mut smaller, &mut self.largest);
            }
            for v in smaller.vertices {
                found.insert(v.index());
            }
            let capacity = mesh.vertex_capacity();
            let is_new = |v: &usize| mesh.has_vertex(VertexId::new(*v)) && !self.reached.contains(*v);
            let end = self.next + budget.left().min(capacity - self.next);
            match (self.next..end).find(is_new) {
                Some(v) => {
                    budget.take(v + 1 - self.next);
                    self.next = v + 1;
                    self.reached.insert(v);
                    self.front.push(VertexId::new(v));
                }
                None => {
                    budget.take(end - self.next);
                    self.next = end;
                    return end == capacity;
                }
            }
        }
    }
}
