//! The links of a mesh that follow from others, which packed meshes leave out.

use halfedge::geometry::BitSet;
use halfedge::{Gaps, NONE};

/// Columns of links that follow from those that leave vertices and faces and lead to next half-edges.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Derived {
    pub prev: Vec<u32>,
    pub to: Vec<u32>,
    pub face: Vec<u32>,
}

impl Derived {
    /// Derives the columns; none if the links are not those of a mesh. Removed edges keep links of their own, which follow
    /// from nothing: see [`Derived::of_removed`].
    pub fn from_links(
        vertex_halfedge: &[u32],
        next: &[u32],
        face_halfedge: &[u32],
        gaps: &Gaps,
    ) -> Option<Self> {
        let set = |ids: &[u32]| -> BitSet { ids.iter().map(|&id| id as usize).collect() };
        let (vertices, edges, faces) = (set(&gaps.vertices), set(&gaps.edges), set(&gaps.faces));
        let none = || vec![NONE; next.len()];
        let mut derived = Self { prev: none(), to: none(), face: none() };
        let live =
            |removed: BitSet| move |place: &(usize, &u32)| !removed.contains(place.0) && *place.1 != NONE;
        for (h, &after) in next.iter().enumerate() {
            if !edges.contains(h / 2) {
                put_once(&mut derived.prev, after, h)?;
            }
        }
        for (face, &first) in face_halfedge.iter().enumerate().filter(live(faces)) {
            let mut h = first;
            loop {
                put_once(&mut derived.face, h, face)?;
                h = *next.get(h as usize)?;
                if h == first {
                    break;
                }
            }
        }
        for (vertex, &first) in vertex_halfedge.iter().enumerate().filter(live(vertices)) {
            let mut h = first;
            loop {
                // The twin arrives where this one leaves.
                put_once(&mut derived.to, h ^ 1, vertex)?;
                h = *next.get((h ^ 1) as usize)?;
                if h == first {
                    break;
                }
            }
        }
        Some(derived)
    }

    /// The links of removed edges: for each of their half-edges prev, to and face.
    pub fn of_removed(prev: &[u32], to: &[u32], face: &[u32], gaps: &Gaps) -> Vec<u32> {
        let links = |h: u32| [prev, to, face].map(|column| column.get(h as usize).copied().unwrap_or(NONE));
        gaps.edges.iter().flat_map(|edge| [2 * edge, 2 * edge + 1]).flat_map(links).collect()
    }

    /// Puts the links of removed edges in; false if there are too many or too few.
    pub fn put_removed(&mut self, links: &[u32], gaps: &Gaps) -> bool {
        let (each, rest) = links.as_chunks::<3>();
        let halfedges = gaps.edges.iter().flat_map(|edge| [2 * edge, 2 * edge + 1]);
        for (h, [prev, to, face]) in halfedges.zip(each) {
            for (column, link) in [(&mut self.prev, prev), (&mut self.to, to), (&mut self.face, face)] {
                if let Some(place) = column.get_mut(h as usize) {
                    *place = *link;
                }
            }
        }
        rest.is_empty() && each.len() == 2 * gaps.edges.len()
    }
}

/// Sets a link that was not set before: so a walk over links that are wrong ends.
fn put_once(column: &mut [u32], at: u32, link: usize) -> Option<()> {
    let place = column.get_mut(at as usize).filter(|place| **place == NONE)?;
    *place = link as u32;
    Some(())
}
