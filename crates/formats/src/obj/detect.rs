//! Recognising an OBJ by its content.

use crate::text::scan::is_text;

/// The number of bytes that are examined.
const HEAD_BYTES: usize = 64 * 1024;

/// The number of lines that are examined.
const HEAD_LINES: usize = 100;

/// Whether one of the first lines that are neither empty nor comments is a vertex, a texture coordinate, a
/// normal or a face of an OBJ.
pub(crate) fn is_obj(bytes: &[u8]) -> bool {
    let head = bytes.get(..HEAD_BYTES).unwrap_or(bytes);
    let head = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head);
    is_text(head)
        && head
            .split(|&b| b == b'\n' || b == b'\r')
            .map(<[u8]>::trim_ascii)
            .filter(|line| !line.is_empty() && !line.starts_with(b"#"))
            .take(HEAD_LINES)
            .any(is_obj_statement)
}

fn is_obj_statement(line: &[u8]) -> bool {
    let mut words = line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    let (least, signs): (usize, &[u8]) = match words.next() {
        Some(b"v" | b"vn") => (3, b"+-.eE"),
        Some(b"vt") => (2, b"+-.eE"),
        Some(b"f") => (3, b"-/"),
        _ => return false,
    };
    let is_number = |word: &[u8]| word.iter().all(|b| b.is_ascii_digit() || signs.contains(b));
    words.take_while(|word| is_number(word)).take(least).count() == least
}
