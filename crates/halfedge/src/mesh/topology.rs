//! Boundary loops and connected components, counted at once or some elements at a time.

use crate::geometry::{BitSet, UnionFind};
use crate::mesh::Mesh;
use crate::{Budget, EdgeId, HalfedgeId, InParts, NONE, VertexId};

/// Counts that take a pass over the mesh.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Topology {
    /// Closed loops of boundary half-edges.
    pub boundary_loops: usize,
    /// Half-edges without a face.
    pub boundary_halfedges: usize,
    /// Connected components; an isolated vertex is one.
    pub components: usize,
    /// Whether every face is a triangle; true if there are no faces.
    pub triangles_only: bool,
}

/// Counts a [`Topology`] over several calls, so that none takes long.
#[derive(Debug)]
pub struct TopologyCounter {
    boundary: BoundaryWalk,
    components: ComponentWalk,
}

impl TopologyCounter {
    /// Starts on a mesh. Costs O(vertices), little for each.
    pub fn new(mesh: &Mesh) -> Self {
        Self { boundary: BoundaryWalk::default(), components: ComponentWalk::new(mesh) }
    }
}

/// A boundary loop is walked as a whole. Start anew after an edit: the counts of a mesh that changed meanwhile
/// are wrong.
impl InParts for TopologyCounter {
    type Input<'a> = &'a Mesh;
    type Output = Topology;

    fn step(&mut self, mesh: &Mesh, budget: &mut Budget) -> Option<Topology> {
        if self.components.joined.len() != mesh.vertex_capacity() {
            *self = Self::new(mesh);
        }
        self.boundary.advance(mesh, budget)?;
        self.components.advance(mesh, budget)?;
        let boundary_halfedges = self.boundary.halfedges;
        Some(Topology {
            boundary_loops: self.boundary.loops.len(),
            boundary_halfedges,
            components: mesh.vertex_count().saturating_sub(self.components.unions),
            // No face has fewer than three corners, and each corner has a half-edge.
            triangles_only: mesh.halfedge_count() - boundary_halfedges == 3 * mesh.face_count(),
        })
    }
}

/// Boundary loops in order of their smallest half-edge.
#[derive(Debug, Default)]
struct BoundaryWalk {
    next: usize,
    seen: BitSet,
    loops: Vec<HalfedgeId>,
    halfedges: usize,
}

impl BoundaryWalk {
    /// Visits half-edges; returns something once all are visited.
    fn advance(&mut self, mesh: &Mesh, budget: &mut Budget) -> Option<()> {
        let faces = mesh.connectivity().face;
        while self.next < faces.len() {
            if budget.is_spent() {
                return None;
            }
            let slice = &faces[self.next..faces.len().min(self.next.saturating_add(budget.left()))];
            let Some(skipped) = slice.iter().position(|&face| face == NONE) else {
                self.next += budget.take(slice.len());
                continue;
            };
            let h = HalfedgeId::new(self.next + skipped);
            self.next += budget.take(skipped + 1);
            if !self.seen.contains(h.index()) && mesh.has_halfedge(h) {
                self.loops.push(h);
                for side in mesh.loop_of(h) {
                    self.seen.insert(side.index());
                    self.halfedges += 1;
                    budget.take(1);
                }
            }
        }
        Some(())
    }
}

/// Vertices joined by edges, in order of edge id, which reads memory mostly in order. A walk from vertex to
/// vertex would not.
#[derive(Debug)]
struct ComponentWalk {
    next: usize,
    joined: UnionFind,
    unions: usize,
}

impl ComponentWalk {
    fn new(mesh: &Mesh) -> Self {
        Self { next: 0, joined: UnionFind::new(mesh.vertex_capacity()), unions: 0 }
    }

    /// Visits edges; returns something once all are visited.
    fn advance(&mut self, mesh: &Mesh, budget: &mut Budget) -> Option<()> {
        let ends = mesh.connectivity().to.as_chunks::<2>().0;
        let end = self.next + budget.take(ends.len() - self.next);
        let is_compact = mesh.is_compact();
        for (e, &[a, b]) in (self.next..).zip(&ends[self.next..end]) {
            if is_compact || mesh.has_edge(EdgeId::new(e)) {
                self.unions += usize::from(self.joined.union(a, b));
            }
        }
        self.next = end;
        (end == ends.len()).then_some(())
    }
}

impl Mesh {
    /// Boundary loops, components and whether there are only triangles. Costs O(mesh): a pass over the
    /// half-edges and one over the edges, in the order they are stored.
    pub fn topology(&self) -> Topology {
        TopologyCounter::new(self).finish(self)
    }

    /// One half-edge of each boundary loop, the one with the smallest id, in order. Costs O(half-edges).
    pub fn boundary_loops(&self) -> Vec<HalfedgeId> {
        let mut walk = BoundaryWalk::default();
        walk.advance(self, &mut Budget::unlimited());
        walk.loops
    }

    /// The connected components: for each vertex id the number of its component, components numbered in order
    /// of their smallest vertex, and how many there are. Isolated vertices are components of their own;
    /// removed ids have [`NONE`]. Costs O(edges).
    pub fn components(&self) -> (Vec<u32>, usize) {
        let mut walk = ComponentWalk::new(self);
        walk.advance(self, &mut Budget::unlimited());
        let mut numbers = vec![NONE; self.vertex_capacity()];
        let mut count = 0;
        for v in 0..numbers.len() {
            if !self.has_vertex(VertexId::new(v)) {
                continue;
            }
            // The smallest vertex of a component comes first.
            let smallest = walk.joined.find(v as u32) as usize;
            if smallest == v {
                numbers[v] = count;
                count += 1;
            } else {
                numbers[v] = numbers[smallest];
            }
        }
        (numbers, count as usize)
    }
}
