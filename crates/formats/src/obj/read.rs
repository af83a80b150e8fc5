//! Reading an OBJ: statements to polygon soup with attributes, to a mesh, with a report.

use super::libraries;
use super::names::names_without_faces;
use super::statements::Statements;
use crate::error::ReadError;
use crate::format::reading::{Contents, Reading, Source, build};
use crate::model::labels::labelled;
use crate::model::material::{Material, Materials};
use crate::model::paint::unpainted;
use crate::report::{ImportReport, first_few};
use crate::soup::drop_faces;
use crate::text::commas::{AMBIGUOUS, Commas, read_commas};
use crate::text::scan::{Scan, is_text};
use halfedge::attribute::{AttributeType, Column, Key};
use halfedge::{Color, NONE, PolygonSoup, Progress, keys};
use std::collections::HashMap;
use std::ops::Range;

/// Reads one OBJ as one object, and the materials of its faces.
///
/// # Errors
/// Where it is no OBJ, or none of its vertices can be read.
pub(super) fn read(
    source: &Source,
    reading: &mut Reading,
    progress: &mut Progress,
) -> Result<Contents, ReadError> {
    let file = source.file;
    if !is_text(&file.bytes) {
        return Err(ReadError::not_a(file, "an OBJ", "it is a binary file, not text"));
    }
    let mut report = ImportReport::default();
    let mut statements = read_statements(&file.bytes, reading, progress)?;
    if !statements.troubles.bad_vertices.is_empty() {
        match read_commas(&file.bytes, numbers_of_line) {
            Commas::None => {}
            Commas::Ambiguous if statements.is_unreadable() => {
                return Err(ReadError::file(&file.name, AMBIGUOUS));
            }
            Commas::Ambiguous => {}
            Commas::Readable(text, note) => {
                report.info(note);
                statements = read_statements(&text, reading, progress)?;
            }
        }
    }
    reading.origin = statements.origin;
    let has_geometry = !statements.soup.positions.is_empty()
        || statements.soup.face_count() > 0
        || !statements.troubles.missing_vertex.is_empty();
    let is_obj = has_geometry || (statements.known > 0 && statements.troubles.unknown.is_empty());
    if !is_obj {
        let why = "it has no line for a vertex (\"v 1 2 3\") or a face (\"f 1 2 3\")";
        return Err(ReadError::not_a(file, "an OBJ", why));
    }
    if statements.is_unreadable() {
        return Err(ReadError::not_a(file, "an OBJ", "none of its vertices has three numbers (\"v 1 2 3\")"));
    }
    statements.troubles.report(&mut report);
    let (soup, materials) = soup(&mut statements, source, &mut report);
    let part = &mut |part| progress(0.5 + part * 0.5);
    let object = build(file.stem(), soup, &file.name, reading, &mut report, part)?;
    Ok(Contents { objects: vec![object], materials, report })
}

fn read_statements(text: &[u8], reading: &Reading, progress: &mut Progress) -> Result<Statements, ReadError> {
    // Reading takes about as long as building.
    let part = &mut |part| progress(part * 0.5);
    Statements::read(text, reading.origin, part).ok_or(ReadError::Cancelled)
}

/// Where a line holds numbers alone: behind the word of a vertex, texture coordinate or normal.
fn numbers_of_line(line: &[u8]) -> Range<usize> {
    let mut scan = Scan::new(line, Some(b'#'));
    match scan.word() {
        Some(b"v" | b"vt" | b"vn") => {
            scan.at..line.iter().position(|&byte| byte == b'#').unwrap_or(line.len())
        }
        _ => 0..0,
    }
}

/// The soup with all attributes that the file gives, and the materials that its faces have.
fn soup(statements: &mut Statements, source: &Source, report: &mut ImportReport) -> (PolygonSoup, Materials) {
    let mut soup = std::mem::take(&mut statements.soup);
    let faces = soup.face_count();
    if !statements.colors.is_empty() {
        let colors = std::mem::take(&mut statements.colors);
        soup.vertex_columns.push(Column::with_values(keys::VERTEX_COLOR, colors));
    }
    soup.corner_columns.extend(corner_column(
        keys::CORNER_UV,
        &statements.corner_uvs,
        &statements.uvs,
        soup.corners.len(),
    ));
    soup.corner_columns.extend(corner_column(
        keys::CORNER_NORMAL,
        &statements.corner_normals,
        &statements.normals,
        soup.corners.len(),
    ));
    let groups = statements.groups.expand(faces, NONE);
    let groups = groups.map(|groups| statements.group_names.column(keys::FACE_GROUP, groups));
    let used = groups.iter().flat_map(|column| &column.labels).map(String::as_str);
    let empty = names_without_faces(statements.group_names.iter(), used);
    if !empty.is_empty() {
        report.info(format!("Groups and objects without faces are left out: {}", first_few(&empty, 6)));
    }
    soup.face_columns.extend(groups);
    let given = libraries::read(&statements.libraries, source, report);
    let names = materials(statements, faces, &given.list, &mut soup.face_columns);
    if let Some(smoothing) = statements.smoothing.expand(faces, 0) {
        soup.face_columns.push(Column::with_values(keys::FACE_SMOOTHING, smoothing));
    }
    drop_faces(&mut soup, &statements.faces_without_vertices);
    (soup, libraries::in_use(given, &names, report))
}

/// The values that corners refer to by number; nothing where no corner has one.
fn corner_column<T: AttributeType>(
    key: Key<T>,
    numbers: &[u32],
    values: &[T],
    corners: usize,
) -> Option<Column> {
    let value = |number: &u32| values.get(*number as usize).copied();
    if !numbers.iter().any(|number| value(number).is_some()) {
        return None;
    }
    let mut column: Vec<T> = Vec::with_capacity(corners);
    column.extend(numbers.iter().map(|number| value(number).unwrap_or(key.default)));
    column.resize(corners, key.default);
    Some(Column::with_values(key, column))
}

/// Adds the columns of materials and of their colours; gives the materials' names.
fn materials(
    statements: &Statements,
    faces: usize,
    given: &[Material],
    columns: &mut Vec<Column>,
) -> Vec<String> {
    let Some(numbers) = statements.materials.expand(faces, NONE) else { return Vec::new() };
    let given: HashMap<&str, Option<Color>> =
        given.iter().map(|material| (material.name.as_str(), material.color())).collect();
    // What each name in the file stands for.
    let count = numbers.iter().filter(|&&n| n != NONE).max().map_or(0, |&n| n as usize + 1);
    let mut names: Vec<String> = Vec::with_capacity(count);
    let mut colors = Vec::with_capacity(count);
    let mut has_colors = false;
    for number in 0..count {
        let name = statements.material_names.name(number as u32).unwrap_or_default();
        let library_color = given.get(name).copied();
        let library_color = library_color.flatten();
        let (material, color) = match unpainted(name) {
            Some((material, paint)) if library_color.is_none_or(|color| color == paint) => {
                (material, Some(paint))
            }
            _ => (name, library_color),
        };
        has_colors |= color.is_some_and(|color| color != Color::UNPAINTED) || library_color.is_some();
        names.push(material.to_owned());
        colors.push(color.unwrap_or(Color::UNPAINTED));
    }
    let labels: Vec<u32> = {
        // Several painted names may stand for one material.
        let mut first: HashMap<&str, u32> = HashMap::new();
        let unified: Vec<u32> = (0u32..)
            .zip(&names)
            .map(|(number, name)| if name.is_empty() { NONE } else { *first.entry(name).or_insert(number) })
            .collect();
        numbers.iter().map(|&n| unified.get(n as usize).copied().unwrap_or(NONE)).collect()
    };
    if labels.iter().any(|&label| label != NONE) {
        columns.push(labelled(keys::FACE_MATERIAL, labels, &names));
    }
    if has_colors {
        let color = |n: &u32| colors.get(*n as usize).copied().unwrap_or(Color::UNPAINTED);
        columns.push(Column::with_values(keys::FACE_COLOR, numbers.iter().map(color).collect()));
    }
    names
}
