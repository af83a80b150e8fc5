//! The first word of an OFF, which says what comes with each vertex.

use crate::text::scan::Scan;

/// How much of a file's start its first word is looked for in, in bytes.
const HEAD_BYTES: usize = 4096;

/// What the first word says: `[ST][C][N][4][n]OFF` in the Geomview manual, in any order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Keyword {
    pub texture: bool,
    pub color: bool,
    pub normal: bool,
    /// Whether colours come before normals: Geomview writes `CN` and normals first, MeshLab `NC` and colours
    /// first.
    pub color_first: bool,
    /// Whether each position has one coordinate more, by which the others are divided.
    pub homogeneous: bool,
    /// Whether the number of dimensions comes before the counts.
    pub any_dimension: bool,
    /// The number of letters; some files have the counts right behind them.
    pub length: usize,
}

impl Keyword {
    /// Reads a word, if it is one.
    pub(super) fn parse(word: &[u8]) -> Option<Self> {
        let at = word.windows(3).position(|part| part == b"OFF")?;
        let mut keyword = Self { length: at + 3, ..Self::default() };
        let mut prefix = word.get(..at)?;
        while !prefix.is_empty() {
            let parts: [(&[u8], &mut bool); 5] = [
                (b"ST", &mut keyword.texture),
                (b"C", &mut keyword.color),
                (b"N", &mut keyword.normal),
                (b"4", &mut keyword.homogeneous),
                (b"n", &mut keyword.any_dimension),
            ];
            let (part, flag) = parts.into_iter().find(|(part, _)| prefix.starts_with(part))?;
            if std::mem::replace(flag, true) {
                return None;
            }
            keyword.color_first |= part == b"C" && keyword.normal;
            prefix = prefix.get(part.len()..)?;
        }
        let rest = word.get(keyword.length..)?;
        rest.iter().all(u8::is_ascii_digit).then_some(keyword)
    }
}

/// Whether the first word is that of an OFF.
pub(super) fn is_off(bytes: &[u8]) -> bool {
    let head = bytes.get(..HEAD_BYTES).unwrap_or(bytes);
    Scan::new(head, Some(b'#')).word().and_then(Keyword::parse).is_some()
}

/// Whether a file is a binary OFF: its first line is the keyword and "BINARY".
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    let head = bytes.get(..HEAD_BYTES).unwrap_or(bytes);
    let mut scan = Scan::new(head, Some(b'#'));
    let is_keyword = scan.word().and_then(Keyword::parse).is_some();
    is_keyword && scan.more_on_line() && scan.word() == Some(b"BINARY")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keywords_are_read_in_any_order() {
        let plain = Keyword { length: 3, ..Keyword::default() };
        assert_eq!(Keyword::parse(b"OFF"), Some(plain));
        assert_eq!(Keyword::parse(b"OFF4"), Some(plain));
        let all = Keyword { texture: true, color: true, normal: true, length: 7, ..plain };
        assert_eq!(Keyword::parse(b"STCNOFF"), Some(all));
        assert_eq!(Keyword::parse(b"CNSTOFF"), Some(all));
        assert_eq!(Keyword::parse(b"NCSTOFF"), Some(Keyword { color_first: true, ..all }));
        let dimensions = Keyword { homogeneous: true, any_dimension: true, length: 5, ..plain };
        assert_eq!(Keyword::parse(b"4nOFF"), Some(dimensions));
        for word in ["", "OF", "off", "XOFF", "CCOFF", "SOFF", "OFFICE", "OFF4x"] {
            assert_eq!(Keyword::parse(word.as_bytes()), None, "{word}");
        }
    }
}
