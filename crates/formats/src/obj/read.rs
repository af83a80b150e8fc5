//! Reading an OBJ: statements to polygon soup with attributes, to a mesh, with a report.

use super::mtl;
use super::names::unpainted;
use super::statements::{Statements, Troubles};
use crate::import::{ImportedObject, NamedBytes, ReadError, Reading, build, not_a};
use crate::material::{Material, Materials};
use crate::report::{ImportReport, counted, first_few};
use crate::scan::is_text;
use crate::soup::{drop_faces, labelled};
use halfedge::attribute::{AttributeType, Column, Key};
use halfedge::{Color, NONE, PolygonSoup, Progress, keys};
use std::collections::{HashMap, HashSet};

/// Whether a `mtllib` line names this file. A line may name several files, or one with blanks.
fn mentions(statements: &Statements, library: &str) -> bool {
    let base = |path: &str| path.rsplit(['/', '\\']).next().unwrap_or(path).to_lowercase();
    let library = base(library);
    statements
        .libraries
        .iter()
        .any(|line| base(line) == library || line.split_whitespace().any(|name| base(name) == library))
}

/// Reads one OBJ as one object, and the materials of its faces. `libraries` are the `.mtl` files that
/// came with it, `files` all files.
pub(crate) fn read(
    file: &NamedBytes,
    libraries: &[&NamedBytes],
    files: &[NamedBytes],
    reading: &mut Reading,
    progress: &mut Progress,
) -> Result<(ImportedObject, Materials, ImportReport), ReadError> {
    if let Some(kind) = not_text(&file.bytes) {
        return Err(ReadError::file(&file.name, kind));
    }
    // Reading takes about as long as building.
    let mut statements = Statements::read(&file.bytes, reading.origin, &mut |part| progress(part * 0.5))
        .ok_or(ReadError::Cancelled)?;
    reading.origin = statements.origin;
    let has_geometry = !statements.soup.positions.is_empty()
        || statements.soup.face_count() > 0
        || !statements.troubles.missing_vertex.is_empty();
    let is_obj = has_geometry || (statements.known > 0 && statements.troubles.unknown.is_empty());
    if !is_obj {
        let lines = counted(statements.lines, "line", "lines");
        let why = format!("none of its {lines} is a vertex (\"v 1 2 3\") or a face (\"f 1 2 3\")");
        return Err(ReadError::not_a(file, "an OBJ", &why));
    }
    let mut report = ImportReport::default();
    report_troubles(&statements.troubles, &mut report);
    let (soup, materials) = soup(&mut statements, libraries, files, &mut report);
    let part = &mut |part| progress(0.5 + part * 0.5);
    let object = build(file.stem(), soup, &file.name, reading, &mut report, part)?;
    Ok((object, materials, report))
}

/// What a file is that can't be text in UTF-8.
fn not_text(bytes: &[u8]) -> Option<String> {
    if bytes.starts_with(b"\xff\xfe") || bytes.starts_with(b"\xfe\xff") {
        return Some("the text is encoded as UTF-16; save it as UTF-8 and open it again".to_owned());
    }
    (!is_text(bytes)).then(|| not_a("an OBJ", "it is a binary file, not text"))
}

/// The soup with all attributes that the file gives, and the materials that its faces have.
fn soup(
    statements: &mut Statements,
    libraries: &[&NamedBytes],
    files: &[NamedBytes],
    report: &mut ImportReport,
) -> (PolygonSoup, Materials) {
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
    if let Some(groups) = statements.groups.expand(faces, NONE) {
        soup.face_columns.push(statements.group_names.column(keys::FACE_GROUP, groups));
    }
    let given = read_libraries(statements, libraries, files, report);
    let names = materials(statements, faces, &given.list, &mut soup.face_columns);
    if let Some(smoothing) = statements.smoothing.expand(faces, 0) {
        soup.face_columns.push(Column::with_values(keys::FACE_SMOOTHING, smoothing));
    }
    drop_faces(&mut soup, &statements.faces_without_vertices);
    (soup, in_use(given, &names, report))
}

/// Those of the libraries' materials that faces have, by name, with the images that they use.
fn in_use(given: Materials, names: &[String], report: &mut ImportReport) -> Materials {
    let names: HashSet<&str> = names.iter().map(String::as_str).collect();
    let is_used = |name: &str| !name.is_empty() && names.contains(name);
    let (list, mut unused): (Vec<_>, Vec<_>) =
        given.list.into_iter().partition(|material| is_used(&material.name));
    // Those that stand for a colour of another one are in the colours of faces.
    unused.retain(|material| unpainted(&material.name).is_none());
    let mut used = Materials::default();
    used.add(Materials { list, images: given.images });
    if let Some(parameters) = mtl::statement_counts(used.list.iter()) {
        report.info(format!(
            "What its materials have besides a colour is not shown, and is written again when it is saved as OBJ: \
             {parameters}"
        ));
    }
    let absent = used.images.iter().filter(|image| image.bytes.is_none());
    let absent: Vec<&str> = absent.map(|image| image.name.as_str()).collect();
    if !absent.is_empty() {
        report.info(format!(
            "{} that its materials use not given, so only referred to: {}",
            counted(absent.len(), "image", "images"),
            first_few(&absent, 6)
        ));
    }
    if !unused.is_empty() {
        let names: Vec<&str> = unused.iter().map(|material| material.name.as_str()).collect();
        report.info(format!(
            "{} that no face has left out: {}",
            counted(unused.len(), "material", "materials"),
            first_few(&names, 6)
        ));
    }
    used
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

/// All materials in the libraries that belong to the file: those it names, or, if it names none of
/// those that came with it, all that did.
fn read_libraries(
    statements: &Statements,
    libraries: &[&NamedBytes],
    files: &[NamedBytes],
    report: &mut ImportReport,
) -> Materials {
    let named: Vec<_> = libraries.iter().filter(|library| mentions(statements, &library.name)).collect();
    let used = if named.is_empty() { libraries.iter().collect() } else { named };
    let mut materials = Materials::default();
    for library in &used {
        let mut notes = ImportReport::default();
        let more = mtl::read(library, files, &mut notes);
        report.info(format!(
            "Colours of {} read from {}",
            counted(more.list.len(), "material", "materials"),
            library.name
        ));
        report.append(notes);
        // Of several materials of one name, the first counts.
        materials.add(more);
    }
    if used.is_empty() && !statements.libraries.is_empty() {
        report.info(format!(
            "The colours of its materials are in {}, which was not given: open both files together to see them",
            statements.libraries.join(", ")
        ));
    }
    materials
}

fn report_troubles(troubles: &Troubles, report: &mut ImportReport) {
    let mut warn = |places: &crate::report::Places, one: &str, many: &str, what: &str| {
        if !places.is_empty() {
            report.warn(places.sentence(one, many, what, "line"));
        }
    };
    warn(
        &troubles.bad_vertices,
        "vertex",
        "vertices",
        "put at the origin: a vertex is \"v\" and three numbers, a fourth (w) or a colour of three may follow",
    );
    warn(
        &troubles.bad_faces,
        "face",
        "faces",
        "left out: a corner can't be read as vertex numbers, like 1 or 1/2/3",
    );
    warn(&troubles.small_faces, "face", "faces", "left out: a face needs three corners or more");
    warn(
        &troubles.missing_vertex,
        "face",
        "faces",
        "left out: a corner refers to a vertex that doesn't exist",
    );
    warn(
        &troubles.missing_attribute,
        "corner",
        "corners",
        "without texture coordinate or normal: the one it refers to doesn't exist",
    );
    warn(&troubles.bad_uvs, "texture coordinate", "texture coordinates", "ignored: not one to three numbers");
    warn(&troubles.bad_normals, "normal", "normals", "ignored: not three numbers");
    warn(
        &troubles.bad_smoothing,
        "smoothing group",
        "smoothing groups",
        "ignored: neither a number nor \"off\"",
    );
    warn(
        &troubles.fourth_coordinate,
        "vertex",
        "vertices",
        "kept as x, y, z: the fourth coordinate (w) is not used",
    );
    warn(
        &troubles.lines_and_points,
        "line or point element (l, p)",
        "line or point elements (l, p)",
        "left out: only faces are edited here",
    );
    warn(
        &troubles.curves,
        "statement",
        "statements",
        "left out: free-form curves and surfaces and display settings are not used here",
    );
    warn(&troubles.unknown, "line", "lines", "ignored: it doesn't start with a word of the OBJ format");
}
