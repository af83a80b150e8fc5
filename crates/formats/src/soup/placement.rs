//! Where vertices go: with a node, or with the joints of a skeleton.

use crate::soup::is_mirrored;
use glam::{DMat4, Vec3};

/// How the vertices of a shape get to the world.
pub(crate) enum Placement {
    /// All by one transform.
    Rigid(DMat4),
    /// Each by a mean of the transforms of joints.
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

    /// Whether nothing moves.
    pub(crate) fn is_identity(&self) -> bool {
        matches!(self, Self::Rigid(transform) if *transform == DMat4::IDENTITY)
    }

    /// A direction of unit length, turned as a vertex is; untouched, to the bit, where nothing moves.
    pub(crate) fn direction(&self, vertex: usize, direction: Vec3) -> Vec3 {
        if self.is_identity() {
            return direction;
        }
        // Directions turn with the inverse transpose.
        let turn: DMat4 = self.of(vertex).inverse().transpose();
        turn.transform_vector3(direction.as_dvec3()).normalize_or_zero().as_vec3()
    }

    /// Whether shapes come out mirrored.
    pub(crate) fn is_mirrored(&self) -> bool {
        is_mirrored(self.of(0))
    }
}

/// Vertices with the joints that move them.
pub(crate) struct Skin {
    /// For each joint, where the geometry goes with it.
    pub joints: Vec<DMat4>,
    /// Where vertices are that no joint moves.
    pub rest: DMat4,
    pub influences: Influences,
}

/// The joints that move each vertex.
#[derive(Default)]
pub(crate) struct Influences {
    /// Where those of each vertex start; one more than there are vertices.
    pub starts: Vec<u32>,
    /// Joints, or anything beyond those for the resting place, with weights.
    pub list: Vec<(u32, f32)>,
}

impl Influences {
    fn of(&self, vertex: usize) -> &[(u32, f32)] {
        let range = self.starts.get(vertex).zip(self.starts.get(vertex + 1));
        range.and_then(|(start, end)| self.list.get(*start as usize..*end as usize)).unwrap_or_default()
    }
}

impl Skin {
    /// The mean of the joints' transforms by weight.
    fn of(&self, vertex: usize) -> DMat4 {
        let mut sum = DMat4::ZERO;
        let mut weights = 0.0;
        for &(joint, weight) in self.influences.of(vertex) {
            let weight = f64::from(weight);
            sum += *self.joints.get(joint as usize).unwrap_or(&self.rest) * weight;
            weights += weight;
        }
        // One whole weight leaves its joint's transform as it is, to the bit.
        if weights == 1.0 {
            return sum;
        }
        if weights > 0.0 { sum * (1.0 / weights) } else { self.rest }
    }
}
