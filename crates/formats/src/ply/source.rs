//! The numbers of a PLY, in text or binary.

use super::header::{Encoding, Scalar};
use crate::text::number;
use crate::text::scan::Scan;

/// Reads numbers one after the other.
pub(super) enum Source<'a> {
    /// Text, and whether to read numbers in double precision rather than rounded to `f32` once.
    Text(Scan<'a>, bool),
    Binary {
        bytes: &'a [u8],
        at: usize,
        big: bool,
    },
}

impl<'a> Source<'a> {
    /// Numbers from `at` on.
    pub(super) fn new(bytes: &'a [u8], at: usize, encoding: Encoding, precise: bool) -> Self {
        match encoding {
            Encoding::Text => {
                let mut scan = Scan::new(bytes, None);
                scan.at = at;
                Self::Text(scan, precise)
            }
            Encoding::LittleEndian => Self::Binary { bytes, at, big: false },
            Encoding::BigEndian => Self::Binary { bytes, at, big: true },
        }
    }

    /// The number of bytes read so far.
    pub(super) fn at(&self) -> usize {
        match self {
            Self::Text(scan, _) => scan.at,
            Self::Binary { at, .. } => *at,
        }
    }

    /// The next number; `None` at the end of the file. In text, a word that is no number gives NaN.
    pub(super) fn next(&mut self, scalar: Scalar) -> Option<f64> {
        match self {
            Self::Text(scan, precise) => {
                let word = scan.word()?;
                let whole = |word| number::integer(word, 0).filter(|&(_, end)| end == word.len());
                if !scalar.is_float()
                    && let Some((value, _)) = whole(word)
                {
                    return Some(value as f64);
                }
                let value = if *precise {
                    number::double(word, 0)
                } else {
                    number::float(word, 0).map(|(value, end)| (f64::from(value), end))
                };
                Some(value.filter(|&(_, end)| end == word.len()).map_or(f64::NAN, |(value, _)| value))
            }
            Self::Binary { bytes, at, big } => {
                fn take<const N: usize>(bytes: &[u8], at: &mut usize, big: bool) -> Option<[u8; N]> {
                    let mut value = *bytes.get(*at..)?.first_chunk::<N>()?;
                    *at += N;
                    if big {
                        value.reverse();
                    }
                    Some(value)
                }
                Some(match scalar {
                    Scalar::I8 => f64::from(i8::from_le_bytes(take(bytes, at, *big)?)),
                    Scalar::U8 => f64::from(u8::from_le_bytes(take(bytes, at, *big)?)),
                    Scalar::I16 => f64::from(i16::from_le_bytes(take(bytes, at, *big)?)),
                    Scalar::U16 => f64::from(u16::from_le_bytes(take(bytes, at, *big)?)),
                    Scalar::I32 => f64::from(i32::from_le_bytes(take(bytes, at, *big)?)),
                    Scalar::U32 => f64::from(u32::from_le_bytes(take(bytes, at, *big)?)),
                    Scalar::I64 => i64::from_le_bytes(take(bytes, at, *big)?) as f64,
                    Scalar::U64 => u64::from_le_bytes(take(bytes, at, *big)?) as f64,
                    Scalar::F32 => f64::from(f32::from_le_bytes(take(bytes, at, *big)?)),
                    Scalar::F64 => f64::from_le_bytes(take(bytes, at, *big)?),
                })
            }
        }
    }
}
