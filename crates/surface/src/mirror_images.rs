//! The vertices at the mirror images of others, for symmetric edits.

use glam::{DVec3, Vec3};
use halfedge::{Mesh, VertexId};

/// How far from a mirror image its vertex may be, as a share of the largest coordinate.
const TOLERANCE_SHARE: f64 = 1e-4;

/// A direction that few models are aligned with, so that few vertices are at the same place along it.
const SORTED_ALONG: DVec3 = DVec3::new(0.597, 0.3917, 0.7001);

/// For each of these vertices, the vertex nearest to its mirror image across the plane through the origin that an axis
/// (0 to 2) is normal to: itself if it lies in the plane, none if no vertex is near the image. Near is within 1/10,000
/// of the mesh's largest coordinate.
///
/// Costs O(n log k) for k vertices in a mesh of n.
pub fn mirror_images(mesh: &Mesh, vertices: &[VertexId], axis: usize) -> Vec<Option<VertexId>> {
    let all = || mesh.vertices().map(|v| (v, mesh.position(v).as_dvec3()));
    let largest = all().map(|(_, at)| at.abs().max_element()).fold(0.0, f64::max);
    let tolerance = largest * TOLERANCE_SHARE;
    let place = |at: DVec3| at.dot(SORTED_ALONG);
    let mut images: Vec<(f64, usize, DVec3)> = vertices
        .iter()
        .enumerate()
        .map(|(index, v)| {
            let image = mirrored(mesh.position(*v), axis).as_dvec3();
            (place(image), index, image)
        })
        .collect();
    images.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let mut nearest = vec![(tolerance, None); vertices.len()];
    // A place differs by at most the length of the direction times the distance.
    let reach = tolerance * SORTED_ALONG.length();
    for (v, at) in all() {
        let here = place(at);
        let first = images.partition_point(|image| image.0 < here - reach);
        for (_, index, image) in images.iter().skip(first).take_while(|image| image.0 <= here + reach) {
            let Some(best) = nearest.get_mut(*index) else { continue };
            let distance = image.distance(at);
            // In the plane, the vertex itself is meant, and the earlier one of two.
            let is_itself = vertices.get(*index) == Some(&v);
            if distance < best.0 || (distance == best.0 && (best.1.is_none() || is_itself)) {
                *best = (distance, Some(v));
            }
        }
    }
    nearest.into_iter().map(|(_, v)| v).collect()
}

/// The mirror image of a point or a movement across the plane through the origin that an axis (0 to 2) is normal to.
pub fn mirrored(point: Vec3, axis: usize) -> Vec3 {
    let mut image = point.to_array();
    if let Some(coordinate) = image.get_mut(axis) {
        *coordinate = -*coordinate;
    }
    image.into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Shape;

    fn shape(name: &str) -> Mesh {
        Shape::named(name).expect("a shape").build().expect("a mesh")
    }

    #[test]
    fn images_are_where_they_should_be() {
        for name in ["cube", "uv-sphere", "torus", "grid"] {
            let mesh = shape(name);
            let vertices: Vec<VertexId> = mesh.vertices().collect();
            for axis in [0, 2] {
                for (v, image) in vertices.iter().zip(mirror_images(&mesh, &vertices, axis)) {
                    let (at, image) = (mesh.position(*v), image.expect("symmetric"));
                    assert!(mesh.position(image).distance(mirrored(at, axis)) < 1e-4, "{name}: {v}");
                    assert_eq!(image == *v, at[axis].abs() < 5e-5, "{name}: {v}");
                }
            }
        }
    }

    #[test]
    fn a_vertex_without_its_image_has_none() {
        let mut mesh = shape("cube");
        let v = VertexId::new(7);
        mesh.set_position(v, Vec3::new(1.0, 1.1, 1.0));
        let other =
            mesh.vertices().find(|u| mesh.position(*u) == Vec3::new(-1.0, 1.0, 1.0)).expect("a corner");
        assert_eq!(mirror_images(&mesh, &[v, other], 0), [None, None]);
    }
}
