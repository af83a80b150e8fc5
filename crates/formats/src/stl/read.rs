//! Reading an STL.

use super::{binary, text};
use crate::error::ReadError;
use crate::file::NamedBytes;
use crate::format::reading::{Reading, build};
use crate::model::NamedMesh;
use crate::report::ImportReport;
use halfedge::Progress;
use halfedge::words::counted;

/// Whether the bytes are an STL.
pub(super) fn is_stl(bytes: &[u8]) -> bool {
    text::is_text_stl(bytes) || binary::is_binary(bytes)
}

/// Reads one STL as one object.
///
/// # Errors
/// Where it is no STL, or none of its triangles can be read.
pub(super) fn read(
    file: &NamedBytes,
    reading: &mut Reading,
    progress: &mut Progress,
) -> Result<(NamedMesh, ImportReport), ReadError> {
    let mut report = ImportReport::default();
    let read = if text::is_text_stl(&file.bytes) { text::read } else { binary::read };
    let triangles = read(file, &mut reading.origin, &mut report, progress)?;
    let soup = triangles.finish(file.stem());
    if !soup.corners.is_empty() {
        report.info(format!(
            "{} at the same positions merged into {}",
            counted(soup.corners.len(), "corner", "corners"),
            counted(soup.positions.len(), "vertex", "vertices")
        ));
    }
    let part = &mut |part| progress(0.5 + part * 0.5);
    let object = build(file.stem(), soup, &file.name, reading, &mut report, part)?;
    Ok((object, report))
}
