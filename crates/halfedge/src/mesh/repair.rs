//! Turning any polygon soup into an oriented manifold, with notes of what was changed.
//!
//! Rules, in this order:
//! 1. A face is dropped if it refers to a vertex that doesn't exist, if it has fewer than three different
//!    corners after repeats in a row are merged, or if it has a vertex at two corners.
//! 2. A face with the same vertices in the same cyclic order (in either direction) as an earlier one is
//!    dropped. A pair of opposite faces that touch nothing else is a closed surface, and stays.
//! 3. An edge with more than two faces is separated: each face gets an edge of its own there.
//! 4. In each part connected over edges, faces are flipped so that neighbours agree, the smaller share of
//!    them. Where no orientation exists (a Möbius strip), the edges that disagree are separated.
//! 5. Where two sides separated by rules 3 and 4 would still join the same two vertices, because the faces
//!    around a vertex connect them, the fan of faces there is cut too.
//! 6. A vertex whose faces form several fans keeps its number for the first; each other fan gets a copy.
//!    (The build does this.)

use crate::NONE;
use crate::geometry::UnionFind;
use crate::mesh::assembly::Assembly;
use crate::mesh::build::has_distinct_corners;
use crate::mesh::{Note, NoteKind, PolygonSoup};
use std::collections::{HashMap, HashSet};

pub(crate) struct Repaired {
    pub assembly: Assembly,
    /// Per corner that is kept, the soup's corner.
    pub corner_source: Vec<u32>,
    /// Per face that is kept, the soup's face.
    pub face_source: Vec<u32>,
    pub notes: Vec<Note>,
}

/// A face that is kept: its number in the soup, and its corners' numbers in the soup.
struct Kept {
    source: u32,
    corners: Vec<u32>,
}

/// A side of a face: its vertices, the smaller one first, its face and the index of its first corner there.
struct Side {
    ends: (u32, u32),
    face: u32,
    slot: u32,
}

pub(crate) fn assemble(soup: &PolygonSoup) -> Repaired {
    let mut notes = Vec::new();
    let mut faces = clean_faces(soup, &mut notes);
    drop_duplicates(soup, &mut faces, &mut notes);

    let sides = sorted_sides(soup, &faces);
    // Pairs of sides that stay joined.
    let mut pairs: Vec<(usize, usize)> = Vec::new();
    let mut crowded = Vec::new();
    for_each_edge(&sides, |range| match range.len() {
        1 => {}
        2 => pairs.push((range.start, range.start + 1)),
        _ => crowded.extend([sides[range.start].ends.0, sides[range.start].ends.1]),
    });
    note(&mut notes, NoteKind::NonManifoldEdge, crowded);

    let turned = orient(soup, &faces, &sides, &mut pairs, &mut notes);
    note(
        &mut notes,
        NoteKind::FaceTurned,
        (0..faces.len()).filter(|&f| turned[f]).map(|f| faces[f].source).collect(),
    );

    separate_copies(soup, &faces, &sides, &mut pairs);

    // Flip faces but keep their first corners, and find where each side starts afterwards.
    let mut corner_start = Vec::with_capacity(faces.len());
    let mut corner_count = 0;
    for (face, &turn) in faces.iter_mut().zip(&turned) {
        corner_start.push(corner_count);
        corner_count += face.corners.len();
        if turn {
            face.corners[1..].reverse();
        }
    }
    let corner_of = |side: &Side| {
        let f = side.face as usize;
        let n = faces[f].corners.len() as u32;
        let slot = if turned[f] { (n - (side.slot + 1)) % n } else { side.slot };
        corner_start[f] + slot as usize
    };
    let mut mate = vec![NONE; corner_count];
    for (a, b) in pairs {
        let (a, b) = (corner_of(&sides[a]), corner_of(&sides[b]));
        mate[a] = b as u32;
        mate[b] = a as u32;
    }

    let mut assembly = Assembly::with_capacity(faces.len(), corner_count);
    let mut corner_source = Vec::with_capacity(corner_count);
    for face in &faces {
        let first = assembly.corner_halfedge.len();
        for (i, &corner) in face.corners.iter().enumerate() {
            let at = first + i;
            let other = mate[at];
            let h = if (other as usize) < at {
                assembly.corner_halfedge[other as usize] ^ 1
            } else {
                let end = face.corners[(i + 1) % face.corners.len()];
                assembly.push_edge(soup.corners[corner as usize], soup.corners[end as usize])
            };
            assembly.corner_halfedge.push(h);
            corner_source.push(corner);
        }
        assembly.close_face(first);
    }
    Repaired { assembly, corner_source, face_source: faces.iter().map(|face| face.source).collect(), notes }
}

fn note(notes: &mut Vec<Note>, kind: NoteKind, elements: Vec<u32>) {
    if !elements.is_empty() {
        notes.push(Note::new(kind, elements));
    }
}

/// Rule 1.
fn clean_faces(soup: &PolygonSoup, notes: &mut Vec<Note>) -> Vec<Kept> {
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
fn drop_duplicates(soup: &PolygonSoup, faces: &mut Vec<Kept>, notes: &mut Vec<Note>) {
    // Equal for all rotations and both directions; tells which direction it was.
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
    let mut uses: HashMap<(u32, u32), u32> = HashMap::new();
    for side in sorted_sides(soup, faces) {
        *uses.entry(side.ends).or_default() += 1;
    }
    let mut drop = vec![false; faces.len()];
    for (key, group) in groups {
        let touches_nothing_else =
            || (0..key.len()).all(|i| uses.get(&ends(key[i], key[(i + 1) % key.len()])) == Some(&2));
        let pillow = group.len() == 2 && group[0].1 != group[1].1 && touches_nothing_else();
        if !pillow {
            for &(f, _) in &group[1..] {
                drop[f] = true;
            }
        }
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

fn ends(a: u32, b: u32) -> (u32, u32) {
    (a.min(b), a.max(b))
}

/// All sides of all faces, grouped by edge and in order of face there.
fn sorted_sides(soup: &PolygonSoup, faces: &[Kept]) -> Vec<Side> {
    let mut sides = Vec::with_capacity(soup.corners.len());
    for (f, face) in faces.iter().enumerate() {
        let n = face.corners.len();
        for slot in 0..n {
            let a = soup.corners[face.corners[slot] as usize];
            let b = soup.corners[face.corners[(slot + 1) % n] as usize];
            sides.push(Side { ends: ends(a, b), face: f as u32, slot: slot as u32 });
        }
    }
    sides.sort_unstable_by_key(|side| (side.ends, side.face, side.slot));
    sides
}

fn for_each_edge(sides: &[Side], mut visit: impl FnMut(std::ops::Range<usize>)) {
    let mut start = 0;
    while start < sides.len() {
        let len = sides[start..].iter().take_while(|side| side.ends == sides[start].ends).count();
        visit(start..start + len);
        start += len;
    }
}

/// Rule 4: which faces to flip. Pairs that can't agree are removed.
fn orient(
    soup: &PolygonSoup,
    faces: &[Kept],
    sides: &[Side],
    pairs: &mut Vec<(usize, usize)>,
    notes: &mut Vec<Note>,
) -> Vec<bool> {
    // Whether a side runs from its smaller to its larger vertex.
    let upward = |side: &Side| {
        soup.corners[faces[side.face as usize].corners[side.slot as usize] as usize] == side.ends.0
    };
    let disagrees = |&(a, b): &(usize, usize)| upward(&sides[a]) == upward(&sides[b]);
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
    let mut met = vec![false; faces.len()];
    let mut piece = Vec::new();
    for start in 0..faces.len() {
        if met[start] {
            continue;
        }
        met[start] = true;
        piece.clear();
        piece.push(start);
        let mut at = 0;
        while let Some(&f) = piece.get(at) {
            at += 1;
            for &(other, disagrees) in &neighbours[starts[f]..starts[f + 1]] {
                let other = other as usize;
                if !met[other] {
                    met[other] = true;
                    turned[other] = turned[f] != disagrees;
                    piece.push(other);
                }
            }
        }
        if piece.iter().filter(|&&f| turned[f]).count() * 2 > piece.len() {
            for &f in &piece {
                turned[f] = !turned[f];
            }
        }
    }
    let mut cut = Vec::new();
    pairs.retain(|pair| {
        let (a, b) = (&sides[pair.0], &sides[pair.1]);
        let agree = (upward(a) != turned[a.face as usize]) != (upward(b) != turned[b.face as usize]);
        if !agree {
            cut.extend([a.ends.0, a.ends.1]);
        }
        agree
    });
    note(notes, NoteKind::NotOrientable, cut);
    turned
}

/// Rule 5. A separated edge has a copy for each face there. Two copies whose ends are both in the same fans
/// of faces would join the same two vertices. Then the later one's face is cut from the fan at one end: its
/// other side there is separated, so that this corner is a fan of its own.
fn separate_copies(soup: &PolygonSoup, faces: &[Kept], sides: &[Side], pairs: &mut Vec<(usize, usize)>) {
    let mut joined = vec![false; sides.len()];
    for &(a, b) in pairs.iter() {
        joined[a] = true;
        joined[b] = true;
    }
    let mut separated = Vec::new();
    for_each_edge(sides, |range| {
        if range.len() > 1 && !joined[range.start] {
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
        let starts_there = soup.corners[face.corners[slot] as usize] == v;
        if starts_there { slot } else { (slot + 1) % face.corners.len() }
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
        for side in &sides[range] {
            let copy = (fans.find(corner_at(side, side.ends.0)), fans.find(corner_at(side, side.ends.1)));
            if met.insert(copy) {
                continue;
            }
            // A corner lies between the side before it and the one that starts at it.
            let n = faces[side.face as usize].corners.len();
            let corner = slot_at(side, side.ends.0);
            let other = if corner == side.slot as usize { (corner + n - 1) % n } else { corner };
            cut[starts[side.face as usize] + other] = true;
        }
    }
    let is_cut = |side: &Side| cut[starts[side.face as usize] + side.slot as usize];
    pairs.retain(|&(a, b)| !is_cut(&sides[a]) && !is_cut(&sides[b]));
}
