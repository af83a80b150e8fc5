//! Keeping the copies of separated edges apart.

use super::side::{Kept, Side, for_each_edge};
use crate::geometry::UnionFind;
use crate::mesh::PolygonSoup;
use std::collections::HashSet;

/// Rule 5. A separated edge has a copy for each face or pair of faces that keeps it. Two copies whose ends are
/// both in the same fans of faces would join the same two vertices. Then the later one's faces are cut from the
/// fan at one end: both of their sides there are separated, so that each corner is a fan of its own.
pub(super) fn separate_copies(
    soup: &PolygonSoup,
    faces: &[Kept],
    sides: &[Side],
    pairs: &mut Vec<(usize, usize)>,
) {
    let mut mate = vec![None; sides.len()];
    for &(a, b) in pairs.iter() {
        (mate[a], mate[b]) = (Some(b), Some(a));
    }
    let mut separated = Vec::new();
    for_each_edge(sides, |range| {
        if range.len() > 2 || (range.len() == 2 && mate[range.start].is_none()) {
            separated.push(range);
        }
    });
    if separated.is_empty() {
        return;
    }
    let mut starts = Vec::with_capacity(faces.len());
    let mut corners = 0;
    for face in faces {
        starts.push(corners);
        corners += face.corners.len();
    }
    // The index in its face of the corner at one end of a side.
    let slot_at = |side: &Side, v: u32| {
        let face = &faces[side.face as usize];
        let slot = side.slot as usize;
        if face.vertex(soup, slot) == v { slot } else { (slot + 1) % face.corners.len() }
    };
    let corner_at = |side: &Side, v: u32| (starts[side.face as usize] + slot_at(side, v)) as u32;
    // Joined sides connect corners to fans.
    let mut fans = UnionFind::new(corners);
    for &(a, b) in pairs.iter() {
        for v in [sides[a].ends.0, sides[a].ends.1] {
            fans.union(corner_at(&sides[a], v), corner_at(&sides[b], v));
        }
    }
    let mut cut = vec![false; corners];
    let mut met = HashSet::new();
    for range in separated {
        met.clear();
        for number in range {
            // A pair is one copy.
            if mate[number].is_some_and(|other| other < number) {
                continue;
            }
            let side = &sides[number];
            let copy = (fans.find(corner_at(side, side.ends.0)), fans.find(corner_at(side, side.ends.1)));
            if met.insert(copy) {
                continue;
            }
            for side in [Some(number), mate[number]].into_iter().flatten().map(|number| &sides[number]) {
                // A corner lies between the side before it and the one that starts at it.
                let n = faces[side.face as usize].corners.len();
                let corner = slot_at(side, side.ends.0);
                let start = starts[side.face as usize];
                cut[start + corner] = true;
                cut[start + (corner + n - 1) % n] = true;
            }
        }
    }
    let is_cut = |side: &Side| cut[starts[side.face as usize] + side.slot as usize];
    pairs.retain(|&(a, b)| !is_cut(&sides[a]) && !is_cut(&sides[b]));
}
