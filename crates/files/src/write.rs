//! Writing files so that a full disk destroys nothing.

use formats::NamedBytes;
use std::io;
use std::path::{Path, PathBuf};

/// Puts the files of a model on the disk: the first at this path, the others beside it. Existing files are replaced only
/// when every new one is written. A companion file of the model's own name, such as its material library, is replaced only
/// along with the model: without one, it belongs to something else. Returns what was left out, in words.
///
/// # Errors
/// A file can't be written, in words that name it. No file was replaced.
pub fn write(path: &Path, files: &[NamedBytes]) -> Result<Vec<String>, String> {
    let stem = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
    let is_new = !path.exists();
    let mut notes = Vec::new();
    let mut written = Unfinished(Vec::new());
    for (at, file) in files.iter().enumerate() {
        let place = if at == 0 { path.to_owned() } else { path.with_file_name(&file.name) };
        let failed = |error: io::Error| format!("{} can't be written: {error}", place.display());
        // Files that don't have the model's name, such as images, may belong to another model.
        let is_own = Path::new(&file.name).file_stem().is_some_and(|own| own.to_string_lossy() == stem);
        let is_other = at > 0 && (is_new || !is_own) && std::fs::read(&place).is_ok_and(|b| b != file.bytes);
        if is_other && is_own {
            return Err(format!(
                "{} exists but {} does not, so it belongs to something else and is not replaced. Nothing was written: choose \
                 another name for the output, or move that file away",
                place.display(),
                path.display()
            ));
        }
        if is_other {
            notes.push(format!("{}: not written: a different file with this name exists", place.display()));
            continue;
        }
        if let Some(folder) = place.parent().filter(|_| file.name.contains('/')) {
            std::fs::create_dir_all(folder).map_err(failed)?;
        }
        if place.is_dir() {
            return Err(failed(io::Error::from(io::ErrorKind::IsADirectory)));
        }
        let mut name = place.file_name().unwrap_or_default().to_owned();
        name.push(".part");
        let part = place.with_file_name(name);
        written.0.push((part.clone(), place.clone()));
        std::fs::write(&part, &file.bytes).map_err(failed)?;
    }
    written.finish()?;
    Ok(notes)
}

/// Files under temporary names, with the names that they get; removed if they don't.
struct Unfinished(Vec<(PathBuf, PathBuf)>);

impl Unfinished {
    fn finish(mut self) -> Result<(), String> {
        // Companion files first, so that the main file never refers to one that is missing.
        while let Some((part, place)) = self.0.pop() {
            if let Err(error) = std::fs::rename(&part, &place) {
                self.0.push((part, place.clone()));
                return Err(format!("{} can't be written: {error}", place.display()));
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
