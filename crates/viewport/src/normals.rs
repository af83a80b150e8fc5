//! Normals for shading: one per face, or area-weighted averages per vertex.

use glam::{DVec3, Vec3};
use halfedge::{FaceId, Mesh, VertexId};

/// The area vector of a polygon (Newell's method): along its normal, twice its area long. In double
/// precision, so that squares of coordinates neither overflow nor vanish.
pub fn area_vector(corners: &[Vec3]) -> DVec3 {
    let Some((&first, rest)) = corners.split_first() else { return DVec3::ZERO };
    // Relative to the first corner: exact for corners close to each other and far from the origin.
    let first = first.as_dvec3();
    rest.windows(2)
        .map(|pair| match *pair {
            [a, b] => (a.as_dvec3() - first).cross(b.as_dvec3() - first),
            _ => DVec3::ZERO,
        })
        .sum()
}

/// The area vector of a face of the mesh.
pub fn face_area_vector(mesh: &Mesh, face: FaceId, scratch: &mut Vec<Vec3>) -> DVec3 {
    scratch.clear();
    scratch.extend(mesh.face_vertices(face).map(|v| mesh.position(v)));
    area_vector(scratch)
}

/// The sum of the area vectors of the faces around a vertex. Costs O(corners of those faces).
pub fn vertex_area_vector(mesh: &Mesh, vertex: VertexId, scratch: &mut Vec<Vec3>) -> DVec3 {
    mesh.vertex_faces(vertex).map(|f| face_area_vector(mesh, f, scratch)).sum()
}

/// A unit vector in the format of the vertex buffer; zero stays zero, which shaders take for "no
/// normal".
pub fn pack(normal: DVec3) -> [i16; 4] {
    let unit = (normal.normalize_or_zero() * 32767.0).round();
    [unit.x as i16, unit.y as i16, unit.z as i16, 0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::vec3;

    #[test]
    fn a_polygons_area_vector_is_twice_its_area_along_the_normal() {
        let far = vec3(1e6, 0.0, 0.0);
        let square =
            [vec3(0., 0., 0.), vec3(1., 0., 0.), vec3(1., 1., 0.), vec3(0., 1., 0.)].map(|p| p + far);
        assert_eq!(area_vector(&square), DVec3::new(0.0, 0.0, 2.0));
        assert_eq!(area_vector(&square[..2]), DVec3::ZERO);
        assert_eq!(area_vector(&[]), DVec3::ZERO);
    }

    #[test]
    fn tiny_and_huge_polygons_have_normals() {
        for size in [1e-30_f32, 1e30] {
            let triangle = [Vec3::ZERO, Vec3::X * size, Vec3::Y * size];
            assert_eq!(pack(area_vector(&triangle)), [0, 0, 32767, 0], "{size}");
        }
        assert_eq!(pack(DVec3::ZERO), [0; 4]);
    }
}
