//! Placements: vertices follow a node, or the joints of a skeleton.

use crate::soup::is_mirrored;
use glam::{DMat4, Vec3};

/// How the vertices of a shape are transformed to the world.
pub(crate) enum Placement {
    /// All vertices by one transform.
    Rigid(DMat4),
    /// Each vertex by a weighted mean of joint transforms.
    Skinned(Skin),
}

impl Placement {
    /// The transform of a vertex.
    pub(crate) fn of(&self, vertex: usize) -> DMat4 {
        match self {
            Self::Rigid(transform) => *transform,
            Self::Skinned(skin) => skin.of(vertex),
        }
    }

    /// Whether the placement changes nothing.
    pub(crate) fn is_identity(&self) -> bool {
        matches!(self, Self::Rigid(transform) if *transform == DMat4::IDENTITY)
    }

    /// Transforms the direction of a normal at a vertex to unit length. The identity keeps it to the bit.
    pub(crate) fn direction(&self, vertex: usize, direction: Vec3) -> Vec3 {
        if self.is_identity() {
            return direction;
        }
        // Normals transform with the inverse transpose.
        let turn: DMat4 = self.of(vertex).inverse().transpose();
        turn.transform_vector3(direction.as_dvec3()).normalize_or_zero().as_vec3()
    }

    /// Whether it mirrors shapes.
    pub(crate) fn is_mirrored(&self) -> bool {
        is_mirrored(self.of(0))
    }
}

/// The transforms of joints, and the joints that move each vertex.
pub(crate) struct Skin {
    /// The transform of each joint.
    pub joints: Vec<DMat4>,
    /// The transform of vertices that no joint moves.
    pub rest: DMat4,
    pub influences: Influences,
}

/// The joints that move each vertex.
#[derive(Default)]
pub(crate) struct Influences {
    /// For each vertex the start of its joints in `list`, and the end of the list.
    pub starts: Vec<u32>,
    /// Joints with weights; numbers beyond the joints stand for `rest`.
    pub list: Vec<(u32, f32)>,
}

impl Influences {
    fn of(&self, vertex: usize) -> &[(u32, f32)] {
        let range = self.starts.get(vertex).zip(self.starts.get(vertex + 1));
        range.and_then(|(start, end)| self.list.get(*start as usize..*end as usize)).unwrap_or_default()
    }
}

impl Skin {
    /// The weighted mean of the joints' transforms.
    fn of(&self, vertex: usize) -> DMat4 {
        let mut sum = DMat4::ZERO;
        let mut weights = 0.0;
        for &(joint, weight) in self.influences.of(vertex) {
            let weight = f64::from(weight);
            sum += *self.joints.get(joint as usize).unwrap_or(&self.rest) * weight;
            weights += weight;
        }
        // A single weight of 1 keeps the joint's transform to the bit.
        if weights == 1.0 {
            return sum;
        }
        if weights > 0.0 { sum * (1.0 / weights) } else { self.rest }
    }
}
