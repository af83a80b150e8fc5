//! Normals and directions that edits place new vertices by.

use crate::geometry::{face_area_vector, mean_position};
use crate::mesh::Mesh;
use crate::{FaceId, HalfedgeId};
use glam::Vec3;

impl Mesh {
    /// The unit normal of a face by Newell's sum, which is right for any polygon; zero for a face
    /// without area.
    pub(crate) fn newell_normal(&self, face: FaceId) -> Vec3 {
        face_area_vector(self, face).normalize_or_zero().as_vec3()
    }

    /// The mean of a face's corners.
    pub(crate) fn corner_mean(&self, face: FaceId) -> Vec3 {
        mean_position(self, self.face_vertices(face)).as_vec3()
    }

    /// The unit vector along a half-edge; zero for one without length.
    pub(crate) fn direction(&self, h: HalfedgeId) -> Vec3 {
        (self.position(self.to(h)) - self.position(self.from(h))).normalize_or_zero()
    }
}

/// The vector, in the span of two unit vectors, by which a corner moves when the lines through it
/// that the vectors are perpendicular to each move by one along them: a mitre. Where the lines
/// nearly double back it is cut off at four.
pub(crate) fn miter(a: Vec3, b: Vec3) -> Vec3 {
    let sum = a + b;
    // |sum|² = 2 (1 + a·b), and the mitre is sum / (1 + a·b).
    let one_plus_cos = sum.length_squared() / 2.0;
    (sum / one_plus_cos.max(1e-6)).clamp_length_max(4.0)
}
