//! A place in the text of an OBJ: blanks, numbers, names and line ends.

use crate::text::number;

/// A position in the bytes, with its line number.
pub(super) struct Cursor<'a> {
    bytes: &'a [u8],
    /// The index of the next byte.
    pub at: usize,
    /// The line, counted from 1; a continued line has the number of its last part.
    pub line: usize,
}

impl<'a> Cursor<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        let mark = b"\xef\xbb\xbf";
        Self { bytes, at: if bytes.starts_with(mark) { mark.len() } else { 0 }, line: 1 }
    }

    pub(super) fn at_end(&self) -> bool {
        self.at >= self.bytes.len()
    }

    /// The next byte; at the end of the file, a line end.
    #[inline(always)]
    pub(super) fn peek(&self) -> u8 {
        self.bytes.get(self.at).copied().unwrap_or(b'\n')
    }

    /// The byte after the next.
    #[inline(always)]
    pub(super) fn peek_second(&self) -> u8 {
        self.bytes.get(self.at + 1).copied().unwrap_or(b'\n')
    }

    /// Skips blanks, and line ends after a backslash.
    #[inline(always)]
    pub(super) fn skip_blanks(&mut self) {
        loop {
            match self.peek() {
                b' ' | b'\t' | 0x0b | 0x0c => self.at += 1,
                b'\\' if self.skip_continuation() => {}
                _ => return,
            }
        }
    }

    /// Skips a backslash and the line end after it, if they come next.
    #[cold]
    fn skip_continuation(&mut self) -> bool {
        let length = match self.bytes.get(self.at..) {
            Some([b'\\', b'\r', b'\n', ..]) => 3,
            Some([b'\\', b'\n' | b'\r', ..]) => 2,
            _ => return false,
        };
        self.at += length;
        self.line += 1;
        true
    }

    /// Whether nothing but a comment is left on the line. Blanks must have been skipped.
    #[inline(always)]
    pub(super) fn is_line_over(&self) -> bool {
        matches!(self.peek(), b'\n' | b'\r' | b'#')
    }

    /// Goes to the start of the next line.
    #[inline(always)]
    pub(super) fn next_line(&mut self) {
        match self.peek() {
            b'\n' => self.at += 1,
            b'\r' if self.peek_second() == b'\n' => self.at += 2,
            _ => return self.skip_line(),
        }
        self.line += 1;
    }

    /// Skips the rest of the line. A comment ends with its line, even after a backslash: some comments are
    /// drawings.
    fn skip_line(&mut self) {
        let mut is_comment = false;
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
                Some(b'\\') if !is_comment && self.skip_continuation() => {}
                Some(b) => {
                    is_comment |= *b == b'#';
                    self.at += 1;
                }
            }
        }
    }

    /// Reads a word of letters, digits and underscores.
    pub(super) fn word(&mut self) -> &'a [u8] {
        let rest = self.bytes.get(self.at..).unwrap_or_default();
        let length = rest.iter().take_while(|b| b.is_ascii_alphanumeric() || **b == b'_').count();
        self.at += length;
        rest.get(..length).unwrap_or_default()
    }

    /// Whether a word or number ends here: at a blank, a continuation or the end of the line.
    #[inline(always)]
    pub(super) fn is_token_over(&mut self) -> bool {
        matches!(self.peek(), b' ' | b'\n' | b'\r' | b'\t' | b'#' | 0x0b | 0x0c)
            || (self.peek() == b'\\' && matches!(self.peek_second(), b'\n' | b'\r'))
    }

    /// Reads a decimal number. Blanks must have been skipped.
    #[inline(always)]
    pub(super) fn float(&mut self) -> Option<f32> {
        let (value, end) = number::float(self.bytes, self.at)?;
        self.at = end;
        self.is_token_over().then_some(value)
    }

    /// Reads a decimal number in double precision. Blanks must have been skipped.
    pub(super) fn double(&mut self) -> Option<f64> {
        let (value, end) = number::double(self.bytes, self.at)?;
        self.at = end;
        self.is_token_over().then_some(value)
    }

    /// Reads a whole number.
    #[inline(always)]
    pub(super) fn integer(&mut self) -> Option<i64> {
        let (value, end) = number::integer(self.bytes, self.at)?;
        self.at = end;
        Some(value)
    }

    /// Reads text up to the end of the line or a comment. In a name, a `#` starts a comment only between
    /// blanks: names like `Material #25` are common.
    pub(super) fn text(&mut self) -> String {
        self.skip_blanks();
        let mut text = Vec::new();
        loop {
            match self.peek() {
                b'\n' | b'\r' => break,
                b'#' if text.last().is_none_or(u8::is_ascii_whitespace)
                    && self.peek_second().is_ascii_whitespace() =>
                {
                    break;
                }
                b'\\' if self.skip_continuation() => text.push(b' '),
                byte => {
                    text.push(byte);
                    self.at += 1;
                }
            }
        }
        String::from_utf8_lossy(&text).trim().to_owned()
    }
}
