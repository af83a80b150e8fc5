//! A place in the text of an OBJ file: blanks, numbers, names and the ends of lines.

use crate::text::number;

/// A position in the bytes, and the number of the line it is on.
pub(crate) struct Cursor<'a> {
    bytes: &'a [u8],
    /// The next byte.
    pub at: usize,
    /// The line, counted from 1; a continued line has the number of its last part.
    pub line: usize,
}

impl<'a> Cursor<'a> {
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        let mark = b"\xef\xbb\xbf";
        Self { bytes, at: if bytes.starts_with(mark) { mark.len() } else { 0 }, line: 1 }
    }

    pub(crate) fn at_end(&self) -> bool {
        self.at >= self.bytes.len()
    }

    /// The next byte; the end of the file reads as the end of a line.
    #[inline(always)]
    pub(crate) fn peek(&self) -> u8 {
        self.bytes.get(self.at).copied().unwrap_or(b'\n')
    }

    /// The byte after the next.
    #[inline(always)]
    pub(crate) fn peek_second(&self) -> u8 {
        self.bytes.get(self.at + 1).copied().unwrap_or(b'\n')
    }

    /// Passes over blanks, and over line ends that a backslash stands before.
    #[inline(always)]
    pub(crate) fn blanks(&mut self) {
        loop {
            match self.peek() {
                b' ' | b'\t' | 0x0b | 0x0c => self.at += 1,
                b'\\' if self.continues() => {}
                _ => return,
            }
        }
    }

    /// Passes over a backslash with a line end behind it, if that is what is next.
    #[cold]
    fn continues(&mut self) -> bool {
        let length = match self.bytes.get(self.at..) {
            Some([b'\\', b'\r', b'\n', ..]) => 3,
            Some([b'\\', b'\n' | b'\r', ..]) => 2,
            _ => return false,
        };
        self.at += length;
        self.line += 1;
        true
    }

    /// Whether nothing but a comment is left on this line. Blanks must have been passed.
    #[inline(always)]
    pub(crate) fn line_is_over(&self) -> bool {
        matches!(self.peek(), b'\n' | b'\r' | b'#')
    }

    /// Goes to the start of the next line.
    #[inline(always)]
    pub(crate) fn next_line(&mut self) {
        match self.peek() {
            b'\n' => self.at += 1,
            b'\r' if self.peek_second() == b'\n' => self.at += 2,
            _ => return self.skip_line(),
        }
        self.line += 1;
    }

    /// Goes to the start of the next line over whatever is left of this one. A comment ends with
    /// its line, backslash or not: some are drawings.
    fn skip_line(&mut self) {
        let mut comment = false;
        loop {
            match self.bytes.get(self.at) {
                None => {
                    self.line += 1;
                    return;
                }
                Some(b'\n') => {
                    self.at += 1;
                    self.line += 1;
                    return;
                }
                Some(b'\r') => {
                    self.at += if self.peek_second() == b'\n' { 2 } else { 1 };
                    self.line += 1;
                    return;
                }
                Some(b'\\') if !comment && self.continues() => {}
                Some(b) => {
                    comment |= *b == b'#';
                    self.at += 1;
                }
            }
        }
    }

    /// Takes the word of letters, digits and underscores here.
    pub(crate) fn word(&mut self) -> &'a [u8] {
        let rest = self.bytes.get(self.at..).unwrap_or_default();
        let length = rest.iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
        self.at += length;
        rest.get(..length).unwrap_or_default()
    }

    /// Whether a blank, a continuation or the end of the line is next: a word or number ends here.
    #[inline(always)]
    pub(crate) fn token_is_over(&mut self) -> bool {
        matches!(self.peek(), b' ' | b'\n' | b'\r' | b'\t' | b'#' | 0x0b | 0x0c)
            || (self.peek() == b'\\' && matches!(self.peek_second(), b'\n' | b'\r'))
    }

    /// Takes the decimal number here. Blanks must have been passed.
    #[inline(always)]
    pub(crate) fn float(&mut self) -> Option<f32> {
        let (value, end) = number::float(self.bytes, self.at)?;
        self.at = end;
        self.token_is_over().then_some(value)
    }

    /// Takes the decimal number here in double precision. Blanks must have been passed.
    pub(crate) fn double(&mut self) -> Option<f64> {
        let (value, end) = number::double(self.bytes, self.at)?;
        self.at = end;
        self.token_is_over().then_some(value)
    }

    /// Takes the whole number here.
    #[inline(always)]
    pub(crate) fn integer(&mut self) -> Option<i64> {
        let (value, end) = number::integer(self.bytes, self.at)?;
        self.at = end;
        Some(value)
    }

    /// Takes the text up to the end of the line or to a comment, which in a name needs blanks on
    /// both sides of its `#`: names like `Material #25` are common.
    pub(crate) fn text(&mut self) -> String {
        self.blanks();
        let mut taken = Vec::new();
        loop {
            match self.peek() {
                b'\n' | b'\r' => break,
                b'#' if taken.last().is_none_or(u8::is_ascii_whitespace)
                    && self.peek_second().is_ascii_whitespace() =>
                {
                    break;
                }
                b'\\' if self.continues() => taken.push(b' '),
                byte => {
                    taken.push(byte);
                    self.at += 1;
                }
            }
        }
        String::from_utf8_lossy(&taken).trim().to_owned()
    }
}
