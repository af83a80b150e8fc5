//! Commas in the numbers of a text.
//!
//! Programs in some languages write decimal commas, and some programs write commas between numbers. Both are
//! read where there is no other reading: not where commas could stand between thousands.

use std::ops::Range;

/// How the commas in a text's numbers are read.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Commas {
    /// There are none.
    None,
    /// The text without them, and the note for the import report.
    Readable(Vec<u8>, &'static str),
    /// There are several readings, or none.
    Ambiguous,
}

/// The cause of an error where no number could be read because of [`Commas::Ambiguous`].
pub(crate) const AMBIGUOUS: &str = "its numbers have commas that may be decimal commas or separators: write them with \
                                    decimal points and export the model again";

/// The readings that the commas on lines seen so far have.
struct Readings {
    decimals: bool,
    separators: bool,
    thousands: bool,
}

/// Reads the commas in the numbers of a text. `numbers` says where in a line there are nothing but numbers.
/// Costs O(text).
pub(crate) fn read_commas(text: &[u8], numbers: impl Fn(&[u8]) -> Range<usize>) -> Commas {
    if !text.contains(&b',') {
        return Commas::None;
    }
    let mut readings = Readings { decimals: true, separators: true, thousands: true };
    let mut has_commas = false;
    for line in lines(text) {
        let line = line.get(numbers(line)).unwrap_or_default();
        has_commas |= line.contains(&b',');
        readings.narrow(line);
    }
    let (replacement, note) = match readings {
        _ if !has_commas => return Commas::None,
        Readings { decimals: true, separators: false, thousands: false } => {
            (b'.', "Commas in its numbers were read as decimal commas")
        }
        Readings { decimals: false, separators: true, thousands: false } => {
            (b' ', "Commas between its numbers were read as blanks")
        }
        _ => return Commas::Ambiguous,
    };
    let mut out = Vec::with_capacity(text.len());
    for line in lines(text) {
        let start = out.len();
        out.extend_from_slice(line);
        for byte in out.get_mut(start..).and_then(|line| line.get_mut(numbers(line))).into_iter().flatten() {
            *byte = if *byte == b',' { replacement } else { *byte };
        }
    }
    Commas::Readable(out, note)
}

/// The lines of a text, with what ends them.
fn lines(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    text.split_inclusive(|&byte| byte == b'\n' || byte == b'\r')
}

impl Readings {
    /// Rules out those that a line of numbers doesn't have.
    fn narrow(&mut self, line: &[u8]) {
        let words = || line.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
        let commas = line.iter().filter(|&&byte| byte == b',').count();
        if commas == 0 {
            self.decimals &= !words().any(|word| word.contains(&b'.'));
            return;
        }
        self.decimals &= words().all(is_decimal);
        self.thousands &= words().filter(|word| word.contains(&b',')).all(is_thousands);
        // Separators lie between all numbers of a line, and maybe behind the last.
        let parts =
            || line.split(|byte| byte.is_ascii_whitespace() || *byte == b',').filter(|part| !part.is_empty());
        let count = parts().count();
        self.separators &= parts().all(is_number) && (commas == count || commas + 1 == count);
    }
}

/// Whether a word is a number with at most one comma and no point.
fn is_decimal(word: &[u8]) -> bool {
    let point: Vec<u8> = word.iter().map(|&byte| if byte == b',' { b'.' } else { byte }).collect();
    !word.contains(&b'.') && !word.ends_with(b",") && is_number(&point)
}

/// Whether a word is a number with commas before groups of three digits.
fn is_thousands(word: &[u8]) -> bool {
    let unsigned = word.strip_prefix(b"-").or_else(|| word.strip_prefix(b"+")).unwrap_or(word);
    let whole = unsigned.split(|&byte| byte == b'.').next().unwrap_or_default();
    let mut groups = whole.split(|&byte| byte == b',');
    let is_first = |first: &[u8]| (1..=3).contains(&first.len()) && !first.starts_with(b"0");
    let digits = |group: &[u8]| group.iter().all(u8::is_ascii_digit);
    groups.next().is_some_and(|first| is_first(first) && digits(first))
        && groups.all(|group| group.len() == 3 && digits(group))
}

fn is_number(word: &[u8]) -> bool {
    std::str::from_utf8(word).is_ok_and(|word| word.parse::<f64>().is_ok())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Option<String> {
        match read_commas(text.as_bytes(), |line| if line.starts_with(b"v") { 1..line.len() } else { 0..0 }) {
            Commas::None => Some(text.to_owned()),
            Commas::Readable(text, _) => Some(String::from_utf8(text).expect("text")),
            Commas::Ambiguous => None,
        }
    }

    #[test]
    fn commas_are_read_where_there_is_one_reading() {
        for (text, expected) in [
            ("v 1 2.5 3\ng a, b\n", Some("v 1 2.5 3\ng a, b\n")),
            (
                "v 0,5 1,25 -3,0\r\ng a, b\r\nv 1 ,5 2,5e-3",
                Some("v 0.5 1.25 -3.0\r\ng a, b\r\nv 1 .5 2.5e-3"),
            ),
            ("v 1,000 0,250 3,000\n", Some("v 1.000 0.250 3.000\n")),
            ("v 1, 2, 3\nv 0.5,1,2,\n", Some("v 1  2  3\nv 0.5 1 2 \n")),
            ("v 1,2 3,4 5,6", Some("v 1.2 3.4 5.6")),
            // All of them could be thousands, or decimals and thousands.
            ("v 1,000 2,500 3,000\n", None),
            ("v 1.5 2.5 3.5\nv 1,5 2,5 3,5\n", None),
            ("v 1,234.5 2 3\n", None),
            ("v 1,5\nv 2,5\n", None),
            ("v 1,x 2 3\n", None),
        ] {
            assert_eq!(read(text).as_deref(), expected, "{text}");
        }
    }
}
