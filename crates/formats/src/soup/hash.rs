//! A map from the bits of values to their number, for keeping equal values once.

use std::collections::HashMap;
use std::hash::{BuildHasherDefault, Hasher};

/// Multiply and fold: quick on the few words that positions and texture coordinates are, and well
/// spread in the bits the table looks at. Crafted input can make it slow, never wrong; the maps
/// here are bounded by the size of the file they are filled from.
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

/// Numbers for values, in order of first appearance.
pub(crate) struct Unique<const N: usize> {
    numbers: HashMap<[u32; N], u32, BuildHasherDefault<WordHasher>>,
}

impl<const N: usize> Unique<N> {
    pub(crate) fn new() -> Self {
        Self { numbers: HashMap::default() }
    }

    /// The number of a value told by its bits, and whether it is new.
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
