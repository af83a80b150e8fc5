//! What is known of the file that the document was opened from, if that can be written again; `saving.rs` acts on it.

use std::collections::VecDeque;

use editor::{JobId, Origin};
use formats::Format;

use crate::platform::Source;

/// The file that the document was opened from, and what is being done with it.
#[derive(Debug, Default)]
pub(crate) struct InPlace {
    /// The file that a job opens.
    pub opening: Option<(JobId, File)>,
    /// The file of the document that came from there.
    pub file: Option<(Origin, File)>,
    /// The job that writes the document's bytes.
    pub writing: Option<JobId>,
    /// The documents that the platform asks the user to place, in order, with the revisions that count as saved then.
    pub asking: VecDeque<(Origin, Option<u64>)>,
    /// The files that are being written, in order: of which document, and the revision that counts as saved once the bytes
    /// are in them, if they then hold everything.
    pub written: VecDeque<(Origin, Option<u64>)>,
}

/// A file on the user's disk that can be written again.
#[derive(Clone, Debug)]
pub(crate) struct File {
    pub source: Source,
    pub name: String,
    pub format: Format,
}

impl File {
    /// A file of a source; none if a document can't be saved in its format.
    pub fn new(source: Source, name: &str, format: Option<Format>) -> Option<Self> {
        let format = format.filter(|format| format.can_open() && format.can_save())?;
        Some(Self { source, name: name.to_owned(), format })
    }
}
