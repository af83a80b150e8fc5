//! Merging corners at exactly the same position into shared vertices.

use crate::soup::hash::Unique;
use glam::Vec3;

/// Numbers positions. Positions that are equal to the bit, except for the sign of zero, have the same number.
pub(crate) struct Weld {
    unique: Unique<3>,
    /// Each position once, in order of first appearance.
    pub positions: Vec<Vec3>,
}

impl Weld {
    pub(crate) fn new() -> Self {
        Self { unique: Unique::new(), positions: Vec::new() }
    }

    /// The number of a position.
    pub(crate) fn vertex(&mut self, position: Vec3) -> u32 {
        // Adding zero makes a negative zero positive and changes nothing else.
        let (number, new) = self.unique.number((position + Vec3::ZERO).to_array());
        if new {
            self.positions.push(position);
        }
        number
    }
}
