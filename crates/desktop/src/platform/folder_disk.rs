//! A folder of the user's disk, for the store of documents.

use std::collections::HashMap;
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Read, Seek, SeekFrom, Write};
use std::path::PathBuf;

use meshwright_web::platform::store::{Disk, Failure, FileLength};

/// The folder with a file for each document that is open in a window, beside the documents' own folders.
const LOCKS: &str = "locks";
const DOCUMENTS: &str = "documents";

/// A folder with the documents' folders.
pub struct FolderDisk {
    root: PathBuf,
    /// The files that this window has locked. The system ends the locks with the program.
    locks: HashMap<String, File>,
}

impl FolderDisk {
    pub fn new(root: PathBuf) -> Self {
        Self { root, locks: HashMap::new() }
    }

    fn folder(&self, folder: &str) -> PathBuf {
        self.root.join(DOCUMENTS).join(folder)
    }

    fn path(&self, folder: &str, file: &str) -> PathBuf {
        self.folder(folder).join(file)
    }

    fn lock_file(&self, folder: &str) -> io::Result<File> {
        let locks = self.root.join(LOCKS);
        fs::create_dir_all(&locks)?;
        OpenOptions::new().create(true).truncate(false).write(true).open(locks.join(folder))
    }
}

#[expect(clippy::needless_pass_by_value, reason = "it is passed to `map_err`")]
fn failure(error: io::Error) -> Failure {
    match error.kind() {
        ErrorKind::NotFound => Failure::Missing,
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => Failure::Full,
        ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => Failure::Denied,
        _ => Failure::Other(error.to_string()),
    }
}

/// That something isn't there is no failure.
fn unless_missing<T: Default>(result: io::Result<T>) -> Result<T, Failure> {
    match result {
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(T::default()),
        other => other.map_err(failure),
    }
}

/// The names and lengths of what a folder holds.
fn entries(folder: &PathBuf) -> io::Result<Vec<(String, fs::Metadata)>> {
    let entries = fs::read_dir(folder)?;
    entries
        .map(|entry| {
            entry.and_then(|entry| Ok((entry.file_name().to_string_lossy().into_owned(), entry.metadata()?)))
        })
        .collect()
}

impl Disk for FolderDisk {
    async fn folders(&mut self) -> Result<Vec<String>, Failure> {
        let mut found = unless_missing(entries(&self.root.join(DOCUMENTS)))?;
        found.retain(|(_, metadata)| metadata.is_dir());
        Ok(found.into_iter().map(|(name, _)| name).collect())
    }

    async fn files(&mut self, folder: &str) -> Result<Vec<FileLength>, Failure> {
        let found = unless_missing(entries(&self.folder(folder)))?;
        Ok(found.into_iter().map(|(name, metadata)| FileLength { name, bytes: metadata.len() }).collect())
    }

    async fn append(&mut self, folder: &str, file: &str, bytes: &[u8]) -> Result<(), Failure> {
        let write = || {
            fs::create_dir_all(self.folder(folder))?;
            let mut out = OpenOptions::new().create(true).append(true).open(self.path(folder, file))?;
            let before = out.metadata()?.len();
            // What was written outlives a loss of power.
            let written = out.write_all(bytes).and_then(|()| out.sync_data());
            if written.is_err() {
                // A part of it would only take room. Whoever reads the file leaves it out if this fails too.
                let _ = out.set_len(before);
            }
            written
        };
        write().map_err(failure)
    }

    async fn read(&mut self, folder: &str, file: &str, at: u64, len: usize) -> Result<Vec<u8>, Failure> {
        let read = || {
            let mut from = File::open(self.path(folder, file))?;
            from.seek(SeekFrom::Start(at))?;
            let mut bytes = Vec::new();
            from.take(len as u64).read_to_end(&mut bytes)?;
            Ok(bytes)
        };
        read().map_err(failure)
    }

    async fn truncate(&mut self, folder: &str, file: &str, bytes: u64) -> Result<(), Failure> {
        let cut = || {
            let file = OpenOptions::new().write(true).open(self.path(folder, file))?;
            file.set_len(bytes)?;
            file.sync_data()
        };
        cut().map_err(failure)
    }

    async fn remove(&mut self, folder: &str, file: &str) -> Result<(), Failure> {
        unless_missing(fs::remove_file(self.path(folder, file)))
    }

    async fn remove_folder(&mut self, folder: &str) -> Result<(), Failure> {
        unless_missing(fs::remove_dir_all(self.folder(folder)))?;
        unless_missing(fs::remove_file(self.root.join(LOCKS).join(folder)))
    }

    async fn lock(&mut self, folder: &str) -> bool {
        if self.locks.contains_key(folder) {
            return true;
        }
        match self.lock_file(folder) {
            Ok(file) if file.try_lock().is_ok() => {
                self.locks.insert(folder.to_owned(), file);
                true
            }
            Ok(_) => false,
            // A disk without locks, or one that can't be written.
            Err(_) => true,
        }
    }

    async fn unlock(&mut self, folder: &str) {
        self.locks.remove(folder);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use meshwright_web::platform::store::now_or_never;

    fn now<T>(future: impl Future<Output = T>) -> T {
        now_or_never(future).expect("it never waits")
    }

    #[test]
    fn files_are_appended_read_cut_and_removed() {
        let root = tempfile::tempdir().expect("a folder");
        let mut disk = FolderDisk::new(root.path().join("new"));
        assert_eq!(now(disk.folders()), Ok(vec![]));
        assert_eq!(now(disk.files("a")), Ok(vec![]));
        assert_eq!(now(disk.read("a", "log", 0, 5)), Err(Failure::Missing));
        now(disk.append("a", "log", b"abc")).expect("room");
        now(disk.append("a", "log", b"defg")).expect("room");
        assert_eq!(now(disk.folders()), Ok(vec!["a".to_owned()]));
        assert_eq!(now(disk.files("a")), Ok(vec![FileLength { name: "log".to_owned(), bytes: 7 }]));
        assert_eq!(now(disk.read("a", "log", 2, 3)), Ok(b"cde".to_vec()));
        assert_eq!(now(disk.read("a", "log", 5, 9)), Ok(b"fg".to_vec()));
        now(disk.truncate("a", "log", 4)).expect("there");
        assert_eq!(now(disk.read("a", "log", 0, 9)), Ok(b"abcd".to_vec()));
        now(disk.remove("a", "log")).expect("there");
        now(disk.remove("a", "log")).expect("gone, which is no failure");
        now(disk.remove_folder("a")).expect("there");
        assert_eq!(now(disk.folders()), Ok(vec![]));
    }

    #[test]
    fn one_window_at_a_time_locks_a_folder() {
        let root = tempfile::tempdir().expect("a folder");
        let mut first = FolderDisk::new(root.path().to_owned());
        let mut second = FolderDisk::new(root.path().to_owned());
        assert!(now(first.lock("a")) && now(first.lock("a")));
        assert!(!now(second.lock("a")) && now(second.lock("b")));
        now(first.unlock("a"));
        assert!(now(second.lock("a")));
        drop(second);
        assert!(now(first.lock("b")));
        assert_eq!(now(first.folders()), Ok(vec![]), "locks are no documents");
    }
}
