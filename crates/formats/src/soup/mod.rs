//! Polygon soups: changes that several formats need, and how a soup becomes a mesh.

pub(crate) mod corner_colors;
pub(crate) mod hash;
pub(crate) mod holes;
pub(crate) mod origin;
pub(crate) mod pieces;
pub(crate) mod placement;
pub(crate) mod repairs;
pub(crate) mod weld;

use glam::{DMat3, DMat4};
use halfedge::PolygonSoup;
use halfedge::attribute::{AttributeType, Column, Key};

/// Whether a transform mirrors: it turns shapes inside out, unless their faces are reversed (glTF 2.0,
/// 3.7.4).
pub(crate) fn is_mirrored(transform: DMat4) -> bool {
    DMat3::from_mat4(transform).determinant() < 0.0
}

/// Removes faces with their corners and attributes. `dropped` is in ascending order.
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

/// A corner column of the values of the corners' vertices; the default where a vertex has none.
pub(crate) fn of_vertices<T: AttributeType>(soup: &PolygonSoup, key: Key<T>, values: &[T]) -> Column {
    let corner = |&v: &u32| values.get(v as usize).copied().unwrap_or(key.default);
    Column::with_values(key, soup.corners.iter().map(corner).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use halfedge::keys;

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
