//! Merging vertices that are close to each other.

use crate::error::{SurfaceError, require};
use crate::pace::Pace;
use halfedge::attribute::Column;
use halfedge::geometry::{MergedPoints, PointMerger};
use halfedge::{Element, Mesh, NONE, Note, NumberRange, PolygonSoup, Progress};

/// A mesh with close vertices merged.
#[derive(Debug)]
pub struct Merged {
    /// The mesh.
    pub mesh: Mesh,
    /// The number of vertices that were merged into others.
    pub merged: usize,
    /// What was repaired because the result was not a manifold.
    pub notes: Vec<Note>,
}

/// Merges vertices within `distance` of each other (mesh units; 0 for those at the same place).
///
/// In order of id, each vertex is merged into the nearest earlier one that stays, if one is within the
/// distance (see [`PointMerger`]), and takes its position and attributes. Faces lose corners that coincide;
/// those left with fewer than three are dropped. The rest is built as a file's faces are: what doesn't form a
/// manifold is repaired and noted. Costs O(n log n), whatever the distance.
///
/// # Errors
/// [`SurfaceError::BadField`] for a distance that is negative or not finite; [`SurfaceError::Cancelled`].
pub fn merge_by_distance(
    mesh: &Mesh,
    distance: f64,
    progress: &mut Progress<'_>,
) -> Result<Merged, SurfaceError> {
    require("distance", distance, NumberRange::NOT_NEGATIVE)?;
    let mut pace = Pace::new(progress);
    pace.at(0.0)?;
    let source = mesh.to_soup();
    let mut merger = PointMerger::new(&source.positions, distance);
    pace.part(0.0, 0.6).chunks(source.positions.len(), |range| merger.add(range))?;
    let MergedPoints { kept, number } = merger.finish();
    let renumber = |v: u32| number[v as usize];
    let mut soup = PolygonSoup {
        positions: kept.iter().map(|&v| source.positions[v as usize]).collect(),
        ..PolygonSoup::default()
    };
    let (mut corners, mut faces) = (Vec::new(), Vec::new());
    for face in 0..source.face_count() {
        let start = soup.corners.len();
        let corner_start = corners.len();
        for corner in source.face_range(face) {
            let v = renumber(source.corners[corner]);
            if soup.corners.len() == start || soup.corners.last() != Some(&v) {
                soup.corners.push(v);
                corners.push(corner as u32);
            }
        }
        while soup.corners.len() > start + 1 && soup.corners.last() == soup.corners.get(start) {
            soup.corners.pop();
            corners.pop();
        }
        if soup.corners.len() < start + 3 {
            soup.corners.truncate(start);
            corners.truncate(corner_start);
            continue;
        }
        soup.face_starts.push(soup.corners.len() as u32);
        faces.push(face as u32);
    }
    pace.at(0.7)?;
    let pick = |columns: Vec<Column>, indices: &[u32]| -> Vec<Column> {
        columns.into_iter().map(|column| column.gather(indices.iter().copied())).collect()
    };
    soup.vertex_columns = pick(source.vertex_columns, &kept);
    soup.corner_columns = pick(source.corner_columns, &corners);
    soup.face_columns = pick(source.face_columns, &faces);
    let merged = number.len() - kept.len();
    // Building takes as much memory again: free what it doesn't need.
    drop((source.positions, source.corners, source.face_starts, kept, corners, faces));
    let built = Mesh::build(soup).map_err(|e| SurfaceError::TooManyFaces {
        faces: e.corners as u64 / 3,
        limit: Mesh::MAX_EDGES as u64 / 3,
    })?;
    let mut result = built.mesh;
    carry_edges(mesh, &mut result, renumber);
    pace.at(1.0)?;
    Ok(Merged { mesh: result, merged, notes: built.notes })
}

/// Copies edge attributes to the edges with the same ends; where two edges became one, the first counts.
fn carry_edges(mesh: &Mesh, result: &mut Mesh, renumber: impl Fn(u32) -> u32) {
    let columns = mesh.columns().of(Element::Edge);
    if columns.is_empty() {
        return;
    }
    let mesh = mesh.to_compact();
    let mut source = vec![NONE; result.edge_capacity()];
    for e in mesh.edges() {
        let ends = mesh.ends(e).map(|v| result.vertex(renumber(v.raw())));
        let [Some(a), Some(b)] = ends else { continue };
        if let Some(edge) = result.find_edge(a, b)
            && source[edge.index()] == NONE
        {
            source[edge.index()] = e.raw();
        }
    }
    for column in mesh.columns().of(Element::Edge) {
        result.insert_column(Element::Edge, column.gather(source.iter().copied()));
    }
}
