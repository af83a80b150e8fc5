//! Files in and out.

use crate::Failure;
use editor::Document;
use formats::{Controls, Format, Import, NamedBytes, ObjectRef};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// What was read, and how long it took.
pub struct Read {
    /// The meshes and the report.
    pub import: Import,
    /// Reading the file and understanding its text.
    pub read: Duration,
    /// Building the half-edge meshes.
    pub build: Duration,
}

/// Reads a model with the material libraries it names, if they lie where it says.
pub fn read(path: &Path) -> Result<Read, Failure> {
    let start = Instant::now();
    let model = read_bytes(path)?;
    let mut files = libraries(path, &model.bytes);
    files.insert(0, model);
    // Readers tell of half the work when the text is read and building begins.
    let mut parsed = Instant::now();
    let mut import = formats::read(&files, &mut |fraction| {
        if fraction <= 0.5 {
            parsed = Instant::now();
        }
        ControlFlow::Continue(())
    })
    .map_err(|error| Failure::File(error.to_string()))?;
    editor::show_controls(&mut import).map_err(|error| Failure::File(error.to_string()))?;
    Ok(Read { import, read: parsed - start, build: parsed.elapsed() })
}

fn read_bytes(path: &Path) -> Result<NamedBytes, Failure> {
    let bytes = std::fs::read(path)
        .map_err(|error| Failure::File(format!("{} can't be read: {error}", path.display())))?;
    Ok(NamedBytes { name: file_name(path), bytes })
}

fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}

/// The material libraries that an OBJ names and that are there. Those that are not are for the
/// reader's report to tell of.
fn libraries(path: &Path, bytes: &[u8]) -> Vec<NamedBytes> {
    if Format::from_name(&file_name(path)).is_some_and(|format| format != Format::Obj) {
        return Vec::new();
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    let mut found: Vec<NamedBytes> = Vec::new();
    for line in bytes.split(|&b| b == b'\n').filter(|line| line.starts_with(b"mtllib")) {
        let rest = String::from_utf8_lossy(line.get(6..).unwrap_or_default());
        // A name may have blanks in it, and a line may have several names.
        for name in std::iter::once(rest.trim()).chain(rest.split_whitespace()) {
            let named = |file: &NamedBytes| file.name == name;
            if name.is_empty() || found.iter().any(named) {
                continue;
            }
            let place: PathBuf = folder.join(name.replace('\\', "/"));
            if place.is_file()
                && let Ok(bytes) = std::fs::read(&place)
            {
                found.push(NamedBytes { name: name.to_owned(), bytes });
            }
        }
    }
    found
}

/// The format that an output name asks for.
pub fn output_format(path: &Path) -> Result<Format, Failure> {
    let known = || {
        let names: Vec<String> =
            Format::ALL.iter().filter(|f| f.can_write()).map(|f| format!(".{}", f.extension())).collect();
        names.join(", ")
    };
    match Format::from_name(&file_name(path)) {
        Some(format) if format.can_write() => Ok(format),
        _ => Err(Failure::Usage(format!(
            "{}: the extension tells no format to write; use one of {}",
            path.display(),
            known()
        ))),
    }
}

/// Writes a document, and says on standard error what the format can't hold.
pub fn write(path: &Path, format: Format, document: &Document) -> Result<(), Failure> {
    let controls: Vec<Option<Controls>> =
        document.objects().iter().map(|object| object.bezier().map(Controls::from)).collect();
    let objects: Vec<ObjectRef<'_>> = document
        .objects()
        .iter()
        .zip(&controls)
        .map(|(object, controls)| ObjectRef {
            controls: controls.as_ref(),
            ..ObjectRef::new(object.name(), object.mesh())
        })
        .collect();
    for loss in formats::losses(format, &objects) {
        eprintln!("{}: {loss}", path.display());
    }
    let stem = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let files = formats::write(format, &stem, &objects)
        .map_err(|error| Failure::File(format!("{}: {error}", path.display())))?;
    for (at, file) in files.iter().enumerate() {
        let place = if at == 0 { path.to_owned() } else { path.with_file_name(&file.name) };
        std::fs::write(&place, &file.bytes)
            .map_err(|error| Failure::File(format!("{} can't be written: {error}", place.display())))?;
    }
    Ok(())
}
