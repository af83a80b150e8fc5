//! Turning any polygon soup into an oriented manifold, with notes of what was changed.
//!
//! Rules, in this order:
//! 1. A face is dropped if it refers to a vertex that doesn't exist, if it has fewer than three different
//!    corners after repeats in a row are merged, or if it has a vertex at two corners.
//! 2. A face with the same vertices in the same cyclic order (in either direction) as an earlier one is
//!    dropped. A pair of opposite faces that touch nothing else is a closed surface, and stays; so does a wall
//!    of such pairs between two solids.
//! 3. An edge with more than two faces is separated: faces that follow each other around it and bound a solid
//!    between them share an edge, so that solids stay closed; each other face gets an edge of its own.
//! 4. In each part connected over edges with two faces, faces are flipped so that neighbours agree, the smaller
//!    share of them. Where no orientation exists (a Möbius strip), the edges that disagree are separated. (This
//!    comes before rule 3 pairs faces.)
//! 5. Where two sides separated by rules 3 and 4 would still join the same two vertices, because the faces
//!    around a vertex connect them, the fan of faces there is cut too.
//! 6. A vertex whose faces form several fans keeps its number for the first; each other fan gets a copy.
//!    (The build does this.)

mod clean;
mod copies;
mod crowded;
mod orient;
mod side;

use crate::NONE;
use crate::mesh::assembly::Assembly;
use crate::mesh::{Note, NoteKind, PolygonSoup};
use clean::{clean_faces, drop_duplicates};
use copies::separate_copies;
use crowded::pair_sides;
use orient::orient;
use side::{Side, for_each_edge, sorted_sides};

pub(crate) struct Repaired {
    pub assembly: Assembly,
    /// Per corner that is kept, the soup's corner.
    pub corner_source: Vec<u32>,
    /// Per face that is kept, the soup's face.
    pub face_source: Vec<u32>,
    pub notes: Vec<Note>,
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
        _ => crowded.push(range),
    });
    let crowded_ends =
        crowded.iter().flat_map(|range| [sides[range.start].ends.0, sides[range.start].ends.1]);
    note(&mut notes, NoteKind::NonManifoldEdge, crowded_ends.collect());

    let orientation = orient(soup, &faces, &sides, &mut pairs, &mut notes);
    let turned = &orientation.turned;
    note(
        &mut notes,
        NoteKind::FaceTurned,
        (0..faces.len()).filter(|&f| turned[f]).map(|f| faces[f].source).collect(),
    );

    for edge in crowded {
        pairs.extend(pair_sides(soup, &faces, &sides, &orientation, edge));
    }
    separate_copies(soup, &faces, &sides, &mut pairs);

    // Flip faces but keep their first corners, and find where each side starts afterwards.
    let mut corner_start = Vec::with_capacity(faces.len());
    let mut corner_count = 0;
    for (face, &turn) in faces.iter_mut().zip(turned) {
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
