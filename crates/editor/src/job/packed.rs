//! Packed columns, for files and links: the same values in an order and form that compress well.
//!
//! A length is a varint: seven bits to a byte, the lowest first, with the high bit set in all bytes but the last. The values
//! of a column are written byte by byte: the first bytes of all values, then their second bytes, and so on, because the
//! first bytes of neighbours have more in common than the bytes of one value. Ids are written as varints of the differences
//! to what is expected; a byte before them says what that is. Negative differences alternate with positive ones (0, -1, 1,
//! -2, ...), so that small ones are short.

use super::wire::BadBytes;
use std::io::{self, Write};

/// The most bytes of a varint of 64 bits.
const MAX_VARINT_BYTES: u32 = 10;

/// What an id is expected to be.
#[derive(Clone, Copy)]
#[repr(u8)]
enum Expected {
    /// The id before it, at first 0.
    Previous = 0,
    /// Its place in the column.
    Place = 1,
}

/// The bytes of a varint.
pub(crate) fn varint(value: u64) -> Vec<u8> {
    let mut bytes = Vec::with_capacity(2);
    push_varint(&mut bytes, value);
    bytes
}

fn push_varint(bytes: &mut Vec<u8>, mut value: u64) {
    while value >= 0x80 {
        bytes.push(value as u8 | 0x80);
        value >>= 7;
    }
    bytes.push(value as u8);
}

/// A varint, from bytes that `next` gives.
pub(crate) fn read_varint(mut next: impl FnMut() -> Result<u8, BadBytes>) -> Result<u64, BadBytes> {
    let mut value = 0u64;
    for at in 0..MAX_VARINT_BYTES {
        let byte = next()?;
        let bits = u64::from(byte & 0x7f);
        let shifted = bits << (7 * at);
        if shifted >> (7 * at) != bits {
            break;
        }
        value |= shifted;
        if byte < 0x80 {
            return Ok(value);
        }
    }
    Err(BadBytes::new("a length is too large"))
}

/// Writes values of `size` bytes: their first bytes, then their second ones, and so on.
pub(super) fn write_planes(out: &mut dyn Write, values: &[u8], size: usize) -> io::Result<()> {
    if size <= 1 {
        return out.write_all(values);
    }
    let mut plane = Vec::with_capacity(values.len() / size);
    for at in 0..size {
        plane.clear();
        plane.extend(values.iter().skip(at).step_by(size));
        out.write_all(&plane)?;
    }
    Ok(())
}

/// Gives the values of `size` bytes their bytes at this place.
pub(super) fn put_plane(values: &mut [u8], plane: &[u8], at: usize, size: usize) {
    for (value, byte) in values.iter_mut().skip(at).step_by(size).zip(plane) {
        *value = *byte;
    }
}

/// Ids as differences, from the previous ones or from their places, whichever is shorter.
pub(super) fn pack_links(ids: &[u32]) -> Vec<u8> {
    let pack = |expected: Expected| {
        let mut bytes = Vec::with_capacity(ids.len() + 1);
        bytes.push(expected as u8);
        let mut previous = 0;
        for (place, &id) in (0u32..).zip(ids) {
            let base = match expected {
                Expected::Previous => previous,
                Expected::Place => place,
            };
            let difference = id.wrapping_sub(base) as i32;
            push_varint(&mut bytes, u64::from(((difference << 1) ^ (difference >> 31)) as u32));
            previous = id;
        }
        bytes
    };
    let (previous, place) = (pack(Expected::Previous), pack(Expected::Place));
    if place.len() < previous.len() { place } else { previous }
}

/// This many ids that were packed. Each takes a byte at least, so a false number reserves no memory.
pub(super) fn unpack_links(bytes: &[u8], len: usize) -> Result<Vec<u32>, BadBytes> {
    let too_early = || BadBytes::new("they end too early");
    let (&expected, bytes) = bytes.split_first().ok_or_else(too_early)?;
    if len > bytes.len() {
        return Err(too_early());
    }
    if expected > Expected::Place as u8 {
        return Err(BadBytes::new("ids are packed in an unknown way"));
    }
    let mut bytes = bytes.iter();
    let mut ids = Vec::with_capacity(len + len / 16);
    let mut previous = 0u32;
    for place in (0u32..).take(len) {
        let packed = read_varint(|| bytes.next().copied().ok_or_else(too_early))?;
        let packed = u32::try_from(packed).map_err(|_| BadBytes::new("an id is too large"))?;
        let difference = (packed >> 1) ^ (packed & 1).wrapping_neg();
        let base = if expected == Expected::Place as u8 { place } else { previous };
        previous = base.wrapping_add(difference);
        ids.push(previous);
    }
    if bytes.next().is_some() { Err(BadBytes::new("bytes follow after a column")) } else { Ok(ids) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn links_come_back(ids in prop::collection::vec(prop_oneof![0..9u32, any::<u32>()], 0..40)) {
            prop_assert_eq!(unpack_links(&pack_links(&ids), ids.len()), Ok(ids));
        }

        #[test]
        fn any_bytes_are_refused_or_give_as_many_ids(bytes in prop::collection::vec(any::<u8>(), 0..40), len in 0..50usize) {
            if let Ok(ids) = unpack_links(&bytes, len) {
                prop_assert_eq!(ids.len(), len);
            }
        }

        #[test]
        fn planes_come_back(values in prop::collection::vec(any::<[u8; 3]>(), 0..20)) {
            let mut written = Vec::new();
            write_planes(&mut written, values.as_flattened(), 3).expect("a vector");
            let mut back = vec![[0; 3]; values.len()];
            for at in 0..3 {
                put_plane(back.as_flattened_mut(), &written[at * values.len()..][..values.len()], at, 3);
            }
            prop_assert_eq!(back, values);
        }
    }

    #[test]
    fn small_differences_take_a_byte() {
        let next: Vec<u32> = (0..60).map(|h| if h % 3 == 2 { h - 2 } else { h + 1 }).collect();
        assert_eq!(pack_links(&next).len(), 61);
        assert_eq!(varint(300), [0xac, 2]);
    }

    #[test]
    fn varints_of_more_than_64_bits_are_refused() {
        for bytes in [[0xff; 11], [0x80; 11]] {
            let mut bytes = bytes.into_iter();
            assert!(read_varint(|| bytes.next().ok_or(BadBytes::new("end"))).is_err());
        }
        let mut most = varint(u64::MAX).into_iter();
        assert_eq!(read_varint(|| most.next().ok_or(BadBytes::new("end"))), Ok(u64::MAX));
    }
}
