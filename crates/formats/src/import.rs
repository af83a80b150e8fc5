//! Files in: which format, which reader, one document.

use crate::bezier::Controls;
use crate::format::{Format, is_material_library};
use crate::material::Materials;
use crate::origin::{Bounds, Origin};
use crate::repairs::{self, Repairs};
use crate::report::{ImportReport, Places, counted};
use crate::{bezier, collada, gltf, obj, off, ply, stl};
use glam::DVec3;
use halfedge::{Mesh, PolygonSoup, Progress};
use std::collections::HashSet;
use std::fmt;
use std::sync::Arc;

/// A file in memory.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct NamedBytes {
    /// Its name, with extension; folders in front are allowed.
    pub name: String,
    /// What it holds.
    pub bytes: Vec<u8>,
}

impl NamedBytes {
    /// A file in memory.
    pub fn new(name: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Self {
        Self { name: name.into(), bytes: bytes.into() }
    }

    /// The name without folders and extension, for naming documents and objects.
    pub fn stem(&self) -> &str {
        let base = self.name.rsplit(['/', '\\']).next().unwrap_or_default();
        match base.rsplit_once('.') {
            Some((stem, _)) if !stem.is_empty() => stem,
            _ => base,
        }
    }
}

/// One mesh of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct ImportedObject {
    /// What to call it.
    pub name: String,
    /// The mesh: valid and compact. Empty where the file holds control points.
    pub mesh: Mesh,
    /// The control points of a Bezier curve or surface, which the file holds in place of a mesh.
    pub controls: Option<Controls>,
    /// The faces as they are in the file, where the mesh had to be made something else: what
    /// [`rebuild`](crate::rebuild) takes to make it another way.
    pub soup: Option<Arc<PolygonSoup>>,
}

impl ImportedObject {
    /// An object with nothing in it.
    pub(crate) fn empty(name: &str) -> Self {
        Self::new(name, Mesh::new())
    }

    /// An object that is a mesh.
    pub fn new(name: impl Into<String>, mesh: Mesh) -> Self {
        Self { name: name.into(), mesh, controls: None, soup: None }
    }
}

/// What came out of files.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    /// What to call the document: the first model file's name without extension.
    pub name: String,
    /// The meshes, in the files' order.
    pub objects: Vec<ImportedObject>,
    /// What to add to every position for the coordinates of the files: not zero where models so far
    /// from the origin were read that 32 bits are too few for them.
    pub offset: DVec3,
    /// The materials that faces have, with the images that these use.
    pub materials: Materials,
    /// What to tell the user.
    pub report: ImportReport,
}

/// What readers have to know besides the file.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Reading {
    /// Where positions are counted from, if not from zero.
    pub origin: Option<Origin>,
    /// How a mesh is made of what isn't one.
    pub repairs: Repairs,
}

/// Why nothing was read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ReadError {
    /// The progress callback asked to stop.
    Cancelled,
    /// No file given is a model.
    NoModel(String),
    /// A file can't be read at all.
    File {
        /// Its name.
        file: String,
        /// What is wrong and what to do.
        message: String,
    },
}

impl ReadError {
    pub(crate) fn file(file: &str, message: impl Into<String>) -> Self {
        Self::File { file: file.to_owned(), message: message.into() }
    }

    /// The file is not of the format that its name says, nor plainly of another.
    pub(crate) fn not_a(file: &NamedBytes, format: &str, why: &str) -> Self {
        Self::file(&file.name, not_a(format, why))
    }
}

/// That a file is not a model of its format, why, and what to do.
pub(crate) fn not_a(format: &str, why: &str) -> String {
    format!(
        "this is not {format}: {why}; nothing else that Meshwright opens is in it either, so check that it is the right \
         file, or export the model again"
    )
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cancelled => f.write_str("opening the file was cancelled"),
            Self::NoModel(message) => f.write_str(message),
            Self::File { file, message } => write!(f, "{file}: {message}"),
        }
    }
}

impl std::error::Error for ReadError {}

/// Reads files that were given together: models, and material libraries (`.mtl`) for them. Each
/// model file adds its objects. The format is told by content, then by extension.
///
/// `progress` is told fractions from 0 to 1 and may stop the work.
///
/// # Errors
/// When a file can't be read as a model at all, or none of them is one. What is merely damaged
/// loads as far as it can, and the report says what didn't.
///
/// # Cost
/// Time and memory are linear in the size of the files.
pub fn read(files: &[NamedBytes], progress: &mut Progress) -> Result<Import, ReadError> {
    read_with(files, &Repairs::default(), progress)
}

/// [`read`] with choices in how meshes are made of what is not one as it stands.
///
/// # Errors
/// As [`read`].
pub fn read_with(
    files: &[NamedBytes],
    repairs: &Repairs,
    progress: &mut Progress,
) -> Result<Import, ReadError> {
    let mut reading = Reading { repairs: *repairs, ..Reading::default() };
    let import = read_all(files, &mut reading, progress)?;
    let bounds = Bounds::of(&import.objects);
    let Some(offset) = bounds.offset() else { return Ok(import) };
    // Far away: read again, precisely, and see whether that tells more.
    let mut reading = Reading { origin: Some(Origin::new(offset)), ..reading };
    let mut precise = read_all(files, &mut reading, progress)?;
    if !reading.origin.is_some_and(|origin| bounds.is_worth(&origin)) {
        return Ok(import);
    }
    precise.offset = offset;
    let DVec3 { x, y, z } = offset;
    precise.report.info(format!(
        "The model lies far from the origin, so positions count from ({x}, {y}, {z}), which is added again when it \
         is saved: no digits are lost"
    ));
    Ok(precise)
}

fn read_all(
    files: &[NamedBytes],
    reading: &mut Reading,
    progress: &mut Progress,
) -> Result<Import, ReadError> {
    let mut models = Vec::new();
    let mut libraries = Vec::new();
    let mut others = Vec::new();
    for file in files {
        if is_material_library(file) {
            libraries.push(file);
        } else if let Some(format) = Format::detect(file).filter(|format| format.can_read()) {
            models.push((file, format));
        } else {
            others.push(file);
        }
    }
    let Some((first, _)) = models.first() else {
        return Err(no_model(&libraries, &others));
    };
    let mut import = Import {
        name: first.stem().to_owned(),
        objects: Vec::new(),
        offset: DVec3::ZERO,
        materials: Materials::default(),
        report: ImportReport::default(),
    };
    let total: usize = models.iter().map(|(file, _)| file.bytes.len().max(1)).sum();
    let mut done = 0;
    for (file, format) in &models {
        let size = file.bytes.len().max(1);
        let mut part =
            |fraction: f32| progress((done as f32 + size as f32 * fraction.clamp(0.0, 1.0)) / total as f32);
        let (objects, materials, mut report) =
            read_one(file, *format, &libraries, files, reading, &mut part)?;
        for name in import.materials.add(materials) {
            report.warn(format!(
                "Material {name} is another one than that of an earlier file, whose settings are kept; faces keep \
                 their colours"
            ));
        }
        import.report.append(if models.len() > 1 { report.prefixed(&file.name) } else { report });
        import.objects.extend(objects);
        done += size;
    }
    // The data beside a glTF is not a model of its own.
    let has_gltf = models.iter().any(|(_, format)| *format == Format::Gltf);
    let base = |name: &str| name.rsplit(['/', '\\']).next().unwrap_or(name).to_lowercase();
    let images: HashSet<String> = import.materials.images.iter().map(|image| base(&image.name)).collect();
    for file in others {
        if images.contains(&base(&file.name)) {
            continue;
        }
        if has_gltf && file.name.to_ascii_lowercase().ends_with(".bin") {
            continue;
        }
        import.report.warn(format!("{} was left out: it is not a model that Meshwright can open", file.name));
    }
    Ok(import)
}

fn read_one(
    file: &NamedBytes,
    format: Format,
    libraries: &[&NamedBytes],
    files: &[NamedBytes],
    reading: &mut Reading,
    progress: &mut Progress,
) -> Result<(Vec<ImportedObject>, Materials, ImportReport), ReadError> {
    let one = |(object, notes)| (vec![object], notes);
    let mut materials = Materials::default();
    let (objects, notes) = match format {
        Format::Obj => {
            let (object, found, notes) = obj::read(file, libraries, files, reading, progress)?;
            materials = found;
            one((object, notes))
        }
        Format::Ply | Format::PlyText => one(ply::read(file, reading, progress)?),
        Format::Stl | Format::StlText => one(stl::read(file, reading, progress)?),
        Format::Off => one(off::read(file, reading, progress)?),
        Format::Collada => {
            let (objects, found, notes) = collada::read(file, files, reading, progress)?;
            materials = found;
            (objects, notes)
        }
        Format::Glb | Format::Gltf => gltf::read(file, files, reading, progress)?,
        Format::BezierCurve | Format::BezierSurface => one(bezier::read(file, format, progress)?),
        Format::Json => {
            return Err(ReadError::file(&file.name, "half-edge dumps can be written but not read"));
        }
    };
    let vertices = objects.iter().map(|object| object.mesh.vertex_count()).sum();
    let faces = objects.iter().map(|object| object.mesh.face_count()).sum();
    let mut report = ImportReport::default();
    let several = if objects.len() > 1 {
        format!(" in {}", counted(objects.len(), "object", "objects"))
    } else {
        String::new()
    };
    let what = match objects.as_slice() {
        [ImportedObject { controls: Some(controls), .. }] => described(controls),
        _ => format!(
            "{} and {}{several}",
            counted(vertices, "vertex", "vertices"),
            counted(faces, "face", "faces")
        ),
    };
    report.info(format!("Read {what} as {}", format.name()));
    if let Some(named) =
        Format::from_name(&file.name).filter(|named| named.extensions() != format.extensions())
    {
        report.info(format!(
            "The file is named .{} but holds {}: it was read as what it holds",
            named.extension(),
            format.name()
        ));
    }
    report.append(notes);
    Ok((objects, materials, report))
}

/// "a Bezier surface of 32 patches".
fn described(controls: &Controls) -> String {
    match controls {
        Controls::Curve(points) => {
            format!("a Bezier curve of {}", counted(points.len(), "control point", "control points"))
        }
        Controls::Surface(patches) => {
            format!("a Bezier surface of {}", counted(patches.len(), "patch", "patches"))
        }
    }
}

fn no_model(libraries: &[&NamedBytes], others: &[&NamedBytes]) -> ReadError {
    let readable: Vec<&str> = Format::ALL.iter().filter(|f| f.can_read()).map(|f| f.name()).collect();
    ReadError::NoModel(match (libraries, others) {
        ([], []) => "no file was given".to_owned(),
        ([library, ..], []) => {
            format!(
                "{} holds only materials: open it together with the OBJ model it belongs to",
                library.name
            )
        }
        (_, [other, ..]) => format!(
            "{} is not a model that Meshwright can open; it opens {}",
            other.name,
            readable.join(", ")
        ),
    })
}

/// The last step of every reader: the object of a soup, with the changes that made it a mesh noted.
pub(crate) fn build(
    name: &str,
    soup: PolygonSoup,
    file: &str,
    reading: &Reading,
    report: &mut ImportReport,
    progress: &mut Progress,
) -> Result<ImportedObject, ReadError> {
    if progress(0.0).is_break() {
        return Err(ReadError::Cancelled);
    }
    let kept = soup.clone();
    let mut notes = Vec::new();
    let mesh = repairs::build(soup, &reading.repairs, &mut notes)
        .map_err(|error| ReadError::file(file, error.to_string()))?;
    let soup = (!notes.is_empty()).then(|| Arc::new(kept));
    notes.into_iter().for_each(|note| report.warn(note));
    note_loose_vertices(&mesh, report);
    if progress(1.0).is_break() {
        return Err(ReadError::Cancelled);
    }
    Ok(ImportedObject { soup, ..ImportedObject::new(name, mesh) })
}

/// Says which vertices no face uses: they count as components, which puzzles who doesn't know of them.
fn note_loose_vertices(mesh: &Mesh, report: &mut ImportReport) {
    let mut loose = Places::default();
    mesh.vertices().filter(|&v| mesh.halfedge_from(v).is_none()).for_each(|v| loose.add(v.index()));
    if !loose.is_empty() {
        report.info(loose.sentence("vertex", "vertices", "in no face, kept as single points", "number"));
    }
}
