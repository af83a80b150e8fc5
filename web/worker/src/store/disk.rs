//! What the store needs of a place that keeps files.

use serde::{Deserialize, Serialize};
use std::fmt;

/// Why something could not be read or written.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Failure {
    /// There is no more room.
    Full,
    /// Nothing may be stored, as in some private windows.
    Denied,
    /// The file does not exist.
    Missing,
    /// Something else, in the browser's words.
    Other(String),
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Full => f.write_str("the storage has no more room"),
            Self::Denied => f.write_str("the storage may not be written, as in some private windows"),
            Self::Missing => f.write_str("the document was removed from the storage"),
            Self::Other(reason) => write!(f, "the storage reports “{}”", reason.trim_end_matches('.')),
        }
    }
}

/// A file in a folder.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileLength {
    /// Its name.
    pub name: String,
    /// Its length in bytes.
    pub bytes: u64,
}

/// Folders with files. What was written is on the disk when the call returns; a crash may leave any beginning of it there.
#[expect(async_fn_in_trait, reason = "everything runs on one thread")]
pub trait Disk {
    /// The names of the folders.
    ///
    /// # Errors
    /// The disk can't be read.
    async fn folders(&mut self) -> Result<Vec<String>, Failure>;

    /// The files in a folder; none if it doesn't exist.
    ///
    /// # Errors
    /// The disk can't be read.
    async fn files(&mut self, folder: &str) -> Result<Vec<FileLength>, Failure>;

    /// Adds bytes to the end of a file, which it creates.
    ///
    /// # Errors
    /// Not all could be written. Without room the file is as it was; after other failures it may end with a beginning of
    /// the bytes.
    async fn append(&mut self, folder: &str, file: &str, bytes: &[u8]) -> Result<(), Failure>;

    /// At most so many bytes of a file from here on; fewer only at its end.
    ///
    /// # Errors
    /// The file can't be read.
    async fn read(&mut self, folder: &str, file: &str, at: u64, len: usize) -> Result<Vec<u8>, Failure>;

    /// Cuts a file off after so many bytes.
    ///
    /// # Errors
    /// The file can't be changed.
    async fn truncate(&mut self, folder: &str, file: &str, bytes: u64) -> Result<(), Failure>;

    /// Removes a file, if it exists.
    ///
    /// # Errors
    /// The file can't be removed.
    async fn remove(&mut self, folder: &str, file: &str) -> Result<(), Failure>;

    /// Removes a folder with its files, if it exists.
    ///
    /// # Errors
    /// The folder can't be removed.
    async fn remove_folder(&mut self, folder: &str) -> Result<(), Failure>;

    /// Locks a folder for this tab; returns whether no other tab has locked it. The lock ends with the tab. Only the tab
    /// that has locked a folder writes in it.
    async fn lock(&mut self, folder: &str) -> bool;

    /// Unlocks a folder.
    async fn unlock(&mut self, folder: &str);

    /// Whether a folder that can be locked is one that no other tab shows.
    fn has_locks(&self) -> bool {
        true
    }
}
