//! Reading and writing files.

use crate::Failure;
use editor::project::{Project, ReadProject};
use editor::{CommandError, Editor, Outcome};
use formats::{Format, Import, ImportReport, Model, NamedBytes, Repairs};
use std::borrow::Cow;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
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
    let model = read_bytes(path)?;
    if Project::is_file(&model) {
        let read = Project::open_file(&model).map_err(Failure::File)?;
        let contents = Contents::Project(Box::new(read));
        return Ok(Read { contents, read: start.elapsed(), build: Duration::ZERO });
    }
    let mut files = companions(path, &model);
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

fn read_bytes(path: &Path) -> Result<NamedBytes, Failure> {
    let bytes = std::fs::read(path)
        .map_err(|error| Failure::File(format!("{} can't be read: {error}", path.display())))?;
    Ok(NamedBytes { name: file_name(path), bytes })
}

fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}

/// The companion files of a model that exist, and theirs, such as the images that material libraries
/// name. The import report names the missing ones.
fn companions(path: &Path, model: &NamedBytes) -> Vec<NamedBytes> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let of = |folder: &Path, file: &NamedBytes| -> Vec<NamedBytes> {
        let there = |name: String| {
            let place = folder.join(&name);
            let bytes = place.is_file().then(|| std::fs::read(&place).ok())??;
            Some(NamedBytes { name, bytes })
        };
        formats::companions(file).into_iter().filter_map(there).collect()
    };
    let mut files = of(folder, model);
    for at in 0..files.len() {
        let Some(file) = files.get(at) else { continue };
        let place = folder.join(&file.name);
        let more = of(place.parent().unwrap_or(folder), file);
        for file in more {
            if files.iter().all(|known| known.name != file.name) {
                files.push(file);
            }
        }
    }
    files
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
    match Format::from_name(&file_name(path)) {
        Some(format) if format.can_save() => Ok(format),
        _ => Err(Failure::Usage(format!(
            "{}: the extension names no format that can be written; use one of {}",
            path.display(),
            known()
        ))),
    }
}

/// Writes an editor's document, and prints on standard error what the format can't hold. Existing files are replaced only when
/// every new one is written: a full disk destroys nothing. A companion file of the model's own name, such as its material
/// library, is replaced only along with the model: without one, it belongs to something else.
pub fn write(path: &Path, format: Format, editor: &Editor) -> Result<(), Failure> {
    let document = editor.document();
    let stem = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    if format.is_project() {
        return put(path, &stem, vec![Project::of(editor).named(&stem).file()]);
    }
    let mut model = document.to_model(document.name());
    // Names are compared with that of the document: the output file may have any other.
    for loss in formats::losses(format, &model) {
        eprintln!("{}: {loss}", path.display());
    }
    model.name.clone_from(&stem);
    let files = formats::write(format, &model)
        .map_err(|error| Failure::File(format!("{}: {error}", path.display())))?;
    put(path, &stem, files)
}

/// Puts files on the disk, the first of them at this path and the others beside it.
fn put(path: &Path, stem: &str, files: Vec<NamedBytes>) -> Result<(), Failure> {
    let is_new = !path.exists();
    let mut written = Unfinished(Vec::new());
    for (at, file) in files.iter().enumerate() {
        let place = if at == 0 { path.to_owned() } else { path.with_file_name(&file.name) };
        let failed =
            |error: std::io::Error| Failure::File(format!("{} can't be written: {error}", place.display()));
        // Files that don't have the model's name, such as images, may belong to another model.
        let is_own = Path::new(&file.name).file_stem().is_some_and(|own| own.to_string_lossy() == stem);
        let is_other = at > 0 && (is_new || !is_own) && std::fs::read(&place).is_ok_and(|b| b != file.bytes);
        if is_other && is_own {
            return Err(Failure::File(format!(
                "{} exists but {} does not, so it belongs to something else and is not replaced. Nothing was written: choose \
                 another name for the output, or move that file away",
                place.display(),
                path.display()
            )));
        }
        if is_other {
            eprintln!("{}: not written: a different file with this name exists", place.display());
            continue;
        }
        if let Some(folder) = place.parent().filter(|_| file.name.contains('/')) {
            std::fs::create_dir_all(folder).map_err(failed)?;
        }
        if place.is_dir() {
            return Err(failed(std::io::Error::from(std::io::ErrorKind::IsADirectory)));
        }
        let mut name = place.file_name().unwrap_or_default().to_owned();
        name.push(".part");
        let part = place.with_file_name(name);
        written.0.push((part.clone(), place.clone()));
        std::fs::write(&part, &file.bytes).map_err(failed)?;
    }
    written.finish()
}

/// Files under temporary names, with the names that they get; removed if they don't.
struct Unfinished(Vec<(PathBuf, PathBuf)>);

impl Unfinished {
    fn finish(mut self) -> Result<(), Failure> {
        // Companion files first, so that the main file never refers to one that is missing.
        while let Some((part, place)) = self.0.pop() {
            if let Err(error) = std::fs::rename(&part, &place) {
                self.0.push((part, place.clone()));
                return Err(Failure::File(format!("{} can't be written: {error}", place.display())));
            }
        }
        Ok(())
    }
}

impl Drop for Unfinished {
    fn drop(&mut self) {
        for (part, _) in &self.0 {
            // It may not exist; there is nothing more to do about one that can't be removed.
            let _ = std::fs::remove_file(part);
        }
    }
}
