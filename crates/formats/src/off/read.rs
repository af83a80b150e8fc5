//! Reading an OFF.

use super::binary::{self, Counts};
use super::contents::Contents;
use super::keyword::{Keyword, is_binary};
use super::text::TextReader;
use crate::error::ReadError;
use crate::file::NamedBytes;
use crate::format::reading::{Reading, build};
use crate::model::NamedMesh;
use crate::report::ImportReport;
use crate::text::commas::{AMBIGUOUS, Commas, read_commas};
use crate::text::scan::Scan;
use halfedge::Progress;
use halfedge::words::thousands;

/// The most dimensions of an `nOFF` that is read.
const MAX_DIMENSIONS: u64 = 16;

/// Reads one OFF as one object.
///
/// # Errors
/// Where it is no OFF, or nothing in it can be read.
pub(super) fn read(
    file: &NamedBytes,
    reading: &mut Reading,
    progress: &mut Progress,
) -> Result<(NamedMesh, ImportReport), ReadError> {
    let mut report = ImportReport::default();
    let mut contents = if is_binary(&file.bytes) {
        read_binary(file, reading, &mut report, progress)?
    } else {
        read_text(file, &file.bytes, reading, &mut report, progress)?
    };
    if !contents.troubles.bad_vertices.is_empty() {
        match read_commas(&file.bytes, numbers_of_line) {
            Commas::None => {}
            Commas::Ambiguous if contents.is_unreadable() => {
                return Err(ReadError::file(&file.name, AMBIGUOUS));
            }
            Commas::Ambiguous => {}
            Commas::Readable(text, note) => {
                report = ImportReport::default();
                report.info(note);
                contents = read_text(file, &text, reading, &mut report, progress)?;
            }
        }
    }
    if contents.is_unreadable() {
        return Err(ReadError::not_a(file, "an OFF", "none of its vertices has three numbers"));
    }
    let soup = contents.finish(&mut report);
    let part = &mut |part| progress(0.5 + part * 0.5);
    let object = build(file.stem(), soup, &file.name, reading, &mut report, part)?;
    Ok((object, report))
}

/// Where a line holds numbers alone: before a comment, and not in the first line.
fn numbers_of_line(line: &[u8]) -> std::ops::Range<usize> {
    let end = line.iter().position(|&byte| byte == b'#').unwrap_or(line.len());
    let is_first = line.windows(3).any(|part| part == b"OFF");
    if is_first { 0..0 } else { 0..end }
}

fn read_text(
    file: &NamedBytes,
    text: &[u8],
    reading: &mut Reading,
    report: &mut ImportReport,
    progress: &mut Progress,
) -> Result<Contents, ReadError> {
    let mut scan = Scan::new(text, Some(b'#'));
    let word = scan.word().ok_or_else(|| ReadError::not_a(file, "an OFF", "it holds only comments"))?;
    // The keyword may be left out: then the counts come first.
    let keyword = Keyword::parse(word).unwrap_or_default();
    scan.at -= word.len() - keyword.length;
    let mut count = || scan.integer().and_then(|count| u64::try_from(count).ok());
    let dimensions = if keyword.any_dimension { count() } else { Some(3) };
    let (Some(dimensions), Some(vertices)) = (dimensions, count()) else { return Err(no_counts(file)) };
    if !(1..=MAX_DIMENSIONS).contains(&dimensions) {
        let message = format!("it has {dimensions} dimensions; up to {MAX_DIMENSIONS} can be read");
        return Err(ReadError::file(&file.name, message));
    }
    let is_same_line = scan.more_on_line();
    let Some(faces) = scan.integer().and_then(|count| u64::try_from(count).ok()) else {
        return Err(no_counts(file));
    };
    // The number of edges means nothing, and some files don't have it.
    if scan.more_on_line() || !is_same_line {
        scan.integer();
    }
    let dimensions = dimensions as usize + usize::from(keyword.homogeneous);
    let mut reader = TextReader::new(scan, text.len(), keyword, dimensions);
    // No more room than the file can fill: two bytes a number at least.
    let most = text.len() / 2;
    reader.contents.soup.positions.reserve(usize::try_from(vertices).unwrap_or(most).min(most / 3));
    reader.contents.soup.face_starts.reserve(usize::try_from(faces).unwrap_or(most).min(most / 4));
    let vertices_there = reader.vertices(vertices, faces, &mut reading.origin, progress)?;
    let faces_there = reader.faces(faces, progress)?;
    note_early_end([vertices, faces], [vertices_there, faces_there], report);
    Ok(reader.contents)
}

fn no_counts(file: &NamedBytes) -> ReadError {
    ReadError::not_a(file, "an OFF", "the numbers of its vertices, faces and edges don't come first")
}

fn read_binary(
    file: &NamedBytes,
    reading: &mut Reading,
    report: &mut ImportReport,
    progress: &mut Progress,
) -> Result<Contents, ReadError> {
    let mut scan = Scan::new(&file.bytes, Some(b'#'));
    let keyword = scan.word().and_then(Keyword::parse).unwrap_or_default();
    scan.skip_line();
    let body = match file.bytes.get(scan.at..).unwrap_or_default() {
        [b'\r', b'\n', body @ ..] | [_, body @ ..] => body,
        [] => &[],
    };
    let mut contents = Contents::default();
    let counts = binary::read(body, keyword, &mut contents, &mut reading.origin, progress)?;
    let Some(Counts { said, there }) = counts else {
        let why = "its numbers are neither as Geomview nor as pmp-library writes a binary OFF";
        return Err(ReadError::not_a(file, "an OFF", why));
    };
    note_early_end(said, there, report);
    Ok(contents)
}

fn note_early_end(
    [vertices, faces]: [u64; 2],
    [vertices_there, faces_there]: [u64; 2],
    report: &mut ImportReport,
) {
    if vertices_there < vertices || faces_there < faces {
        report.warn(format!(
            "The file ends early: {} of {} vertices and {} of {} faces are there",
            thousands(vertices_there),
            thousands(vertices),
            thousands(faces_there),
            thousands(faces)
        ));
    }
}
