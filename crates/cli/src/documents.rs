//! Reading and writing documents.

use crate::Failure;
use editor::project::{Project, ReadProject};
use editor::{CommandError, Editor, Outcome};
use formats::{Format, Import, ImportReport, Model, NamedBytes, Repairs};
use std::borrow::Cow;
use std::ops::ControlFlow;
use std::path::Path;
use std::time::{Duration, Instant};

/// A file that was read, and the time it took.
pub struct Read {
    /// What was read.
    pub contents: Contents,
    /// The time for reading and parsing the file.
    pub read: Duration,
    /// The time for building the half-edge meshes.
    pub build: Duration,
}

/// What a file holds.
pub enum Contents {
    /// A model.
    Import(Import),
    /// A document.
    Project(Box<ReadProject>),
}

impl Contents {
    /// What to tell about reading it.
    pub fn report(&self) -> &ImportReport {
        match self {
            Self::Import(import) => &import.report,
            Self::Project(read) => &read.report,
        }
    }

    /// The meshes and materials.
    pub fn model(&self) -> Cow<'_, Model> {
        match self {
            Self::Import(import) => Cow::Borrowed(&import.model),
            Self::Project(read) => {
                let document = read.project.document();
                Cow::Owned(document.to_model(document.name()))
            }
        }
    }

    /// Opens it in an editor.
    pub fn open_in(self, editor: &mut Editor) -> Result<Outcome, CommandError> {
        match self {
            Self::Import(import) => editor.open(import),
            Self::Project(read) => Ok(editor.open_project(*read)),
        }
    }
}

/// Reads a project, or a model with its companion files, as far as they exist.
pub fn read(path: &Path, repairs: &Repairs) -> Result<Read, Failure> {
    let start = Instant::now();
    let model = files::read_bytes(path).map_err(Failure::File)?;
    if Project::is_file(&model) {
        let read = Project::open_file(&model).map_err(Failure::File)?;
        let contents = Contents::Project(Box::new(read));
        return Ok(Read { contents, read: start.elapsed(), build: Duration::ZERO });
    }
    let mut files = files::companions(path, &model);
    files.insert(0, model);
    // Readers report half the progress when parsing ends and building begins.
    let mut parsed = Instant::now();
    let mut import = formats::read_with(&files, repairs, &mut |fraction| {
        if fraction <= 0.5 {
            parsed = Instant::now();
        }
        ControlFlow::Continue(())
    })
    .map_err(|error| Failure::File(error.to_string()))?;
    editor::show_controls(&mut import).map_err(|error| Failure::File(error.to_string()))?;
    Ok(Read { contents: Contents::Import(import), read: parsed - start, build: parsed.elapsed() })
}

/// The format to save in: the given one, or else that of the output file's extension.
pub fn output_format(path: &Path, given: Option<Format>) -> Result<Format, Failure> {
    if let Some(format) = given {
        return Ok(format);
    }
    let known = || {
        let formats = Format::all().filter(|format| format.can_save());
        let mut names: Vec<String> = formats.map(|format| format!(".{}", format.extension())).collect();
        // The text and binary forms of a format follow each other and share an extension.
        names.dedup();
        names.join(", ")
    };
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    match Format::from_name(&name) {
        Some(format) if format.can_save() => Ok(format),
        _ => Err(Failure::Usage(format!(
            "{}: the extension names no format that can be written; use one of {}",
            path.display(),
            known()
        ))),
    }
}

/// Writes an editor's document, and prints on standard error what the format can't hold.
pub fn write(path: &Path, format: Format, editor: &Editor) -> Result<(), Failure> {
    let document = editor.document();
    let stem = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    if format.is_project() {
        return put(path, &[Project::of(editor).named(&stem).file()]);
    }
    let mut model = document.to_model(document.name());
    // Names are compared with that of the document: the output file may have any other.
    for loss in formats::losses(format, &model) {
        eprintln!("{}: {loss}", path.display());
    }
    model.name.clone_from(&stem);
    let files = formats::write(format, &model)
        .map_err(|error| Failure::File(format!("{}: {error}", path.display())))?;
    put(path, &files)
}

fn put(path: &Path, files: &[NamedBytes]) -> Result<(), Failure> {
    for note in files::write(path, files).map_err(Failure::File)? {
        eprintln!("{note}");
    }
    Ok(())
}
