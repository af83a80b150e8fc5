//! Reading Bezier curves and surfaces.

use crate::error::ReadError;
use crate::file::NamedBytes;
use crate::format::reading::Reading;
use crate::model::NamedMesh;
use crate::report::ImportReport;
use crate::soup::origin::Origin;
use crate::text::encoding::{Encoding, decode};
use crate::text::number;
use crate::text::scan::{Scan, Ticker};
use glam::{DVec3, Vec3};
use halfedge::words::{counted, thousands};
use halfedge::{Mesh, Progress};
use std::borrow::Cow;
use std::sync::Arc;
use surface::bezier::{Bezier, Curve, Patch};

/// Control points of a patch.
const POINTS_PER_PATCH: usize = 16;

/// Numbers of a patch: three coordinates for each point.
const NUMBERS_PER_PATCH: usize = 3 * POINTS_PER_PATCH;

/// The size of the head of a file that tells its encoding.
const HEAD_BYTES: usize = 64;

/// Which of the two a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Curve,
    Surface,
}

/// Which of the two a file is, where it holds nothing but as many numbers as its first one says.
pub(crate) fn kind(bytes: &[u8]) -> Option<Kind> {
    let text = text(bytes);
    let mut scan = Scan::new(&text, Some(b'#'));
    let count = usize::try_from(whole(scan.word()?)?).ok().filter(|&count| count > 0)?;
    let mut numbers = 0usize;
    while let Some(word) = scan.word() {
        word.iter().all(|b| b.is_ascii_digit() || b"+-.eE".contains(b)).then_some(())?;
        numbers += 1;
    }
    let takes = |each: usize| count.checked_mul(each) == Some(numbers);
    if takes(NUMBERS_PER_PATCH) {
        return Some(Kind::Surface);
    }
    (takes(2) || takes(3)).then_some(Kind::Curve)
}

/// The bytes of a text, in UTF-8 where it was in UTF-16.
fn text(bytes: &[u8]) -> Cow<'_, [u8]> {
    // Large files that are no text are not decoded: their start tells.
    let head = bytes.get(..HEAD_BYTES).unwrap_or(bytes);
    match decode(head).1 {
        Encoding::Utf16 => Cow::Owned(decode(bytes).0.into_owned().into_bytes()),
        _ => Cow::Borrowed(bytes),
    }
}

fn whole(word: &[u8]) -> Option<i64> {
    number::integer(word, 0).filter(|&(_, end)| end == word.len()).map(|(value, _)| value)
}

/// The numbers of a file after its count.
#[derive(Default)]
struct Numbers {
    /// In the precision that positions are read in.
    values: Vec<f64>,
    /// How many each line has, where all have the same number.
    per_line: Option<usize>,
    /// Where a word is no number, in words: nothing is read from there on.
    broken: Option<String>,
}

impl Numbers {
    fn read(
        scan: &mut Scan,
        is_precise: bool,
        size: usize,
        progress: &mut Progress,
    ) -> Result<Self, ReadError> {
        let mut this = Self::default();
        let (mut line_length, mut on_line, mut is_even) = (0, 0, true);
        let mut ticker = Ticker::new(size);
        loop {
            if !scan.more_on_line() && on_line > 0 {
                is_even &= line_length == 0 || line_length == on_line;
                (line_length, on_line) = (on_line, 0);
            }
            let Some(word) = scan.word() else { break };
            let Some(value) = value(word, is_precise) else {
                let line = scan.line_number();
                let why = match word.contains(&b',') {
                    true => "has a comma; numbers need decimal points and blanks between them",
                    false => "is not a number that fits",
                };
                this.broken = Some(format!("line {line}: “{}” {why}", shown(word)));
                break;
            };
            on_line += 1;
            this.values.push(value);
            ticker.tick(scan.at, progress)?;
        }
        this.per_line = is_even.then_some(line_length);
        Ok(this)
    }

    /// Points of `each` coordinates, `count` of them or as many as there are.
    fn points(&self, each: usize, count: usize, origin: &mut Option<Origin>) -> Vec<Vec3> {
        let point = |numbers: &[f64]| {
            let at = |i: usize| numbers.get(i).copied().unwrap_or(0.0);
            let point = DVec3::new(at(0), at(1), at(2));
            origin.as_mut().map_or_else(|| point.as_vec3(), |origin| origin.place(point))
        };
        self.values.chunks_exact(each).take(count).map(point).collect()
    }
}

/// A word as a number that `f32` can hold.
fn value(word: &[u8], is_precise: bool) -> Option<f64> {
    let is_whole_word = |end: usize| end == word.len();
    match is_precise {
        true => {
            number::double(word, 0).filter(|&(value, end)| is_whole_word(end) && (value as f32).is_finite())
        }
        false => number::float(word, 0)
            .filter(|&(value, end)| is_whole_word(end) && value.is_finite())
            .map(|(value, end)| (f64::from(value), end)),
    }
    .map(|(value, _)| value)
}

/// Reads one curve or surface as one object with an empty mesh.
pub(crate) fn read(
    file: &NamedBytes,
    kind: Kind,
    reading: &mut Reading,
    progress: &mut Progress,
) -> Result<(NamedMesh, ImportReport), ReadError> {
    let (things, what) = match kind {
        Kind::Curve => ("control points", "a Bezier curve"),
        Kind::Surface => ("patches", "a Bezier surface"),
    };
    let fail = |message: String| ReadError::file(&file.name, message);
    let text = text(&file.bytes);
    let mut scan = Scan::new(&text, Some(b'#'));
    let Some(word) = scan.word() else {
        return Err(fail(format!("it holds only comments; {what} begins with the number of its {things}")));
    };
    let first_line = scan.line_number();
    let Some(count) = whole(word).and_then(|n| usize::try_from(n).ok()).filter(|&n| n > 0) else {
        return Err(fail(format!(
            "line {first_line}: {what} begins with the number of its {things}, 1 or more, not with “{}”",
            shown(word)
        )));
    };
    let numbers = Numbers::read(&mut scan, reading.origin.is_some(), text.len(), progress)?;
    let mut report = ImportReport::default();
    let bezier = if kind == Kind::Curve {
        curve(count, &numbers, &mut reading.origin, &mut report).inspect(|_| {
            if file.has_extension("bez") {
                let numbers = counted(numbers.values.len(), "number", "numbers");
                report.warn(format!(
                    "Read as a curve, for which there are as many numbers as its first one says; if it is a surface, \
                     as its name has it, it ends early: {numbers} follow, and each patch takes {NUMBERS_PER_PATCH}"
                ));
            }
        })
    } else {
        surface(count, &numbers, &mut reading.origin, &mut report)
    };
    let bezier = bezier.map_err(|message| {
        fail(numbers.broken.clone().unwrap_or_else(|| format!("line {first_line}: {message}")))
    })?;
    if let Some(broken) = numbers.broken {
        report.warn(format!("Everything from there on is left out: {broken}"));
    }
    if progress(1.0).is_break() {
        return Err(ReadError::Cancelled);
    }
    Ok((NamedMesh { bezier: Some(Arc::new(bezier)), ..NamedMesh::new(file.stem(), Mesh::new()) }, report))
}

/// The control points of a curve.
fn curve(
    count: usize,
    numbers: &Numbers,
    origin: &mut Option<Origin>,
    report: &mut ImportReport,
) -> Result<Bezier, String> {
    let needs = |each: usize| count.saturating_mul(each);
    let available = numbers.values.len();
    // Lines of two or three numbers tell points that are too many from points of the other kind. Where not
    // all numbers can be read, only lines tell.
    let is_exact = |each: usize| available == needs(each) && numbers.broken.is_none();
    let is_laid_out = |each: usize| numbers.per_line == Some(each) && available >= needs(each);
    let each = if is_exact(2) || is_laid_out(2) {
        2
    } else if is_exact(3) || is_laid_out(3) {
        3
    } else {
        return Err(format!(
            "{} take {} numbers in the plane or {} in space, but {available} follow",
            counted(count, "control point", "control points"),
            needs(2),
            needs(3),
        ));
    };
    if each == 3 {
        report.info("Its control points are in space: there are three numbers, x, y and z, for each");
    }
    left_over(available - needs(each), &counted(count, "control point", "control points"), report);
    Ok(Bezier::Curve(Curve { points: numbers.points(each, count, origin) }))
}

/// Warns of numbers after the last of `things`.
fn left_over(count: usize, things: &str, report: &mut ImportReport) {
    if count > 0 {
        let numbers = counted(count, "number", "numbers");
        report.warn(format!("{numbers} after the last of the {things} left out"));
    }
}

fn surface(
    count: usize,
    numbers: &Numbers,
    origin: &mut Option<Origin>,
    report: &mut ImportReport,
) -> Result<Bezier, String> {
    let available = numbers.values.len();
    let whole = (available / NUMBERS_PER_PATCH).min(count);
    if whole == 0 {
        return Err(format!(
            "a patch takes {NUMBERS_PER_PATCH} numbers, 16 points of x, y and z, but only {available} follow"
        ));
    }
    let points = numbers.points(3, whole * POINTS_PER_PATCH, origin);
    let (rows, _) = points.as_chunks::<4>();
    let (patches, _) = rows.as_chunks::<4>();
    if whole < count {
        report.warn(format!(
            "The file ends early: {} of {} patches are there",
            thousands(whole),
            thousands(count)
        ));
    }
    let rest = available.saturating_sub(count.saturating_mul(NUMBERS_PER_PATCH));
    left_over(rest, &counted(count, "patch", "patches"), report);
    Ok(Bezier::Surface(patches.iter().map(|rows| Patch { rows: *rows }).collect()))
}

/// The start of a word, for a message.
fn shown(word: &[u8]) -> String {
    String::from_utf8_lossy(word).chars().take(20).collect()
}
