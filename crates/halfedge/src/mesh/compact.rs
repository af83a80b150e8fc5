//! Compaction: closing the gaps that removed elements leave in the ids.

use crate::mesh::Mesh;
use crate::{Element, NONE};
use std::borrow::Cow;

/// The new number of each old id; [`NONE`] for those that were removed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Renumbering {
    /// Per old vertex id.
    pub vertices: Vec<u32>,
    /// Per old edge id. Half-edge `2e + s` becomes `2 * edges[e] + s`.
    pub edges: Vec<u32>,
    /// Per old face id.
    pub faces: Vec<u32>,
}

impl Renumbering {
    /// The new number of an old id, unless the element was removed.
    pub fn of(&self, element: Element, old: u32) -> Option<u32> {
        let new = match element {
            Element::Vertex => *self.vertices.get(old as usize)?,
            Element::Edge => *self.edges.get(old as usize)?,
            Element::Halfedge => match *self.edges.get(old as usize / 2)? {
                NONE => NONE,
                edge => edge * 2 + old % 2,
            },
            Element::Face => *self.faces.get(old as usize)?,
        };
        (new != NONE).then_some(new)
    }
}

impl Mesh {
    /// The mesh itself if its ids have no gaps, else a copy without gaps.
    pub fn to_compact(&self) -> Cow<'_, Self> {
        if self.is_compact() { Cow::Borrowed(self) } else { Cow::Owned(self.compacted().0) }
    }

    /// A copy of the mesh without gaps in its ids, in the same order, and the renumbering. Costs O(mesh).
    pub fn compacted(&self) -> (Self, Renumbering) {
        let number = |len: usize, removed: &dyn Fn(usize) -> bool| {
            let mut count = 0;
            (0..len)
                .map(|i| {
                    if removed(i) {
                        NONE
                    } else {
                        count += 1;
                        count - 1
                    }
                })
                .collect::<Vec<u32>>()
        };
        let renumbering = Renumbering {
            vertices: number(self.vertex_capacity(), &|i| self.removed_vertices.contains(i)),
            edges: number(self.edge_capacity(), &|i| self.removed_edges.contains(i)),
            faces: number(self.face_capacity(), &|i| self.removed_faces.contains(i)),
        };
        let map = |element: Element, raw: u32| renumbering.of(element, raw).unwrap_or(NONE);
        let mut mesh = Self::new();
        for v in self.vertices() {
            mesh.positions.push(self.positions[v.index()]);
            mesh.vertex_halfedge.push(map(Element::Halfedge, self.vertex_halfedge[v.index()]));
        }
        for h in self.halfedges().map(|h| h.index()) {
            mesh.next.push(map(Element::Halfedge, self.next[h]));
            mesh.prev.push(map(Element::Halfedge, self.prev[h]));
            mesh.to.push(map(Element::Vertex, self.to[h]));
            mesh.face.push(map(Element::Face, self.face[h]));
        }
        for f in self.faces() {
            mesh.face_halfedge.push(map(Element::Halfedge, self.face_halfedge[f.index()]));
        }
        for element in Element::ALL {
            let kept = || (0..self.capacity(element) as u32).filter(|&raw| self.exists(element, raw));
            let columns = self.columns.of(element).iter().map(|column| column.gather(kept()));
            mesh.columns.of_mut(element).extend(columns);
        }
        (mesh, renumbering)
    }

    /// Closes the gaps in the ids; returns the renumbering. Journals recorded before no longer fit the mesh.
    pub fn compact(&mut self) -> Renumbering {
        let (mesh, renumbering) = self.compacted();
        *self = mesh;
        renumbering
    }
}
