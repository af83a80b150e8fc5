//! Writing numbers as text, and paths as addresses.

use glam::{DVec3, Vec3};

/// Appends the shortest text that reads back as the same number to the bit; `-0` stays `-0`.
pub(crate) fn push_float<F: zmij::Float>(out: &mut Vec<u8>, value: F) {
    let mut buffer = zmij::Buffer::new();
    let text = buffer.format(value);
    out.extend_from_slice(text.strip_suffix(".0").unwrap_or(text).as_bytes());
}

/// Appends numbers, each after a blank.
pub(crate) fn push_floats(out: &mut Vec<u8>, values: &[f32]) {
    for &value in values {
        out.push(b' ');
        push_float(out, value);
    }
}

/// Appends the coordinates of a position plus an offset, each after a blank: in double precision if the offset
/// is not zero.
pub(crate) fn push_position(out: &mut Vec<u8>, position: Vec3, offset: DVec3) {
    if offset == DVec3::ZERO {
        return push_floats(out, &position.to_array());
    }
    for value in (position.as_dvec3() + offset).to_array() {
        out.push(b' ');
        push_float(out, value);
    }
}

/// Appends a whole number.
pub(crate) fn push_integer(out: &mut Vec<u8>, value: u64) {
    out.extend_from_slice(itoa::Buffer::new().format(value).as_bytes());
}

/// Decodes an address, in which `%20` stands for a blank (RFC 3986, 2.1).
pub(crate) fn percent_decoded(uri: &str) -> String {
    let mut out = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let Some((&byte, after)) = rest.split_first() {
        let digit = |at: usize| char::from(*after.get(at)?).to_digit(16);
        match (byte, digit(0), digit(1)) {
            (b'%', Some(high), Some(low)) => {
                out.push((high * 16 + low) as u8);
                rest = after.get(2..).unwrap_or_default();
            }
            _ => {
                out.push(byte);
                rest = after;
            }
        }
    }
    String::from_utf8_lossy(&out).into_owned()
}

/// Encodes a path as an address, with all but plain characters and slashes as `%20` (RFC 3986, 2.1).
pub(crate) fn percent_encoded(path: &str) -> String {
    let plain = |b: u8| b.is_ascii_alphanumeric() || b"-._~/".contains(&b);
    path.bytes().map(|b| if plain(b) { char::from(b).to_string() } else { format!("%{b:02X}") }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn whole_numbers_are_short() {
        let mut out = Vec::new();
        push_floats(&mut out, &[1.0, -0.0, 0.1, 1e-30, -2.5e20, 100_000.0]);
        push_integer(&mut out, 4_294_967_296);
        assert_eq!(
            String::from_utf8_lossy(&out),
            " 1 -0 0.1 1e-30 -2.5e+20 100000 4294967296".replace(" 4294967296", "4294967296")
        );
    }

    proptest! {
        #[test]
        fn every_float_reads_back(bits in any::<u32>()) {
            let value = f32::from_bits(bits);
            prop_assume!(!value.is_nan());
            let mut out = Vec::new();
            push_float(&mut out, value);
            let back: f32 = std::str::from_utf8(&out).expect("ASCII").parse().expect("a number");
            prop_assert_eq!(back.to_bits(), bits);
            prop_assert_eq!(crate::text::number::float(&out, 0).map(|(v, end)| (v.to_bits(), end)), Some((bits, out.len())));
        }
    }
}
