//! Reading Bezier curves and surfaces.

use crate::error::ReadError;
use crate::file::NamedBytes;
use crate::model::NamedMesh;
use crate::report::{ImportReport, counted};
use crate::text::number;
use crate::text::scan::{Scan, Ticker};
use glam::Vec3;
use halfedge::{Mesh, Progress};
use std::sync::Arc;
use surface::bezier::{Bezier, Curve, Patch};

/// Numbers that a patch takes: 16 points of three coordinates.
const NUMBERS_PER_PATCH: usize = 48;

/// Which of the two a file is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Curve,
    Surface,
}

/// Which of the two a file is, where it holds nothing but as many numbers as its first one says.
pub(crate) fn kind(bytes: &[u8]) -> Option<Kind> {
    let mut scan = Scan::new(bytes, Some(b'#'));
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

fn whole(word: &[u8]) -> Option<i64> {
    number::integer(word, 0).filter(|&(_, end)| end == word.len()).map(|(value, _)| value)
}

/// Reads one curve or surface as one object with an empty mesh.
pub(crate) fn read(
    file: &NamedBytes,
    kind: Kind,
    progress: &mut Progress,
) -> Result<(NamedMesh, ImportReport), ReadError> {
    let (things, what) = match kind {
        Kind::Curve => ("control points", "a Bezier curve"),
        Kind::Surface => ("patches", "a Bezier surface"),
    };
    let fail = |message: String| ReadError::file(&file.name, message);
    let mut scan = Scan::new(&file.bytes, Some(b'#'));
    let Some(word) = scan.word() else {
        return Err(fail(format!("the file is empty; {what} begins with the number of its {things}")));
    };
    let first_line = scan.line_number();
    let Some(count) = whole(word).and_then(|n| usize::try_from(n).ok()).filter(|&n| n > 0) else {
        return Err(fail(format!(
            "line {first_line}: {what} begins with the number of its {things}, 1 or more, not with “{}”",
            shown(word)
        )));
    };
    let mut numbers: Vec<f32> = Vec::new();
    // How many numbers each line has, where all have as many.
    let (mut per_line, mut on_line, mut even) = (0, 0, true);
    let mut ticker = Ticker::new(file.bytes.len());
    loop {
        if !scan.more_on_line() && on_line > 0 {
            even &= per_line == 0 || per_line == on_line;
            (per_line, on_line) = (on_line, 0);
        }
        let Some(word) = scan.word() else { break };
        on_line += 1;
        match number::float(word, 0).filter(|&(value, end)| end == word.len() && value.is_finite()) {
            Some((value, _)) => numbers.push(value),
            None => {
                let line = scan.line_number();
                return Err(fail(format!("line {line}: “{}” is not a number that fits", shown(word))));
            }
        }
        ticker.tick(scan.at, progress)?;
    }
    let mut report = ImportReport::default();
    let bezier = if kind == Kind::Curve {
        let width = if even { per_line } else { 0 };
        curve(count, &numbers, width, &mut report).inspect(|_| {
            if file.has_extension("bez") {
                let numbers = counted(numbers.len(), "number", "numbers");
                report.warn(format!(
                    "Read as a curve, for which there are as many numbers as its first one says; if it is a surface, \
                     as its name has it, it ends early: {numbers} follow, and each patch takes {NUMBERS_PER_PATCH}"
                ));
            }
        })
    } else {
        surface(count, &numbers, &mut report)
    };
    let bezier = bezier.map_err(|message| fail(format!("line {first_line}: {message}")))?;
    if progress(1.0).is_break() {
        return Err(ReadError::Cancelled);
    }
    Ok((NamedMesh { bezier: Some(Arc::new(bezier)), ..NamedMesh::new(file.stem(), Mesh::new()) }, report))
}

/// The control points of a curve; `width` is how many numbers are on each line, 0 where that differs.
fn curve(count: usize, numbers: &[f32], width: usize, report: &mut ImportReport) -> Result<Bezier, String> {
    let needs = |each: usize| count.saturating_mul(each);
    // Lines of two or three numbers tell points that are too many from another kind of points.
    let is_laid_out = |each: usize| width == each && numbers.len() > needs(each);
    let each = if numbers.len() == needs(2) || is_laid_out(2) {
        2
    } else if numbers.len() == needs(3) || is_laid_out(3) {
        3
    } else {
        return Err(format!(
            "{} take {} numbers in the plane or {} in space, but {} follow",
            counted(count, "control point", "control points"),
            needs(2),
            needs(3),
            numbers.len()
        ));
    };
    let used = numbers.get(..needs(each)).unwrap_or(numbers);
    let points = if each == 2 {
        used.as_chunks().0.iter().map(|&[x, y]| Vec3::new(x, y, 0.0)).collect()
    } else {
        report.info("Its control points are in space: there are three numbers, x, y and z, for each");
        used.as_chunks().0.iter().map(|&xyz| Vec3::from_array(xyz)).collect()
    };
    left_over(numbers.len() - used.len(), &counted(count, "control point", "control points"), report);
    Ok(Bezier::Curve(Curve { points }))
}

/// Warns of numbers after the last of `things`.
fn left_over(count: usize, things: &str, report: &mut ImportReport) {
    if count > 0 {
        let numbers = counted(count, "number", "numbers");
        report.warn(format!("{numbers} after the last of the {things} left out"));
    }
}

fn surface(count: usize, numbers: &[f32], report: &mut ImportReport) -> Result<Bezier, String> {
    let (points, _) = numbers.as_chunks::<3>();
    let (rows, _) = points.as_chunks::<4>();
    let (patches, _) = rows.as_chunks::<4>();
    let patch = |rows: &[[[f32; 3]; 4]; 4]| Patch { rows: rows.map(|row| row.map(Vec3::from_array)) };
    let patches: Vec<Patch> = patches.iter().take(count).map(patch).collect();
    if patches.is_empty() {
        return Err(format!(
            "a patch takes {NUMBERS_PER_PATCH} numbers, 16 points of x, y and z, but only {} follow",
            numbers.len()
        ));
    }
    if patches.len() < count {
        report.warn(format!("The file ends early: {} of {count} patches are there", patches.len()));
    }
    let rest = numbers.len().saturating_sub(count.saturating_mul(NUMBERS_PER_PATCH));
    left_over(rest, &counted(count, "patch", "patches"), report);
    Ok(Bezier::Surface(patches))
}

/// The start of a word, for a message.
fn shown(word: &[u8]) -> String {
    String::from_utf8_lossy(word).chars().take(20).collect()
}
