//! The area vector of a polygon, by Newell's method.

use crate::{Connectivity, FaceId, Mesh};
use glam::{DVec3, Vec3};

/// The area vector of a polygon: its direction is the polygon's normal, its length the area. Seen
/// from its tip the corners run counter-clockwise. Concave and non-planar polygons have one too.
/// Zero for fewer than three corners.
///
/// Newell's method, in 64 bits and relative to the first corner, so that a polygon far from the
/// origin keeps its precision. Costs O(corners).
#[inline]
pub fn polygon_area_vector(corners: impl IntoIterator<Item = Vec3>) -> DVec3 {
    let mut corners = corners.into_iter().map(|corner| corner.as_dvec3());
    let (Some(base), Some(second)) = (corners.next(), corners.next()) else { return DVec3::ZERO };
    let mut before = second - base;
    let mut sum = DVec3::ZERO;
    for corner in corners {
        let here = corner - base;
        sum += before.cross(here);
        before = here;
    }
    sum * 0.5
}

/// The area vector of a face: [`polygon_area_vector`] of its corners. Costs O(corners).
pub fn face_area_vector(mesh: &Mesh, face: FaceId) -> DVec3 {
    linked_area_vector(mesh.connectivity(), mesh.positions(), face.index())
}

/// [`face_area_vector`] of the face with this number, for algorithms that go through all of a mesh's
/// columns.
#[inline]
pub fn linked_area_vector(links: Connectivity<'_>, positions: &[Vec3], face: usize) -> DVec3 {
    let first = links.face_halfedge[face];
    // Half-edges point to the corner after the one they leave: the last is left out.
    let mut h = first;
    let others = std::iter::from_fn(|| {
        let after = links.next[h as usize];
        let to = links.to[h as usize];
        h = after;
        (after != first).then(|| positions[to as usize])
    });
    let first_corner = positions[links.to[first as usize ^ 1] as usize];
    polygon_area_vector(std::iter::once(first_corner).chain(others))
}
