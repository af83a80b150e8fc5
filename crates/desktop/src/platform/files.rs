//! The user's files: the system's dialogs, reading and writing. All of it waits in threads.

use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

use meshwright_web::platform::{Event, Fetched, NamedBytes, Placed, Source};
use rfd::AsyncFileDialog;

use super::inbox::Inbox;

/// Opens and saves files for the user.
#[derive(Clone)]
pub struct Files {
    inbox: Inbox,
    /// The files that were opened or saved, by their numbers.
    known: Arc<Mutex<Vec<PathBuf>>>,
}

impl Files {
    pub fn new(inbox: Inbox) -> Self {
        Self { inbox, known: Arc::default() }
    }

    /// Asks for files and opens them together.
    pub fn ask_what_to_open(&self) {
        // Some systems show dialogs only from the thread of the window; waiting is fine in any.
        let picked = AsyncFileDialog::new().set_title("Open files").pick_files();
        let this = self.clone();
        thread::spawn(move || {
            let picked = pollster::block_on(picked).unwrap_or_default();
            this.open_now(&picked.iter().map(|file| file.path().to_owned()).collect::<Vec<_>>());
        });
    }

    /// Reads files and opens them together.
    pub fn open(&self, paths: Vec<PathBuf>) {
        let this = self.clone();
        thread::spawn(move || this.open_now(&paths));
    }

    /// Reads the files that the program was started with, and ends the job that waits for them: as the files of a document
    /// that can be saved where it came from.
    pub fn fetch(&self, job: u64, paths: Vec<PathBuf>) {
        let this = self.clone();
        thread::spawn(move || {
            let source = this.source(&paths);
            let files = read_all(&paths).map(|files| Fetched { files, source, notes: Vec::new() });
            this.inbox.push(Event::Fetched { job, files: files.map_err(|problem| format!("{problem}.")) });
        });
    }

    /// Asks where to save the files of a model, whose names are suggestions, and writes them.
    pub fn ask_where_to_save(&self, files: Vec<NamedBytes>) {
        let name = files.first().map_or("", |model| model.name.as_str());
        let picked = AsyncFileDialog::new().set_title("Save").set_file_name(name).save_file();
        let this = self.clone();
        thread::spawn(move || {
            let placed =
                pollster::block_on(picked).map(|picked| this.place(picked.path().to_owned(), &files));
            this.inbox.push(Event::Placed(placed));
        });
    }

    /// Writes the files of a model to where it was opened or saved.
    pub fn write_back(&self, source: Source, files: Vec<NamedBytes>) {
        let this = self.clone();
        thread::spawn(move || {
            let result = match this.path(source) {
                Some(path) => files::write(&path, &files),
                None => Err("its place is not known".to_owned()),
            };
            let files = files.into_iter().map(|file| file.name).collect();
            this.inbox.push(Event::Written { files, result: result.map(drop) });
        });
    }

    /// Whether files of a source can be written.
    pub fn is_known(&self, source: Source) -> bool {
        self.path(source).is_some()
    }

    /// The path of a source, to find it again in a later run.
    pub fn path(&self, source: Source) -> Option<PathBuf> {
        let known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        known.get(source as usize).cloned()
    }

    /// The source of a file by its path.
    pub fn number(&self, path: PathBuf) -> Source {
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        let at = known.iter().position(|other| *other == path).unwrap_or_else(|| {
            known.push(path);
            known.len() - 1
        });
        Source::try_from(at).unwrap_or(Source::MAX)
    }

    fn open_now(&self, paths: &[PathBuf]) {
        match read_all(paths) {
            Ok(files) if files.is_empty() => {}
            Ok(files) => self.inbox.push(match self.source(paths) {
                Some(source) => Event::FilesOf(source, files),
                None => Event::Files(files),
            }),
            Err(problem) => self.inbox.push(Event::Failed(format!("{problem}."))),
        }
    }

    fn place(&self, path: PathBuf, files: &[NamedBytes]) -> Result<Placed, String> {
        let notes = files::write(&path, files).map_err(|problem| format!("{problem}."))?;
        let mut names: Vec<String> = files.iter().map(|file| file.name.clone()).collect();
        if let (Some(first), Some(name)) = (names.first_mut(), path.file_name()) {
            *first = name.to_string_lossy().into_owned();
        }
        let notes = notes.into_iter().map(|note| format!("{note}.")).collect();
        Ok(Placed { source: self.number(path), names, notes })
    }

    /// Where a document of these files can be saved: the place of the only model among them.
    fn source(&self, paths: &[PathBuf]) -> Option<Source> {
        match paths {
            [path] => Some(self.number(path.clone())),
            _ => None,
        }
    }
}

/// Reads files with their companion files. A companion that was named too comes once.
fn read_all(paths: &[PathBuf]) -> Result<Vec<NamedBytes>, String> {
    let mut all: Vec<NamedBytes> = Vec::new();
    for path in paths {
        for file in files::read(path)? {
            if !all.contains(&file) {
                all.push(file);
            }
        }
    }
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::time::{Duration, Instant};

    fn next(files: &Files) -> Event {
        let start = Instant::now();
        loop {
            if let Some(event) = files.inbox.take().pop() {
                return event;
            }
            assert!(start.elapsed() < Duration::from_secs(60), "nothing happened");
            thread::sleep(Duration::from_millis(2));
        }
    }

    #[test]
    fn a_model_that_was_opened_is_saved_to_its_file_with_its_companions_beside_it() {
        let folder = tempfile::tempdir().expect("a folder");
        let at = |name: &str| folder.path().join(name);
        std::fs::write(at("a.obj"), "mtllib a.mtl\nv 0 0 0\n").expect("room");
        std::fs::write(at("a.mtl"), "newmtl red\n").expect("room");
        let files = Files::new(Inbox::new(&egui::Context::default()));
        files.open(vec![at("a.obj")]);
        let Event::FilesOf(source, read) = next(&files) else { panic!("one model") };
        assert_eq!(read.iter().map(|file| file.name.as_str()).collect::<Vec<_>>(), ["a.obj", "a.mtl"]);
        assert!(files.is_known(source) && !files.is_known(source + 1));

        let new = [("a.obj", "v 1 1 1\n"), ("a.mtl", "newmtl blue\n")];
        files.write_back(source, new.map(|(name, text)| NamedBytes::new(name, text)).into());
        let Event::Written { files: names, result: Ok(()) } = next(&files) else { panic!("there is room") };
        assert_eq!(names, ["a.obj", "a.mtl"]);
        for (name, text) in new {
            assert_eq!(std::fs::read_to_string(at(name)).expect("a file"), text);
        }
    }

    #[test]
    fn a_place_that_the_user_chose_names_the_model_and_can_be_written_again() {
        let folder = tempfile::tempdir().expect("a folder");
        let files = Files::new(Inbox::new(&egui::Context::default()));
        let path = folder.path().join("mug.obj");
        let model = |text: &str| vec![NamedBytes::new("untitled.obj", text)];
        let placed = files.place(path.clone(), &model("v 0 0 0\n")).expect("there is room");
        assert_eq!((placed.names, placed.notes), (vec!["mug.obj".to_owned()], vec![]));
        files.write_back(placed.source, model("v 2 2 2\n"));
        assert!(matches!(next(&files), Event::Written { result: Ok(()), .. }));
        assert_eq!(std::fs::read_to_string(path).expect("a file"), "v 2 2 2\n");
    }

    #[test]
    fn files_that_cant_be_read_or_written_are_named() {
        let folder = tempfile::tempdir().expect("a folder");
        let files = Files::new(Inbox::new(&egui::Context::default()));
        files.open(vec![folder.path().join("gone.obj")]);
        let Event::Failed(problem) = next(&files) else { panic!("there is no such file") };
        assert!(problem.contains("gone.obj can't be read: "), "{problem}");
        files.fetch(7, vec![folder.path().join("gone.obj")]);
        let Event::Fetched { job: 7, files: Err(problem) } = next(&files) else { panic!("no such file") };
        assert!(problem.contains("gone.obj can't be read: "), "{problem}");

        let place = folder.path().join("no folder").join("a.obj");
        let problem =
            files.place(place, &[NamedBytes::new("a.obj", "v 0 0 0\n")]).expect_err("no such folder");
        assert!(problem.contains("a.obj can't be written: "), "{problem}");
    }

    #[test]
    fn several_models_have_no_file_of_their_own() {
        let folder = tempfile::tempdir().expect("a folder");
        let paths: Vec<PathBuf> = ["a.obj", "b.obj"].map(|name| folder.path().join(name)).into();
        for path in &paths {
            std::fs::write(path, "v 0 0 0\n").expect("room");
        }
        let files = Files::new(Inbox::new(&egui::Context::default()));
        files.open(paths);
        assert!(matches!(next(&files), Event::Files(read) if read.len() == 2));
    }
}
