//! Orienting faces consistently.

use super::note;
use super::side::{Kept, Side};
use crate::NONE;
use crate::mesh::{Note, NoteKind, PolygonSoup};

/// How faces are oriented.
pub(super) struct Orientation {
    /// Per face, whether it is flipped.
    pub turned: Vec<bool>,
    /// Per face, the number of the part that it is in: faces connected over edges with two faces.
    pub part: Vec<u32>,
}

impl Orientation {
    /// Whether a side runs from its smaller to its larger vertex afterwards.
    pub(super) fn is_upward(&self, soup: &PolygonSoup, faces: &[Kept], side: &Side) -> bool {
        side.is_upward(soup, faces) != self.turned[side.face as usize]
    }
}

/// Rule 4: which faces to flip. Pairs that can't agree are removed.
pub(super) fn orient(
    soup: &PolygonSoup,
    faces: &[Kept],
    sides: &[Side],
    pairs: &mut Vec<(usize, usize)>,
    notes: &mut Vec<Note>,
) -> Orientation {
    let disagrees =
        |&(a, b): &(usize, usize)| sides[a].is_upward(soup, faces) == sides[b].is_upward(soup, faces);
    // Neighbours over joined edges, in a flat list with a start for each face.
    let mut starts = vec![0usize; faces.len() + 1];
    for &(a, b) in pairs.iter() {
        starts[sides[a].face as usize + 1] += 1;
        starts[sides[b].face as usize + 1] += 1;
    }
    for f in 0..faces.len() {
        starts[f + 1] += starts[f];
    }
    let mut fill = starts.clone();
    let mut neighbours = vec![(0u32, false); pairs.len() * 2];
    for pair in pairs.iter() {
        let (a, b) = (sides[pair.0].face, sides[pair.1].face);
        for (from, to) in [(a, b), (b, a)] {
            neighbours[fill[from as usize]] = (to, disagrees(pair));
            fill[from as usize] += 1;
        }
    }
    let mut turned = vec![false; faces.len()];
    let mut part = vec![NONE; faces.len()];
    let mut faces_of_part = Vec::new();
    for start in 0..faces.len() {
        if part[start] != NONE {
            continue;
        }
        part[start] = start as u32;
        faces_of_part.clear();
        faces_of_part.push(start);
        let mut at = 0;
        while let Some(&f) = faces_of_part.get(at) {
            at += 1;
            for &(other, disagrees) in &neighbours[starts[f]..starts[f + 1]] {
                let other = other as usize;
                if part[other] == NONE {
                    part[other] = start as u32;
                    turned[other] = turned[f] != disagrees;
                    faces_of_part.push(other);
                }
            }
        }
        if faces_of_part.iter().filter(|&&f| turned[f]).count() * 2 > faces_of_part.len() {
            for &f in &faces_of_part {
                turned[f] = !turned[f];
            }
        }
    }
    let orientation = Orientation { turned, part };
    let mut cut = Vec::new();
    pairs.retain(|&(a, b)| {
        let (a, b) = (&sides[a], &sides[b]);
        let agree = orientation.is_upward(soup, faces, a) != orientation.is_upward(soup, faces, b);
        if !agree {
            cut.extend([a.ends.0, a.ends.1]);
        }
        agree
    });
    note(notes, NoteKind::NotOrientable, cut);
    orientation
}
