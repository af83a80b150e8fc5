//! Reading: files in, one model out.

use crate::companions::is_companion;
use crate::error::ReadError;
use crate::file::{NamedBytes, base_name};
use crate::format::reading::{Contents, Reading, Source};
use crate::formats::Format;
use crate::model::{Model, NamedMesh};
use crate::report::{ImportReport, first_few};
use crate::room::Room;
use crate::soup::origin::{Bounds, Origin};
use crate::soup::repairs::Repairs;
use crate::text::encoding::{Encoding, decode, decode_utf16};
use glam::DVec3;
use halfedge::Progress;
use halfedge::words::counted;
use std::borrow::Cow;
use std::collections::HashSet;
use surface::bezier::Bezier;

/// What was read from files.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    /// The meshes and their materials.
    pub model: Model,
    /// What to tell the user.
    pub report: ImportReport,
}

/// How much of a file's beginning [`refusal`] looks at.
pub const HEAD_BYTES: u64 = 4096;

/// Why a file is too large to be opened, judged by its beginning and its size before it is read; none if it may fit.
pub fn refusal(room: &Room, head: &[u8], bytes: u64) -> Option<String> {
    room.refusal_of_bytes(bytes).or_else(|| room.refusal_of_corners(Format::corners_told_by(head, bytes)?))
}

/// Reads files that were given together: models with their companion files, such as material libraries
/// and images. Each model file adds its objects. The content tells the format, or else the extension.
///
/// `progress` receives fractions from 0 to 1 and may stop the work.
///
/// # Errors
/// When a file can't be read as a model at all, or none of them is one. A damaged file loads as far as it
/// can, and the report names the rest.
///
/// # Cost
/// Time and memory are linear in the size of the files.
pub fn read(files: &[NamedBytes], progress: &mut Progress) -> Result<Import, ReadError> {
    read_with(files, &Repairs::default(), progress)
}

/// [`read`] with choices in how faces that form no mesh are made one.
///
/// # Errors
/// As [`read`].
pub fn read_with(
    files: &[NamedBytes],
    repairs: &Repairs,
    progress: &mut Progress,
) -> Result<Import, ReadError> {
    read_within(files, repairs, &Room::default(), progress)
}

/// [`read_with`] of no more than there is room for.
///
/// # Errors
/// As [`read`].
pub fn read_within(
    files: &[NamedBytes],
    repairs: &Repairs,
    room: &Room,
    progress: &mut Progress,
) -> Result<Import, ReadError> {
    let mut reading = Reading { repairs: *repairs, room: *room, ..Reading::default() };
    let import = read_all(files, &mut reading, progress)?;
    let Some(offset) = Bounds::of(&import.model.objects).offset() else { return Ok(import) };
    // Far away: read again in double precision, and see that it loses no digits.
    let mut reading = Reading { origin: Some(Origin::new(offset)), corners: 0, ..reading };
    let mut precise = read_all(files, &mut reading, progress)?;
    if !reading.origin.is_some_and(|origin| Bounds::of(&precise.model.objects).is_worth(&origin)) {
        return Ok(import);
    }
    precise.model.offset = offset;
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
    let mut companions = Vec::new();
    for file in files {
        match Format::detect(file).filter(|format| format.can_read()) {
            Some(format) => models.push((file, format)),
            None => companions.push(file),
        }
    }
    let Some((first, _)) = models.first() else {
        return Err(no_model(&companions));
    };
    let mut model = Model { name: first.stem().to_owned(), ..Model::default() };
    let mut all_notes = ImportReport::default();
    let total: usize = models.iter().map(|(file, _)| file.bytes.len().max(1)).sum();
    let mut done = 0;
    for &(file, format) in &models {
        let size = file.bytes.len().max(1);
        let mut part =
            |fraction: f32| progress((done as f32 + size as f32 * fraction.clamp(0.0, 1.0)) / total as f32);
        let source = Source { file, files, companions: &companions };
        let Contents { objects, materials, mut report } = read_one(&source, format, reading, &mut part)?;
        for name in model.materials.add(materials) {
            report.warn(format!(
                "Material {name} differs from the one of that name in an earlier file, which is kept; faces keep \
                 their colours"
            ));
        }
        all_notes.append(if models.len() > 1 { report.prefixed(&file.name) } else { report });
        model.objects.extend(objects);
        done += size;
    }
    let images = model.materials.images.iter().map(|image| base_name(&image.name).to_lowercase());
    let images: HashSet<String> = images.collect();
    for file in companions {
        let is_used = images.contains(&base_name(&file.name).to_lowercase())
            || models.iter().any(|(_, format)| is_companion(file, *format));
        if !is_used {
            all_notes.warn(format!("{} was left out: it is not a model that Meshwright can open", file.name));
        }
    }
    let missing = model.materials.missing_images();
    if !missing.is_empty() {
        all_notes.info(format!(
            "Image files that its materials refer to were not given: {}",
            first_few(&missing, 6)
        ));
    }
    Ok(Import { model, report: all_notes })
}

fn read_one(
    source: &Source,
    format: Format,
    reading: &mut Reading,
    progress: &mut Progress,
) -> Result<Contents, ReadError> {
    if is_empty(source.file) {
        return Err(empty(source.file));
    }
    let NamedBytes { name, bytes } = source.file;
    if let Some(why) = refusal(&reading.room, bytes, bytes.len() as u64) {
        return Err(ReadError::file(name, why));
    }
    let (file, encoding) = in_utf8(source.file, format);
    let file = file.as_ref();
    let read = format.codec().read.ok_or_else(|| {
        ReadError::file(&file.name, format!("{} can be written but not read", format.name()))
    })?;
    let source = Source { file, ..*source };
    let Contents { objects, materials, report: notes } = read(&source, reading, progress)?;
    let mut report = ImportReport::default();
    report.info(format!("Read {} as {}", described(&objects), format.name()));
    if let Some(named) =
        Format::from_name(&file.name).filter(|named| named.extensions() != format.extensions())
    {
        report.info(format!(
            "The file is named .{} but holds {}: it was read as what it holds",
            named.extension(),
            format.name()
        ));
    }
    if encoding == Encoding::Latin1 {
        report.info(
            "The text of the file is neither UTF-8 nor UTF-16, so it was read as Latin-1 (Windows-1252): check names with \
             accents",
        );
    }
    report.append(notes);
    Ok(Contents { objects, materials, report })
}

/// A file as its format's reader is given it, text in UTF-8, and the encoding that it has.
fn in_utf8(file: &NamedBytes, format: Format) -> (Cow<'_, NamedBytes>, Encoding) {
    let is_text = format.info().is_text;
    let renamed = |text: String| Cow::Owned(NamedBytes::new(file.name.as_str(), text));
    if let Some(text) = decode_utf16(&file.bytes).filter(|text| is_text(text.as_bytes())) {
        return (renamed(text), Encoding::Utf16);
    }
    if is_text(&file.bytes)
        && let (Cow::Owned(text), encoding) = decode(&file.bytes)
    {
        return (renamed(text), encoding);
    }
    (Cow::Borrowed(file), Encoding::Utf8)
}

/// "8 vertices and 6 faces", "a Bezier surface of 32 patches".
fn described(objects: &[NamedMesh]) -> String {
    if let [NamedMesh { bezier: Some(bezier), .. }] = objects {
        return match bezier.as_ref() {
            Bezier::Curve(curve) => {
                format!(
                    "a Bezier curve of {}",
                    counted(curve.points.len(), "control point", "control points")
                )
            }
            Bezier::Surface(patches) => {
                format!("a Bezier surface of {}", counted(patches.len(), "patch", "patches"))
            }
        };
    }
    let vertices = objects.iter().map(|object| object.mesh.vertex_count()).sum();
    let faces = objects.iter().map(|object| object.mesh.face_count()).sum();
    let several = if objects.len() > 1 {
        format!(" in {}", counted(objects.len(), "object", "objects"))
    } else {
        String::new()
    };
    format!("{} and {}{several}", counted(vertices, "vertex", "vertices"), counted(faces, "face", "faces"))
}

/// Whether a file has no content at all.
fn is_empty(file: &NamedBytes) -> bool {
    file.bytes.iter().all(u8::is_ascii_whitespace)
}

fn empty(file: &NamedBytes) -> ReadError {
    ReadError::file(&file.name, "the file is empty")
}

fn no_model(files: &[&NamedBytes]) -> ReadError {
    let notes = |file: &&NamedBytes| {
        Format::all().find_map(|format| {
            format
                .info()
                .companion_extensions
                .iter()
                .find(|(extension, _)| file.has_extension(extension))
                .map(|(_, note)| *note)
        })
    };
    // A file that belongs to no format is named first.
    let unknown = files.iter().find(|file| notes(file).is_none());
    ReadError::NoModel(match (unknown, files.first()) {
        (None, None) => "No file was given.".to_owned(),
        (None, Some(file)) => format!("{} {}.", file.name, notes(file).unwrap_or_default()),
        (Some(file), _) if is_empty(file) => return empty(file),
        (Some(file), _) => {
            let readable: Vec<&str> =
                Format::all().filter(|format| format.can_read()).map(Format::name).collect();
            let (last, others) = readable.split_last().unwrap_or((&"no", &[]));
            let message = format!("it holds no model that Meshwright opens: {} or {last}", others.join(", "));
            return ReadError::file(&file.name, message);
        }
    })
}
