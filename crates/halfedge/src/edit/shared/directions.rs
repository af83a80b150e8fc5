//! Normals and directions for placing new vertices.

use crate::geometry::{face_area_vector, mean_position};
use crate::mesh::Mesh;
use crate::{FaceId, HalfedgeId, VertexId};
use glam::Vec3;

/// The largest length of a mitre.
const MAX_MITER: f32 = 4.0;

impl Mesh {
    /// The unit normal of a face, by Newell's method; zero for a face without area.
    pub(crate) fn unit_normal(&self, face: FaceId) -> Vec3 {
        face_area_vector(self, face).normalize_or_zero().as_vec3()
    }

    /// The mean of a face's corners.
    pub(crate) fn corner_mean(&self, face: FaceId) -> Vec3 {
        mean_position(self, self.face_vertices(face)).as_vec3()
    }

    /// The unit vector along a half-edge; zero for one without length.
    pub(crate) fn direction(&self, h: HalfedgeId) -> Vec3 {
        let [from, to] = [self.position(self.from(h)), self.position(self.to(h))];
        // Squares of very large and very small lengths are out of the range of single precision.
        (to - from)
            .try_normalize()
            .unwrap_or_else(|| (to.as_dvec3() - from.as_dvec3()).normalize_or_zero().as_vec3())
    }
}

/// The half-edges that leave a vertex, counter-clockwise; at a boundary vertex from the edge after the gap to the
/// one before it.
pub(crate) fn counter_clockwise(mesh: &Mesh, v: VertexId) -> Vec<HalfedgeId> {
    let mut all: Vec<HalfedgeId> = mesh.outgoing(v).collect();
    all.reverse();
    all
}

/// How a corner moves when the two lines through it move by one along these unit vectors, which are perpendicular
/// to the lines: the mitre, in the span of the vectors. It is cut off at a length of 4 where the lines nearly double
/// back.
pub(crate) fn miter(a: Vec3, b: Vec3) -> Vec3 {
    let sum = a + b;
    // |sum|² = 2 (1 + a·b), and the mitre is sum / (1 + a·b).
    let one_plus_cos = sum.length_squared() / 2.0;
    (sum / one_plus_cos.max(1e-6)).clamp_length_max(MAX_MITER)
}
