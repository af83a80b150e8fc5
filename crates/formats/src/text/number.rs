//! Reading numbers from bytes, fast and correctly rounded.
//!
//! Runs of digits are read eight at a time: the bytes are one word, whose leading digits are counted with bit
//! operations and combined into a number with three multiplications
//! (D. Lemire, "Quickly parsing eight digits", 2018). A decimal number whose digits fit in 53 bits
//! and whose power of ten is at most 22 is exact in `f64` after one division or multiplication
//! (W. Clinger, "How to read floating point numbers accurately", 1990). Rounding that to `f32` is right, too,
//! unless the `f64` lies exactly between two `f32`. The standard library reads all other numbers.

use std::str::FromStr;

/// The number of digits that are read at a time.
const WORD_DIGITS: usize = 8;

/// The powers of ten that are exact in `f64`.
const POWERS_OF_TEN: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// Up to this number, all whole numbers are exact in `f64`.
const MAX_EXACT_INTEGER: u64 = 1 << 53;

/// The value and number of the digits at the start of `bytes`, at most eight.
#[inline(always)]
fn leading_digits(bytes: &[u8]) -> (u64, usize) {
    let Some(word) = bytes.first_chunk::<WORD_DIGITS>() else { return leading_digits_at_end(bytes) };
    // Digits become 0 to 9. A carry out of a byte reaches only bytes after the first that is no digit.
    let word = u64::from_le_bytes(*word) ^ 0x3030_3030_3030_3030;
    let others = (word.wrapping_add(0x7676_7676_7676_7676) | word) & 0x8080_8080_8080_8080;
    let count = others.trailing_zeros() as usize / 8;
    if count == 0 {
        return (0, 0);
    }
    // Move the digits to the end of the word, with zeros in front.
    let word = word << (8 * (WORD_DIGITS - count));
    let word = (word & 0x0f0f_0f0f_0f0f_0f0f).wrapping_mul(2561) >> 8;
    let word = (word & 0x00ff_00ff_00ff_00ff).wrapping_mul(6_553_601) >> 16;
    let word = (word & 0x0000_ffff_0000_ffff).wrapping_mul(42_949_672_960_001) >> 32;
    (word, count)
}

#[cold]
fn leading_digits_at_end(bytes: &[u8]) -> (u64, usize) {
    let mut value = 0;
    let mut count = 0;
    for &byte in bytes.iter().take_while(|byte| byte.is_ascii_digit()) {
        value = value * 10 + u64::from(byte - b'0');
        count += 1;
    }
    (value, count)
}

/// Ten to the power of `count`, for a run of digits.
#[inline(always)]
fn power_of_ten(count: usize) -> u64 {
    const POWERS: [u64; WORD_DIGITS + 1] =
        [1, 10, 100, 1000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000];
    POWERS.get(count).copied().unwrap_or(0)
}

#[inline(always)]
fn byte(bytes: &[u8], at: usize) -> u8 {
    bytes.get(at).copied().unwrap_or(b'\n')
}

#[inline(always)]
fn tail(bytes: &[u8], at: usize) -> &[u8] {
    bytes.get(at..).unwrap_or_default()
}

/// Appends a run of any number of digits to `value`; returns the result and the number of digits. More than 19
/// digits overflow.
#[inline(always)]
fn digit_run(bytes: &[u8], mut value: u64) -> (u64, usize) {
    let mut total = 0;
    loop {
        let (part, count) = leading_digits(tail(bytes, total));
        value = value.wrapping_mul(power_of_ten(count)).wrapping_add(part);
        total += count;
        if count < WORD_DIGITS {
            return (value, total);
        }
    }
}

/// The 64-bit number with the same shortest text as a 32-bit one: 0.1, not 0.10000000149011612.
pub fn shortest(value: f32) -> f64 {
    value.to_string().parse().unwrap_or_else(|_| f64::from(value))
}

/// Reads the whole number at `at`, a sign and digits; returns it and its end. `None` if there is none or it has
/// more than 18 digits.
#[inline(always)]
pub(crate) fn integer(bytes: &[u8], at: usize) -> Option<(i64, usize)> {
    let negative = byte(bytes, at) == b'-';
    let start = at + usize::from(negative || byte(bytes, at) == b'+');
    let (value, count) = digit_run(tail(bytes, start), 0);
    if count == 0 || count > 18 {
        return None;
    }
    let value = value as i64;
    Some((if negative { -value } else { value }, start + count))
}

/// Reads the decimal number at `at`, rounded to the nearest `f32` like [`str::parse`]; returns it and its end.
/// `None` if there is none.
#[inline(always)]
pub(crate) fn float(bytes: &[u8], at: usize) -> Option<(f32, usize)> {
    let Some((exact, end)) = decimal(bytes, at) else { return parse_with_std(bytes, at) };
    let value = exact as f32;
    // The middle between two f32 may be the result of rounding: only all digits can decide. Below the smallest
    // normal number, f32 has fewer bits, so that the middle lies elsewhere.
    let between = exact.to_bits() & 0x1fff_ffff == 0x1000_0000;
    let tiny = exact != 0.0 && exact.abs() < f64::from(f32::MIN_POSITIVE);
    if between || tiny { parse_with_std(bytes, at) } else { Some((value, end)) }
}

/// Reads the decimal number at `at`, rounded to the nearest `f64`; returns it and its end. `None` if there is
/// none.
pub(crate) fn double(bytes: &[u8], at: usize) -> Option<(f64, usize)> {
    decimal(bytes, at).or_else(|| parse_with_std(bytes, at))
}

/// Reads a decimal number if one multiplication or division gives the nearest `f64`.
#[inline(always)]
fn decimal(bytes: &[u8], at: usize) -> Option<(f64, usize)> {
    let negative = byte(bytes, at) == b'-';
    let start = at + usize::from(negative || byte(bytes, at) == b'+');
    let (mut mantissa, mut count) = digit_run(tail(bytes, start), 0);
    let mut end = start + count;
    let mut exponent = 0;
    if byte(bytes, end) == b'.' {
        let (longer, fraction) = digit_run(tail(bytes, end + 1), mantissa);
        mantissa = longer;
        count += fraction;
        exponent = -(fraction as i64);
        end += 1 + fraction;
    }
    if count == 0 || count > 19 || mantissa > MAX_EXACT_INTEGER {
        return None;
    }
    if byte(bytes, end) | 0x20 == b'e' {
        let (power, after) = integer(bytes, end + 1)?;
        exponent = exponent.saturating_add(power);
        end = after;
    }
    let power = POWERS_OF_TEN.get(usize::try_from(exponent.unsigned_abs()).ok()?)?;
    let magnitude = mantissa as f64;
    let magnitude = if exponent < 0 { magnitude / power } else { magnitude * power };
    Some((if negative { -magnitude } else { magnitude }, end))
}

/// Reads the number up to the next blank with the standard library.
#[cold]
#[inline(never)]
fn parse_with_std<T: FromStr>(bytes: &[u8], at: usize) -> Option<(T, usize)> {
    let text = tail(bytes, at);
    // Bounds the cost on hostile input: no useful number is longer.
    let text = text.get(..4096).unwrap_or(text);
    let len =
        text.iter().take_while(|&&b| b.is_ascii_alphanumeric() || matches!(b, b'.' | b'+' | b'-')).count();
    let token = std::str::from_utf8(text.get(..len)?).ok()?;
    Some((token.parse().ok()?, at + len))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn same(text: &str) {
        let expected = text.parse::<f32>().ok().map(f32::to_bits);
        for tail in ["", " 1 2 3 4 5", "\n", "\r\nv 1 2 3"] {
            let bytes = format!("{text}{tail}");
            let got = float(bytes.as_bytes(), 0);
            assert_eq!(got.map(|(value, _)| value.to_bits()), expected, "{text:?} {tail:?}");
            let double = super::double(bytes.as_bytes(), 0).map(|(value, end)| (value.to_bits(), end));
            assert_eq!(
                double,
                text.parse::<f64>().ok().map(|value| (value.to_bits(), text.len())),
                "{text:?}"
            );
            if let Some((_, end)) = got {
                assert_eq!(end, text.len(), "{text:?}");
            }
        }
    }

    #[test]
    fn hard_floats_are_correctly_rounded() {
        for text in [
            "0",
            "-0",
            "0.0",
            "-0.0",
            "1",
            "+1",
            "-1.5",
            ".5",
            "-.5",
            "5.",
            "1e5",
            "1E5",
            "1e+5",
            "1e-5",
            "1.e2",
            // Halfway between two f32, and next to it.
            "16777217",
            "16777217.000000001",
            "16777216.999999999",
            "16777219",
            "33554434.0000000000001",
            "1.00000005960464477539062",
            "1.000000059604644775390625",
            "1.000000059604644775390626",
            "8388608.5",
            "8388609.5",
            "8388609.50000000001",
            // 1 + 2^-24 + a little: rounds to the middle as f64.
            "1.00000005960464477540",
            "1.000000178813934326171875",
            "1.00000017881393432617187499",
            // At the ends of the range.
            "3.4028234e38",
            "3.4028235e38",
            "3.4028236e38",
            "340282346638528859811704183484516925440",
            "340282356779733661637539395458142568447",
            "340282356779733661637539395458142568448",
            "1e39",
            "1e400",
            "1.17549435e-38",
            "1.1754943e-38",
            "1e-40",
            "1.401298464e-45",
            "7.00649232e-46",
            "7.006492322e-46",
            "1e-46",
            "1e-400",
            "2.2250738585072011e-308",
            "4.9e-324",
            // Many digits.
            "0.000000000000000000000000000001",
            "123456789012345678901234567890",
            "0.1234567890123456789012345678901234567890",
            "9007199254740993",
            "9007199254740992",
            "18446744073709551616",
            "99999999999999999999",
            "9999999999999999999",
            "1e22",
            "1e23",
            "8.5e-23",
            "12345678",
            "123456789",
            "1234567812345678",
            "0.00000001",
            "1e00000000000000000005",
            // Not numbers, and names of numbers.
            "",
            ".",
            "-",
            "+",
            "e5",
            "1e",
            "1e+",
            "--1",
            "1..2",
            "nan",
            "NaN",
            "inf",
            "-inf",
            "infinity",
        ] {
            if text.parse::<f32>().is_ok_and(f32::is_nan) {
                assert!(float(text.as_bytes(), 0).is_some_and(|(value, _)| value.is_nan()));
                continue;
            }
            // Callers check what follows a number: this one ends early.
            if matches!(text, "1..2") {
                continue;
            }
            same(text);
        }
    }

    #[test]
    fn integers() {
        for (text, expected) in [
            ("1", Some((1, 1))),
            ("-12/3", Some((-12, 3))),
            ("+7 ", Some((7, 2))),
            ("123456789 ", Some((123_456_789, 9))),
            ("00000000000012", Some((12, 14))),
            ("9999999999999999999999", None),
            ("-", None),
            ("x", None),
            ("", None),
        ] {
            assert_eq!(integer(text.as_bytes(), 0), expected, "{text}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(2000))]
        #[test]
        fn shortest_text_reads_back(bits in any::<u32>()) {
            let value = f32::from_bits(bits);
            prop_assume!(value.is_finite());
            same(&value.to_string());
            same(&format!("{value:e}"));
            same(&format!("{value:.6}"));
            same(&f64::from(value).to_string());
        }

        #[test]
        fn decimals_match_the_standard_library(text in "[+-]?[0-9]{0,24}(\\.[0-9]{0,24})?([eE][+-]?[0-9]{1,3})?") {
            same(&text);
        }

        #[test]
        fn middles_and_their_neighbours(bits in 0x0000_0000u32..0x7f7f_ffff, up in -2i64..3) {
            // The middle between two neighbouring f32 is exact in f64; print it and its f64 neighbours.
            let low = f64::from(f32::from_bits(bits));
            let high = f64::from(f32::from_bits(bits + 1));
            let middle = f64::from_bits(((low + high) / 2.0).to_bits().saturating_add_signed(up));
            same(&format!("{middle:e}"));
            same(&format!("{middle:.17e}"));
        }

        #[test]
        fn any_bytes_are_taken(bytes in prop::collection::vec(any::<u8>(), 0..24)) {
            if let Some((_, end)) = float(&bytes, 0) {
                prop_assert!(end <= bytes.len() && end > 0);
            }
            if let Some((_, end)) = integer(&bytes, 0) {
                prop_assert!(end <= bytes.len() && end > 0);
            }
        }
    }
}
