//! Numbering values by their bits, to store equal values once.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

/// A hash by multiplication and folding: fast for the few words of a position or texture coordinate, and well
/// distributed in the bits that the table uses. Crafted input can make it slow but not wrong; the size of the
/// file bounds the maps.
#[derive(Default)]
pub(crate) struct WordHasher(u64);

impl Hasher for WordHasher {
    fn finish(&self) -> u64 {
        self.0
    }

    fn write(&mut self, bytes: &[u8]) {
        for &byte in bytes {
            self.write_u64(u64::from(byte));
        }
    }

    fn write_u32(&mut self, word: u32) {
        self.write_u64(u64::from(word));
    }

    fn write_u64(&mut self, word: u64) {
        let wide = u128::from(self.0 ^ word ^ 0x9e37_79b9_7f4a_7c15) * 0xa076_1d64_78bd_642f_u128;
        self.0 = (wide >> 64) as u64 ^ wide as u64;
    }
}

/// Numbers values in order of first appearance.
pub(crate) struct Unique<const N: usize> {
    numbers: HashMap<[u32; N], u32, BuildHasherDefault<WordHasher>>,
}

impl<const N: usize> Unique<N> {
    pub(crate) fn new() -> Self {
        Self { numbers: HashMap::default() }
    }

    /// The number of a value, compared by its bits, and whether it is new.
    pub(crate) fn number(&mut self, value: [f32; N]) -> (u32, bool) {
        let next = self.numbers.len() as u32;
        let number = *self.numbers.entry(value.map(f32::to_bits)).or_insert(next);
        (number, number == next)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_bits_have_one_number() {
        let mut unique = Unique::new();
        assert_eq!(unique.number([0.0, 1.0]), (0, true));
        assert_eq!(unique.number([-0.0, 1.0]), (1, true));
        assert_eq!(unique.number([0.0, 1.0]), (0, false));
        assert_eq!(unique.number([1.0, 0.0]), (2, true));
    }
}
