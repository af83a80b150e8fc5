//! Dropping faces that are not polygons or repeat others.

use super::note;
use super::side::{Kept, for_each_edge, sorted_sides};
use crate::geometry::UnionFind;
use crate::mesh::build::has_distinct_corners;
use crate::mesh::{Note, NoteKind, PolygonSoup};
use std::collections::HashMap;

/// Rule 1.
pub(super) fn clean_faces(soup: &PolygonSoup, notes: &mut Vec<Note>) -> Vec<Kept> {
    let (mut missing, mut repeated, mut degenerate) = (Vec::new(), Vec::new(), Vec::new());
    let mut faces = Vec::with_capacity(soup.face_count());
    for source in 0..soup.face_count() {
        let vertex = |corner: u32| soup.corners[corner as usize];
        let range = soup.face_range(source);
        let mut corners: Vec<u32> = (range.start as u32..range.end as u32).collect();
        if corners.iter().any(|&c| vertex(c) as usize >= soup.positions.len()) {
            missing.push(source as u32);
            continue;
        }
        corners.dedup_by_key(|&mut c| vertex(c));
        while corners.len() > 1 && vertex(corners[0]) == vertex(corners[corners.len() - 1]) {
            corners.pop();
        }
        let vertices: Vec<u32> = corners.iter().map(|&c| vertex(c)).collect();
        if has_distinct_corners(&vertices) {
            if corners.len() < range.len() {
                repeated.push(source as u32);
            }
            faces.push(Kept { source: source as u32, corners });
        } else {
            degenerate.push(source as u32);
        }
    }
    note(notes, NoteKind::MissingVertex, missing);
    note(notes, NoteKind::RepeatedCorner, repeated);
    note(notes, NoteKind::DegenerateFace, degenerate);
    faces
}

/// Rule 2.
pub(super) fn drop_duplicates(soup: &PolygonSoup, faces: &mut Vec<Kept>, notes: &mut Vec<Note>) {
    // A key that is equal for all rotations and both directions, and the direction.
    let canonical = |face: &Kept| {
        let vertices: Vec<u32> = face.corners.iter().map(|&c| soup.corners[c as usize]).collect();
        let n = vertices.len();
        let start = (0..n).min_by_key(|&i| vertices[i]).unwrap_or(0);
        let forward: Vec<u32> = (0..n).map(|i| vertices[(start + i) % n]).collect();
        let backward: Vec<u32> = (0..n).map(|i| vertices[(start + n - i) % n]).collect();
        if forward <= backward { (forward, true) } else { (backward, false) }
    };
    let mut groups: HashMap<Vec<u32>, Vec<(usize, bool)>> = HashMap::with_capacity(faces.len());
    for (f, face) in faces.iter().enumerate() {
        let (key, forward) = canonical(face);
        groups.entry(key).or_default().push((f, forward));
    }
    groups.retain(|_, group| group.len() > 1);
    if groups.is_empty() {
        return;
    }
    let mut drop = vec![false; faces.len()];
    // Per face: the opposite face, if there is one.
    let mut opposite = vec![None; faces.len()];
    for group in groups.values() {
        for &(f, _) in &group[1..] {
            drop[f] = true;
        }
        if let &[(f, forward), (g, other)] = group.as_slice()
            && forward != other
        {
            (opposite[f], opposite[g]) = (Some(g), Some(f));
        }
    }
    for f in closed_pairs(soup, faces, &opposite) {
        drop[f] = false;
    }
    note(
        notes,
        NoteKind::DuplicateFace,
        (0..faces.len()).filter(|&f| drop[f]).map(|f| faces[f].source).collect(),
    );
    let mut f = 0;
    faces.retain(|_| {
        f += 1;
        !drop[f - 1]
    });
}

/// The kinds of edges in a patch of opposite faces that are connected over edges.
#[derive(Clone, Copy, Default)]
struct Edges {
    /// An edge with only one pair of opposite faces.
    bare: bool,
    /// An edge with further faces.
    shared: bool,
    /// An edge with faces that are in no pair.
    joins_others: bool,
    /// An edge where more faces run one way than the other.
    uneven: bool,
}

/// The pairs of opposite faces that stay: a pair that touches nothing else is a closed surface, and a patch
/// of pairs whose edges all join it evenly to other faces is a wall between two solids. A sheet that is
/// double everywhere is neither.
fn closed_pairs(soup: &PolygonSoup, faces: &[Kept], opposite: &[Option<usize>]) -> Vec<usize> {
    let sides = sorted_sides(soup, faces);
    let mut patches = UnionFind::new(faces.len());
    let mut edges = vec![Edges::default(); faces.len()];
    for_each_edge(&sides, |range| {
        let here = &sides[range];
        let mut paired = here.iter().filter(|side| opposite[side.face as usize].is_some());
        let Some(first) = paired.next() else { return };
        let mut paired_count = 1;
        for side in paired {
            patches.union(first.face, side.face);
            paired_count += 1;
        }
        let upward = here.iter().filter(|side| side.is_upward(soup, faces)).count();
        let found = &mut edges[first.face as usize];
        found.bare |= here.len() == 2;
        found.shared |= here.len() > 2;
        found.joins_others |= here.len() > paired_count;
        found.uneven |= upward * 2 != here.len();
    });
    let mut of_patch = vec![Edges::default(); faces.len()];
    for (f, edges) in edges.iter().enumerate() {
        let patch = &mut of_patch[patches.find(f as u32) as usize];
        patch.bare |= edges.bare;
        patch.shared |= edges.shared;
        patch.joins_others |= edges.joins_others;
        patch.uneven |= edges.uneven;
    }
    let stays = |patch: &Edges| !patch.shared || (patch.joins_others && !patch.bare && !patch.uneven);
    (0..faces.len())
        .filter(|&f| opposite[f].is_some() && stays(&of_patch[patches.find(f as u32) as usize]))
        .collect()
}
