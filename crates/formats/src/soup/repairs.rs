//! Options for making a mesh of faces that don't form one.
//!
//! The build itself (`halfedge::Mesh::build`) separates faces where more than two meet at an edge
//! and orients faces consistently. Other choices change the soup before the build.

use crate::model::labels::tidy_labels;
use crate::report::Places;
use crate::text::number::shortest;
use halfedge::attribute::Column;
use halfedge::geometry::{MergedPoints, UnionFind, merge_points};
use halfedge::words::counted;
use halfedge::{Built, Mesh, NONE, PolygonSoup, TooLarge};
use serde::{Deserialize, Serialize};
use std::collections::{HashMap, HashSet};

/// How faces that don't form a mesh are made one.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Repairs {
    /// What happens to faces at edges where more than two meet.
    pub non_manifold: NonManifold,
    /// Distance, in mesh units, within which vertices are merged; 0 merges those at the same place.
    /// `None` merges none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub merge_by_distance: Option<f32>,
    /// Whether to orient faces consistently. Otherwise edges between faces that disagree are separated,
    /// which cuts the mesh there. A piece without an orientation, like a Möbius strip, is oriented and
    /// cut in any case.
    pub orient: bool,
}

impl Default for Repairs {
    fn default() -> Self {
        Self { non_manifold: NonManifold::Separate, merge_by_distance: None, orient: true }
    }
}

/// What happens to faces at edges where more than two meet.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum NonManifold {
    /// All stay; each gets its own copy of the edge.
    #[default]
    Separate,
    /// The first two in the file's order stay.
    Drop,
}

/// Builds a mesh of a soup with these options, and lists the changes as sentences. Costs O(corners).
///
/// # Errors
/// [`TooLarge`] if ids run out.
pub fn rebuild(soup: &PolygonSoup, repairs: &Repairs) -> Result<(Mesh, Vec<String>), TooLarge> {
    let mut soup = soup.clone();
    let mut notes = repair(&mut soup, repairs);
    let built = finish(soup, &mut notes)?;
    Ok((built.mesh, notes))
}

/// Like [`rebuild`], but takes the soup, and gives it back if something had to be changed.
pub(crate) fn build(
    mut soup: PolygonSoup,
    repairs: &Repairs,
) -> Result<(Mesh, Vec<String>, Option<PolygonSoup>), TooLarge> {
    // The build itself gives back a soup that it changes.
    let given = (*repairs != Repairs::default()).then(|| soup.clone());
    let mut notes = repair(&mut soup, repairs);
    let built = finish(soup, &mut notes)?;
    let original = if notes.is_empty() { None } else { given.or(built.original) };
    Ok((built.mesh, notes, original))
}

/// Applies the options that differ from what the build does; lists the changes.
fn repair(soup: &mut PolygonSoup, repairs: &Repairs) -> Vec<String> {
    let mut notes = Vec::new();
    if let Some(distance) = repairs.merge_by_distance {
        merge(soup, distance.max(0.0), &mut notes);
    }
    if repairs.non_manifold == NonManifold::Drop {
        drop_non_manifold(soup, &mut notes);
    }
    if !repairs.orient {
        separate_disagreeing(soup, &mut notes);
    }
    notes
}

fn finish(soup: PolygonSoup, notes: &mut Vec<String>) -> Result<Built, TooLarge> {
    let mut built = Mesh::build(soup)?;
    if !built.notes.is_empty() || !notes.is_empty() {
        tidy_labels(&mut built.mesh);
    }
    notes.extend(built.notes.iter().map(ToString::to_string));
    Ok(built)
}

/// Merges vertices within the distance of each other, as the operation `merge-by-distance` does.
fn merge(soup: &mut PolygonSoup, distance: f32, notes: &mut Vec<String>) {
    let MergedPoints { kept, number } = merge_points(&soup.positions, shortest(distance));
    let merged = soup.positions.len() - kept.len();
    if merged == 0 {
        return;
    }
    notes.push(format!("{} merged with another within {distance}", counted(merged, "vertex", "vertices")));
    // Corners that refer to missing vertices still do, although there are fewer vertices now.
    soup.corners.iter_mut().for_each(|v| *v = number.get(*v as usize).copied().unwrap_or(NONE));
    keep_vertices(soup, &kept);
}

/// Keeps the vertices with these numbers, in this order, with their attributes. Numbers may repeat.
fn keep_vertices(soup: &mut PolygonSoup, kept: &[u32]) {
    let pick = |column: &mut Column| *column = column.gather(kept.iter().copied());
    soup.vertex_columns.iter_mut().for_each(pick);
    soup.positions = kept.iter().filter_map(|&v| soup.positions.get(v as usize).copied()).collect();
}

/// A face's vertices without consecutive repeats, if the build would accept the face: it has three or more
/// distinct vertices, and all exist.
fn outline(face: &[u32], vertices: usize) -> Option<Vec<u32>> {
    let mut outline = face.to_vec();
    outline.dedup();
    if outline.len() > 1 && outline.first() == outline.last() {
        outline.pop();
    }
    let mut sorted = outline.clone();
    sorted.sort_unstable();
    sorted.dedup();
    let there = sorted.last().is_some_and(|&v| (v as usize) < vertices);
    (there && sorted.len() >= 3 && sorted.len() == outline.len()).then_some(outline)
}

fn ends(a: u32, b: u32) -> (u32, u32) {
    (a.min(b), a.max(b))
}

/// The sides of a face, each as its two vertices.
fn sides(face: &[u32]) -> impl Iterator<Item = (u32, u32)> + '_ {
    face.iter().copied().zip(face.iter().copied().cycle().skip(1))
}

/// A key that faces with the same vertices in the same cyclic order, in either direction, share.
fn canonical(face: &[u32]) -> Vec<u32> {
    let n = face.len();
    let start = (0..n).min_by_key(|&i| face.get(i)).unwrap_or(0);
    let at = |i: usize| face.get(i % n.max(1)).copied().unwrap_or(NONE);
    let forward: Vec<u32> = (0..n).map(|i| at(start + i)).collect();
    let backward: Vec<u32> = (0..n).map(|i| at(start + n - i)).collect();
    forward.min(backward)
}

/// Removes faces at edges where two earlier faces meet.
fn drop_non_manifold(soup: &mut PolygonSoup, notes: &mut Vec<String>) {
    let mut uses: HashMap<(u32, u32), u8> = HashMap::with_capacity(soup.corners.len() / 2);
    let mut met = HashSet::with_capacity(soup.face_count());
    let mut dropped = Vec::new();
    let mut places = Places::default();
    for (f, face) in soup.faces().enumerate() {
        // The build leaves out invalid faces and faces that repeat one that stays: those don't count here.
        // A face that repeats one removed here is removed for the same reason.
        let Some(face) = outline(face, soup.positions.len()) else { continue };
        let canonical = canonical(&face);
        if met.contains(&canonical) {
            continue;
        }
        if sides(&face).any(|(a, b)| uses.get(&ends(a, b)).is_some_and(|&count| count >= 2)) {
            dropped.push(f as u32);
            places.add(f);
            continue;
        }
        met.insert(canonical);
        for (a, b) in sides(&face) {
            *uses.entry(ends(a, b)).or_default() += 1;
        }
    }
    if !places.is_empty() {
        notes.push(places.sentence(
            "face",
            "faces",
            "left out: two earlier faces meet at one of its edges",
            "face",
        ));
        crate::soup::drop_faces(soup, &dropped);
    }
}

/// Gives each piece of consistently oriented faces its own vertices, so that the build reverses none.
fn separate_disagreeing(soup: &mut PolygonSoup, notes: &mut Vec<String>) {
    // Per edge its faces, and whether each runs from the smaller vertex to the larger.
    let mut edges: HashMap<(u32, u32), Vec<(u32, bool)>> = HashMap::with_capacity(soup.corners.len() / 2);
    for (f, face) in soup.faces().enumerate() {
        let Some(face) = outline(face, soup.positions.len()) else { continue };
        for (a, b) in sides(&face) {
            edges.entry(ends(a, b)).or_default().push((f as u32, a < b));
        }
    }
    let mut disagree = 0;
    let mut pieces = UnionFind::new(soup.face_count());
    for faces in edges.values() {
        if let &[(f, up), (g, other)] = faces.as_slice() {
            if up == other {
                disagree += 1;
            } else {
                pieces.union(f, g);
            }
        }
    }
    if disagree == 0 {
        return;
    }
    notes.push(format!(
        "{} separated: the faces there don't face the same way",
        counted(disagree, "edge", "edges")
    ));
    // The first piece at a vertex keeps it.
    let mut owner: HashMap<u32, u32> = HashMap::new();
    let mut copies: HashMap<(u32, u32), u32> = HashMap::new();
    let mut kept: Vec<u32> = (0..soup.positions.len() as u32).collect();
    for f in 0..soup.face_count() {
        let piece = pieces.find(f as u32);
        for corner in soup.face_range(f) {
            let Some(v) = soup.corners.get_mut(corner).filter(|v| (**v as usize) < soup.positions.len())
            else {
                continue;
            };
            if *owner.entry(*v).or_insert(piece) != piece {
                *v = *copies.entry((*v, piece)).or_insert_with(|| {
                    kept.push(*v);
                    kept.len() as u32 - 1
                });
            }
        }
    }
    keep_vertices(soup, &kept);
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use proptest::prelude::*;

    fn with(soup: &PolygonSoup, repairs: Repairs) -> (Mesh, Vec<String>) {
        let (mesh, notes) = rebuild(soup, &repairs).expect("small");
        mesh.validate().expect("valid");
        (mesh, notes)
    }

    fn points(count: usize) -> Vec<Vec3> {
        (0..count).map(|i| Vec3::new(i as f32, (i * i % 7) as f32, (i % 3) as f32)).collect()
    }

    /// Three triangles at one edge.
    fn fin() -> PolygonSoup {
        PolygonSoup::new(points(5), &[[0, 1, 2], [1, 0, 3], [0, 1, 4]])
    }

    #[test]
    fn faces_at_crowded_edges_are_separated_or_left_out() {
        let (mesh, notes) = with(&fin(), Repairs::default());
        assert_eq!(mesh.face_count(), 3);
        assert!(notes[0].contains("1 edge separated: more than two faces"), "{notes:?}");
        let drop = Repairs { non_manifold: NonManifold::Drop, ..Repairs::default() };
        let (mesh, notes) = with(&fin(), drop);
        assert_eq!((mesh.face_count(), mesh.components().1), (2, 2), "two faces, and a vertex alone");
        assert_eq!(notes, ["1 face left out: two earlier faces meet at one of its edges (face 2)"]);
        // A repeated face is left out as one, and not counted as the second at its edges.
        let soup = PolygonSoup::new(points(5), &[[0, 1, 2], [2, 0, 1], [1, 0, 3], [0, 1, 4]]);
        let (mesh, _) = with(&soup, drop);
        assert_eq!(mesh.face_count(), 2);
        assert!(mesh.faces().all(|f| mesh.face_vertices(f).all(|v| v.raw() < 4)));
        // One that repeats a face left out is left out as that is.
        let soup = PolygonSoup::new(points(5), &[[0, 1, 2], [1, 0, 3], [0, 1, 4], [4, 0, 1]]);
        let (mesh, notes) = with(&soup, drop);
        assert_eq!(mesh.face_count(), 2);
        assert_eq!(notes, ["2 faces left out: two earlier faces meet at one of its edges (faces 2, 3)"]);
    }

    #[test]
    fn faces_that_disagree_are_turned_or_separated() {
        let soup = PolygonSoup::new(points(5), &[[0, 1, 2], [0, 1, 3], [1, 3, 4]]);
        let (mesh, notes) = with(&soup, Repairs::default());
        assert_eq!((mesh.vertex_count(), mesh.components().1), (5, 1));
        assert!(notes[0].contains("flipped"), "{notes:?}");
        let (mesh, notes) = with(&soup, Repairs { orient: false, ..Repairs::default() });
        assert_eq!(notes[0], "2 edges separated: the faces there don't face the same way");
        assert_eq!(mesh.components().1, 3);
        let corners: Vec<Vec<Vec3>> =
            mesh.faces().map(|f| mesh.face_vertices(f).map(|v| mesh.position(v)).collect()).collect();
        let expected: Vec<Vec<Vec3>> =
            soup.faces().map(|face| face.iter().map(|&v| soup.positions[v as usize]).collect()).collect();
        assert_eq!(corners, expected, "every face as it is in the file");
    }

    #[test]
    fn near_vertices_become_one_with_the_attributes_of_the_first() {
        let mut soup = PolygonSoup::new(
            vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::X * 1.005, Vec3::Y * 0.995, Vec3::ONE],
            &[[0, 1, 2], [3, 5, 4]],
        );
        let colors = (0..6).map(|i| Vec3::splat(i as f32 / 8.0)).collect();
        soup.vertex_columns.push(Column::with_values(halfedge::keys::VERTEX_COLOR, colors));
        let near = |distance| Repairs { merge_by_distance: Some(distance), ..Repairs::default() };
        let (mesh, notes) = with(&soup, near(0.01));
        assert_eq!((mesh.vertex_count(), mesh.edge_count(), mesh.face_count()), (4, 5, 2));
        assert_eq!(notes, ["2 vertices merged with another within 0.01"]);
        assert_eq!(mesh.get(halfedge::keys::VERTEX_COLOR, 3), Vec3::splat(5.0 / 8.0));
        assert_eq!(with(&soup, near(0.0)).0.vertex_count(), 6);
        assert_eq!(with(&soup, near(1e-30)).0.vertex_count(), 6);
        assert_eq!(with(&soup, near(f32::MAX)).0.face_count(), 0);
        (soup.positions[3], soup.positions[4]) = (Vec3::X, Vec3::Y);
        assert_eq!(with(&soup, near(0.0)).0.vertex_count(), 4);
    }

    proptest! {
        #[test]
        fn any_soup_becomes_a_mesh(
            faces in prop::collection::vec(prop::collection::vec(0u32..9, 0..6), 0..24),
            drop: bool, orient: bool, distance in prop::option::of(prop::sample::select(vec![0.0f32, 0.5, 1.5, 9.0])),
        ) {
            let soup = PolygonSoup::new(points(8), &faces);
            let non_manifold = if drop { NonManifold::Drop } else { NonManifold::Separate };
            let repairs = Repairs { non_manifold, orient, merge_by_distance: distance };
            let (mesh, notes) = with(&soup, repairs);
            prop_assert!(mesh.face_count() <= faces.len());
            if drop {
                prop_assert!(!notes.iter().any(|note| note.contains("more than two faces")), "{:?}", notes);
            }
        }
    }
}
