//! The faces that are kept and their sides.

use crate::mesh::PolygonSoup;
use std::ops::Range;

/// A face that is kept: its number in the soup, and its corners' numbers in the soup.
pub(super) struct Kept {
    pub source: u32,
    pub corners: Vec<u32>,
}

impl Kept {
    /// The vertex at a corner. Indices past the last corner start over.
    pub(super) fn vertex(&self, soup: &PolygonSoup, slot: usize) -> u32 {
        soup.corners[self.corners[slot % self.corners.len()] as usize]
    }
}

/// A side of a face: its vertices, the smaller one first, its face and the index of its first corner there.
pub(super) struct Side {
    pub ends: (u32, u32),
    pub face: u32,
    pub slot: u32,
}

impl Side {
    /// Whether it runs from its smaller to its larger vertex in the soup.
    pub(super) fn is_upward(&self, soup: &PolygonSoup, faces: &[Kept]) -> bool {
        faces[self.face as usize].vertex(soup, self.slot as usize) == self.ends.0
    }
}

/// All sides of all faces, grouped by edge and in order of face there.
pub(super) fn sorted_sides(soup: &PolygonSoup, faces: &[Kept]) -> Vec<Side> {
    let mut sides = Vec::with_capacity(soup.corners.len());
    for (f, face) in faces.iter().enumerate() {
        for slot in 0..face.corners.len() {
            let (a, b) = (face.vertex(soup, slot), face.vertex(soup, slot + 1));
            sides.push(Side { ends: (a.min(b), a.max(b)), face: f as u32, slot: slot as u32 });
        }
    }
    sides.sort_unstable_by_key(|side| (side.ends, side.face, side.slot));
    sides
}

/// Calls `visit` with the sides at each edge.
pub(super) fn for_each_edge(sides: &[Side], mut visit: impl FnMut(Range<usize>)) {
    let mut start = 0;
    while start < sides.len() {
        let len = sides[start..].iter().take_while(|side| side.ends == sides[start].ends).count();
        visit(start..start + len);
        start += len;
    }
}
