//! Reading an STL in text.

use super::triangles::Triangles;
use crate::error::ReadError;
use crate::file::NamedBytes;
use crate::report::{ImportReport, Places};
use crate::soup::origin::Origin;
use crate::text::commas::{AMBIGUOUS, Commas, read_commas};
use crate::text::scan::{Scan, Ticker, is_text};
use glam::Vec3;
use halfedge::{Color, Progress};
use std::ops::Range;

/// How much of a file's start its words are looked for in, in bytes.
const HEAD_BYTES: usize = 4096;

/// A word of the format. Some programs write capitals, and ends in two words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Word {
    Solid,
    EndSolid,
    Facet,
    Vertex,
    /// The start or the end of a loop, or the end of a facet: a triangle ends there, whichever it is.
    Other,
    Color,
    /// Of no meaning: `outer`, `normal` and its numbers, which follow from the corners.
    Skipped,
    /// Not of the format.
    Unknown,
}

/// The next word.
fn next_word(scan: &mut Scan) -> Option<Word> {
    let word = scan.word()?;
    let is = |word: &[u8], names: &[&[u8]]| names.iter().any(|name| word.eq_ignore_ascii_case(name));
    Some(match word.first()? {
        b'0'..=b'9' | b'-' | b'+' | b'.' => Word::Skipped,
        _ if is(word, &[b"vertex"]) => Word::Vertex,
        _ if is(word, &[b"facet"]) => Word::Facet,
        _ if is(word, &[b"endloop", b"endfacet", b"end_loop", b"end_facet", b"loop"]) => Word::Other,
        _ if is(word, &[b"outer", b"normal"]) => Word::Skipped,
        _ if is(word, &[b"color", b"colour"]) => Word::Color,
        _ if is(word, &[b"solid"]) => Word::Solid,
        _ if is(word, &[b"endsolid", b"end_solid"]) => Word::EndSolid,
        _ if is(word, &[b"end"]) && scan.more_on_line() => match next_word(scan)? {
            Word::Solid => Word::EndSolid,
            Word::Facet | Word::Other => Word::Other,
            _ => Word::Unknown,
        },
        _ => Word::Unknown,
    })
}

/// Whether the bytes are a text STL.
pub(super) fn is_text_stl(bytes: &[u8]) -> bool {
    let head = bytes.get(..HEAD_BYTES).unwrap_or(bytes);
    let mut scan = Scan::new(head, None);
    if !is_text(head) || next_word(&mut scan) != Some(Word::Solid) {
        return false;
    }
    solid_name(&mut scan);
    let mut rest = std::iter::from_fn(|| next_word(&mut scan)).peekable();
    rest.peek().is_none() || rest.any(|word| matches!(word, Word::Facet | Word::EndSolid))
}

/// The rest of a line of `solid`, up to a triangle on the same line.
fn solid_name<'a>(scan: &mut Scan<'a>) -> &'a [u8] {
    let start = scan.at;
    let name = scan.line();
    let end = scan.at;
    scan.at = start;
    while scan.more_on_line() {
        let place = scan.at;
        let is_normal = |word: Option<&[u8]>| word.is_some_and(|word| word.eq_ignore_ascii_case(b"normal"));
        if next_word(scan) == Some(Word::Facet) {
            let after = scan.at;
            if is_normal(scan.word()) && [(); 3].iter().all(|()| scan.float().is_some()) {
                scan.at = place;
                return scan.taken_since(start).trim_ascii();
            }
            scan.at = after;
        }
    }
    scan.at = end;
    name
}

/// Reads the triangles of a file.
///
/// # Errors
/// Where it has triangles and none of them can be read.
pub(super) fn read(
    file: &NamedBytes,
    origin: &mut Option<Origin>,
    report: &mut ImportReport,
    progress: &mut Progress,
) -> Result<Triangles, ReadError> {
    let mut reader = Reader::new(&file.bytes);
    reader.read(origin, progress)?;
    if !reader.bad.is_empty() {
        match read_commas(&file.bytes, numbers_of_line) {
            Commas::None => {}
            Commas::Ambiguous if reader.triangles.count() == 0 => {
                return Err(ReadError::file(&file.name, AMBIGUOUS));
            }
            Commas::Ambiguous => {}
            Commas::Readable(text, note) => {
                report.info(note);
                let mut reader = Reader::new(&text);
                reader.read(origin, progress)?;
                return reader.finish(file, report);
            }
        }
    }
    reader.finish(file, report)
}

/// Where a line holds numbers alone: behind `vertex` or `normal`.
fn numbers_of_line(line: &[u8]) -> Range<usize> {
    let mut scan = Scan::new(line, None);
    while let Some(word) = scan.word() {
        if word.eq_ignore_ascii_case(b"vertex") || word.eq_ignore_ascii_case(b"normal") {
            return scan.at..line.len();
        }
        if word.eq_ignore_ascii_case(b"solid") {
            break;
        }
    }
    0..0
}

struct Reader<'a> {
    scan: Scan<'a>,
    size: usize,
    triangles: Triangles,
    corners: Vec<Vec3>,
    /// Whether all corners since the last triangle could be read.
    readable: bool,
    /// How many triangles there were, read or not.
    facets: usize,
    /// The number of triangles at the last `facet`, until one comes.
    open: Option<usize>,
    solid: String,
    color: Option<Color>,
    bad: Places,
    unknown: usize,
    /// How many solids have no name.
    nameless: usize,
    /// Whether a solid has started and not ended.
    in_solid: bool,
}

impl<'a> Reader<'a> {
    fn new(text: &'a [u8]) -> Self {
        Self {
            scan: Scan::new(text, None),
            size: text.len(),
            triangles: Triangles::new(),
            corners: Vec::with_capacity(3),
            readable: true,
            facets: 0,
            open: None,
            solid: String::new(),
            color: None,
            bad: Places::default(),
            unknown: 0,
            nameless: 0,
            in_solid: false,
        }
    }

    fn read(&mut self, origin: &mut Option<Origin>, progress: &mut Progress) -> Result<(), ReadError> {
        let mut ticker = Ticker::new(self.size);
        while let Some(word) = next_word(&mut self.scan) {
            match word {
                Word::Vertex => match self.scan.position(origin) {
                    Some(position) => self.corners.push(position),
                    None => self.readable = false,
                },
                Word::Facet => {
                    self.end_facet();
                    self.open = Some(self.facets);
                    ticker.tick(self.scan.at, progress)?;
                }
                Word::Other => self.end_triangle(),
                Word::Solid => {
                    self.end_facet();
                    self.in_solid = true;
                    self.solid = String::from_utf8_lossy(solid_name(&mut self.scan)).into_owned();
                    self.nameless += usize::from(self.solid.is_empty());
                    self.color = None;
                }
                Word::EndSolid => {
                    self.end_facet();
                    self.in_solid = false;
                    self.scan.skip_line();
                    self.solid.clear();
                    self.color = None;
                }
                Word::Color => self.color = self.color(),
                Word::Skipped => {}
                Word::Unknown => self.unknown += 1,
            }
        }
        Ok(())
    }

    /// Takes the corners since the last triangle as one.
    fn end_triangle(&mut self) {
        if self.corners.is_empty() && self.readable {
            return;
        }
        self.facets += 1;
        if self.readable && self.corners.len() >= 3 {
            self.triangles.push(&self.corners);
            if !self.solid.is_empty() {
                self.triangles.name_solid(&self.solid);
            }
            if let Some(color) = self.color {
                self.triangles.paint(color);
            }
        } else {
            self.bad.add(self.facets);
        }
        self.corners.clear();
        self.readable = true;
    }

    /// A triangle ends, and a facet without one is noted.
    fn end_facet(&mut self) {
        self.end_triangle();
        if self.open.take() == Some(self.facets) {
            self.facets += 1;
            self.bad.add(self.facets);
        }
    }

    /// The colour of the faces that follow, out of 1 or out of 255; not in every program's STL.
    fn color(&mut self) -> Option<Color> {
        let channels = Vec3::new(self.scan.float()?, self.scan.float()?, self.scan.float()?);
        let full = if channels.max_element() > 1.0 { 1.0 } else { 255.0 };
        Some(Color((channels * full).to_array().map(|channel| channel.round().clamp(0.0, 255.0) as u8)))
    }

    fn finish(mut self, file: &NamedBytes, report: &mut ImportReport) -> Result<Triangles, ReadError> {
        let is_cut = !self.corners.is_empty() && self.corners.len() < 3;
        if is_cut {
            self.corners.clear();
            self.open = None;
        }
        self.end_facet();
        if self.triangles.count() == 0 && (!self.bad.is_empty() || is_cut || self.unknown > 0) {
            let why = "none of its triangles has three corners of three numbers";
            return Err(ReadError::not_a(file, "an STL", why));
        }
        if !self.bad.is_empty() {
            let what = "left out: not three corners of three numbers";
            report.warn(self.bad.sentence("triangle", "triangles", what, "number"));
        }
        if is_cut {
            report.warn(
                "The file ends in the middle of a triangle, which was left out: it was cut off, so more triangles may be \
                 missing. Get the whole file, or check the model for holes",
            );
        } else if self.in_solid {
            report.warn(
                "The file ends without `endsolid`: it may have been cut off, so triangles may be missing. Check the model for \
                 holes",
            );
        }
        if self.nameless > 1 {
            report.info(format!("{} solids have no name and are not told apart", self.nameless));
        }
        Ok(self.triangles)
    }
}
