//! Why nothing was read or written.

use crate::file::NamedBytes;
use halfedge::words::sentence;
use std::fmt;

/// Why nothing was read. Displays as sentences for the user.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ReadError {
    /// The progress callback asked to stop.
    Cancelled,
    /// No given file is a model.
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

    /// Nothing in a file can be read, because of its first fault.
    pub(crate) fn nothing(file: &NamedBytes, fault: &str) -> Self {
        Self::file(&file.name, format!("nothing in it can be read. The first fault: {fault}"))
    }
}

/// That a file is not a model of its format, why, and what to do.
pub(crate) fn not_a(format: &str, why: &str) -> String {
    format!(
        "it is not {format} file: {why}. It holds nothing else that Meshwright opens either. Check that it is the right \
         file, or export the model again"
    )
}

impl fmt::Display for ReadError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cancelled => f.write_str("Opening the file was cancelled."),
            Self::NoModel(message) => f.write_str(message),
            Self::File { file, message } => write!(f, "Could not open {file}. {}", sentence(message)),
        }
    }
}

impl std::error::Error for ReadError {}

/// Why nothing was written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WriteError {
    /// What is wrong and what to do.
    pub message: String,
}

impl WriteError {
    pub(crate) fn new(message: impl Into<String>) -> Self {
        Self { message: message.into() }
    }
}

impl fmt::Display for WriteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for WriteError {}
