//! Reading words and numbers of a text one after the other.

use crate::error::ReadError;
use crate::soup::origin::Origin;
use crate::text::number;
use glam::{DVec3, Vec3};
use halfedge::Progress;

/// Whether the start of a file has only bytes that text in UTF-8 or Latin-1 has.
pub(crate) fn is_text(bytes: &[u8]) -> bool {
    let head = bytes.get(..4096).unwrap_or(bytes);
    head.iter().all(|&b| b >= 0x20 || matches!(b, b'\t' | b'\n' | b'\r' | 0x0b | 0x0c | 0x1a))
}

/// A position in a text of words separated by blanks.
#[derive(Clone)]
pub(crate) struct Scan<'a> {
    bytes: &'a [u8],
    pub at: usize,
    /// The character that starts a comment, which ends with its line.
    comment: Option<u8>,
}

impl<'a> Scan<'a> {
    pub(crate) fn new(bytes: &'a [u8], comment: Option<u8>) -> Self {
        let mark = b"\xef\xbb\xbf";
        Self { bytes, at: if bytes.starts_with(mark) { mark.len() } else { 0 }, comment }
    }

    fn peek(&self) -> Option<u8> {
        self.bytes.get(self.at).copied()
    }

    fn is_blank(byte: u8) -> bool {
        byte.is_ascii_whitespace() || byte == 0x0b
    }

    /// Skips blanks, line ends and comments.
    pub(crate) fn skip_blanks(&mut self) {
        while let Some(byte) = self.peek() {
            if Some(byte) == self.comment {
                self.skip_line();
            } else if Self::is_blank(byte) {
                self.at += 1;
            } else {
                return;
            }
        }
    }

    /// Skips blanks on this line; returns whether anything else is left on it.
    pub(crate) fn more_on_line(&mut self) -> bool {
        while let Some(byte) = self.peek() {
            if byte == b'\n' || byte == b'\r' || Some(byte) == self.comment {
                return false;
            }
            if !Self::is_blank(byte) {
                return true;
            }
            self.at += 1;
        }
        false
    }

    /// Skips the rest of this line.
    pub(crate) fn skip_line(&mut self) {
        self.line();
    }

    /// Reads the rest of this line, without blanks around it.
    pub(crate) fn line(&mut self) -> &'a [u8] {
        let rest = self.bytes.get(self.at..).unwrap_or_default();
        let length = rest.iter().position(|&b| b == b'\n' || b == b'\r').unwrap_or(rest.len());
        self.at += length;
        rest.get(..length).unwrap_or_default().trim_ascii()
    }

    /// Reads the next word, if there is one.
    pub(crate) fn word(&mut self) -> Option<&'a [u8]> {
        self.skip_blanks();
        let rest = self.bytes.get(self.at..)?;
        let length =
            rest.iter().position(|&b| Self::is_blank(b) || Some(b) == self.comment).unwrap_or(rest.len());
        self.at += length;
        rest.get(..length).filter(|word| !word.is_empty())
    }

    /// Reads the next word as a number; a word that is none is skipped and gives `None`.
    pub(crate) fn float(&mut self) -> Option<f32> {
        self.number(number::float)
    }

    /// Reads the next three words as a position, in double precision if there is an origin. All three are skipped
    /// even if one is no number.
    pub(crate) fn position(&mut self, origin: &mut Option<Origin>) -> Option<Vec3> {
        match origin {
            None => {
                let (x, y, z) = (self.float(), self.float(), self.float());
                Some(Vec3::new(x?, y?, z?))
            }
            Some(origin) => {
                let (x, y, z) = (self.double(), self.double(), self.double());
                Some(origin.place(DVec3::new(x?, y?, z?)))
            }
        }
    }

    /// Reads the next word as a number in double precision.
    pub(crate) fn double(&mut self) -> Option<f64> {
        self.number(number::double)
    }

    /// Reads the next word as a whole number.
    pub(crate) fn integer(&mut self) -> Option<i64> {
        self.number(number::integer)
    }

    fn number<T>(&mut self, read: impl Fn(&[u8], usize) -> Option<(T, usize)>) -> Option<T> {
        self.skip_blanks();
        let start = self.at;
        let taken = read(self.bytes, start);
        let over = |end: usize| {
            self.bytes.get(end).is_none_or(|&byte| Self::is_blank(byte) || Some(byte) == self.comment)
        };
        match taken {
            Some((value, end)) if over(end) => {
                self.at = end;
                Some(value)
            }
            _ => {
                self.word();
                None
            }
        }
    }

    /// The bytes from `start` to here.
    pub(crate) fn taken_since(&self, start: usize) -> &'a [u8] {
        self.bytes.get(start..self.at).unwrap_or_default()
    }

    /// Whether there is a decimal point or an exponent between `start` and here.
    pub(crate) fn has_point_since(&self, start: usize) -> bool {
        self.taken_since(start).iter().any(|b| matches!(b, b'.' | b'e' | b'E'))
    }

    /// The line that a place is on, from 1.
    pub(crate) fn line_number(&self) -> usize {
        let before = self.bytes.get(..self.at).unwrap_or(self.bytes);
        1 + before.iter().filter(|&&b| b == b'\n').count()
    }

    /// Skips blanks, line ends and comments; returns whether the text ends there.
    pub(crate) fn at_end(&mut self) -> bool {
        self.skip_blanks();
        self.at >= self.bytes.len()
    }
}

/// Reports the progress of reading at intervals, as the first half of the work.
pub(crate) struct Ticker {
    size: usize,
    next: usize,
}

impl Ticker {
    const INTERVAL_BYTES: usize = 1 << 20;

    pub(crate) fn new(size: usize) -> Self {
        Self { size: size.max(1), next: Self::INTERVAL_BYTES }
    }

    /// Reports that `at` bytes have been read.
    ///
    /// # Errors
    /// [`ReadError::Cancelled`] if `progress` stops the work.
    pub(crate) fn tick(&mut self, at: usize, progress: &mut Progress) -> Result<(), ReadError> {
        if at < self.next {
            return Ok(());
        }
        self.next = at.saturating_add(Self::INTERVAL_BYTES);
        if progress(0.5 * (at as f32 / self.size as f32).min(1.0)).is_break() {
            return Err(ReadError::Cancelled);
        }
        Ok(())
    }
}
