//! Character encodings of text files.

use std::borrow::Cow;

/// The encoding that a file's text was read in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Encoding {
    Utf8,
    Utf16,
    /// Windows-1252, which extends Latin-1: for text that is neither of the others.
    Latin1,
}

/// The number of bytes whose pattern of zeros tells UTF-16 without a byte order mark.
const UTF16_SAMPLE_BYTES: usize = 64;

/// What Windows-1252 has in place of the control characters 0x80 to 0x9f of Latin-1.
const WINDOWS_1252: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}', '\u{90}',
    '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];

/// The text of a file in UTF-16, without a byte order mark, where a mark or the zeros between its first
/// characters say that it is that. Costs one pass over such a file.
pub(crate) fn decode_utf16(bytes: &[u8]) -> Option<String> {
    let decode = |bytes: &[u8], unit: fn([u8; 2]) -> u16| {
        let units = bytes.as_chunks::<2>().0.iter().map(|pair| unit(*pair));
        Some(char::decode_utf16(units).map(|c| c.unwrap_or(char::REPLACEMENT_CHARACTER)).collect())
    };
    match bytes {
        [0xff, 0xfe, rest @ ..] => return decode(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => return decode(rest, u16::from_be_bytes),
        _ => {}
    }
    // Most characters of a file's start have a zero for one of their two bytes; text has no other zeros.
    let sample = bytes.get(..UTF16_SAMPLE_BYTES).unwrap_or(bytes).as_chunks::<2>().0;
    let zeros = |place: usize| sample.iter().filter(|pair| pair.get(place) == Some(&0)).count();
    match (zeros(0), zeros(1)) {
        (0, count) if count > 0 && 2 * count >= sample.len() => decode(bytes, u16::from_le_bytes),
        (count, 0) if count > 0 && 2 * count >= sample.len() => decode(bytes, u16::from_be_bytes),
        _ => None,
    }
}

/// The text of a file, without a byte order mark: UTF-16 where it [is that](decode_utf16), else UTF-8 where
/// it is valid, else Windows-1252, which reads any bytes. Costs one pass; UTF-8 is borrowed.
pub(crate) fn decode(bytes: &[u8]) -> (Cow<'_, str>, Encoding) {
    if let Some(text) = decode_utf16(bytes) {
        return (Cow::Owned(text), Encoding::Utf16);
    }
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    match std::str::from_utf8(bytes) {
        Ok(text) => (Cow::Borrowed(text), Encoding::Utf8),
        Err(_) => {
            let character = |&b: &u8| match b {
                0x80..=0x9f => WINDOWS_1252.get(usize::from(b - 0x80)).copied().unwrap_or_default(),
                _ => char::from(b),
            };
            (Cow::Owned(bytes.iter().map(character).collect()), Encoding::Latin1)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_reads_the_same_in_every_encoding() {
        let text = "solid Körper\r\n1.5 2 α";
        let le: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
        let be: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
        for (bytes, encoding) in [
            (text.as_bytes().to_vec(), Encoding::Utf8),
            ([b"\xef\xbb\xbf", text.as_bytes()].concat(), Encoding::Utf8),
            (le.clone(), Encoding::Utf16),
            (be.clone(), Encoding::Utf16),
            ([b"\xff\xfe", le.as_slice()].concat(), Encoding::Utf16),
            ([b"\xfe\xff", be.as_slice()].concat(), Encoding::Utf16),
        ] {
            assert_eq!(decode(&bytes), (Cow::Borrowed(text), encoding));
        }
        assert_eq!(decode(b"K\xf6rper \x80"), (Cow::Borrowed("Körper €"), Encoding::Latin1));
        assert_eq!(decode(b""), (Cow::Borrowed(""), Encoding::Utf8));
        assert_eq!(decode(b"a"), (Cow::Borrowed("a"), Encoding::Utf8));
        // An odd byte at the end and half of a surrogate pair.
        assert_eq!(decode(b"\xff\xfea\0\0\xd8b").0, "a\u{fffd}");
    }
}
