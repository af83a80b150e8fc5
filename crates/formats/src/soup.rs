//! Changes to polygon soups that several formats need.

use glam::{DMat3, DMat4};
use halfedge::attribute::{AttributeType, Column, Key};
use halfedge::{Element, Mesh, NONE, PolygonSoup, keys};

/// Whether a transform mirrors: shapes come out inside out, unless their faces go the other way round
/// (glTF 2.0, 3.7.4).
pub(crate) fn is_mirrored(transform: DMat4) -> bool {
    DMat3::from_mat4(transform).determinant() < 0.0
}

/// Takes faces out of a soup with their corners and attributes. `dropped` is in ascending order.
pub(crate) fn drop_faces(soup: &mut PolygonSoup, dropped: &[u32]) {
    if dropped.is_empty() {
        return;
    }
    let mut dropped = dropped.iter().copied().peekable();
    let mut faces: Vec<u32> = Vec::with_capacity(soup.face_count());
    let mut corners: Vec<u32> = Vec::with_capacity(soup.corners.len());
    let mut face_starts = vec![0];
    for face in 0..soup.face_count() {
        if dropped.next_if(|&gone| gone as usize == face).is_some() {
            continue;
        }
        let range = soup.face_range(face);
        faces.push(face as u32);
        corners.extend(range.start as u32..range.end as u32);
        face_starts.push(corners.len() as u32);
    }
    let pick = |column: &mut Column, from: &[u32]| {
        *column = column.gather(from.iter().copied());
    };
    soup.face_columns.iter_mut().for_each(|column| pick(column, &faces));
    soup.corner_columns.iter_mut().for_each(|column| pick(column, &corners));
    soup.corners = corners.iter().filter_map(|&corner| soup.corners.get(corner as usize).copied()).collect();
    soup.face_starts = face_starts;
}

/// Leaves out labels that no face has and numbers the rest in order of first use: after faces were
/// dropped, so that the mesh written and read again is the same.
pub(crate) fn tidy_labels(mesh: &mut Mesh) {
    for key in [keys::FACE_GROUP, keys::FACE_MATERIAL] {
        let Some(column) = mesh.column(Element::Face, key.name) else { continue };
        let Some(values) = mesh.attribute(key) else { continue };
        let tidy = labelled(key, values.to_vec(), &column.labels);
        mesh.insert_column(Element::Face, tidy);
    }
}

/// A column of corners from values of vertices, as far as those are there.
pub(crate) fn of_vertices<T: AttributeType>(soup: &PolygonSoup, key: Key<T>, values: &[T]) -> Column {
    let corner = |&v: &u32| values.get(v as usize).copied().unwrap_or(key.default);
    Column::with_values(key, soup.corners.iter().map(corner).collect())
}

/// A labelled column: `values` are numbers of `names` or [`NONE`]; labels no value uses are left
/// out and the rest numbered in order of first use.
pub(crate) fn labelled(key: Key<u32>, mut values: Vec<u32>, names: &[String]) -> Column {
    let mut labels = Vec::new();
    let mut renumbered = vec![NONE; names.len()];
    for value in &mut values {
        let Some((number, name)) = renumbered.get_mut(*value as usize).zip(names.get(*value as usize)) else {
            *value = NONE;
            continue;
        };
        if *number == NONE {
            *number = labels.len() as u32;
            labels.push(name.clone());
        }
        *value = *number;
    }
    Column { labels, ..Column::with_values(key, values) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    #[test]
    fn dropped_faces_take_their_attributes_along() {
        let mut soup =
            PolygonSoup::new(vec![Vec3::ZERO; 5], &[vec![0, 1, 2], vec![1, 2, 3, 4], vec![2, 3, 4]]);
        soup.face_columns.push(Column::with_values(keys::FACE_GROUP, vec![7, 8, 9]));
        soup.corner_columns
            .push(Column::with_values(keys::CORNER_NORMAL, (0..10).map(|i| Vec3::splat(i as f32)).collect()));
        drop_faces(&mut soup, &[1]);
        assert_eq!(soup.face_starts, [0, 3, 6]);
        assert_eq!(soup.corners, [0, 1, 2, 2, 3, 4]);
        assert_eq!(soup.face_columns, [Column::with_values(keys::FACE_GROUP, vec![7, 9])]);
        let normals = [0, 1, 2, 7, 8, 9].map(|i: i32| Vec3::splat(i as f32)).to_vec();
        assert_eq!(soup.corner_columns, [Column::with_values(keys::CORNER_NORMAL, normals)]);
    }
}
