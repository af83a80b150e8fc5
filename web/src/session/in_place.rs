//! What is known of the file that the document was opened from, if that can be written again; `saving.rs` acts on it.

use std::collections::VecDeque;

use editor::{JobId, Origin};

use crate::platform::PlacedFile;

/// The file that the document was opened from, and what is being done with it.
#[derive(Debug, Default)]
pub(crate) struct InPlace {
    /// The file that a job opens.
    pub opening: Option<(JobId, PlacedFile)>,
    /// The file of the document that came from there.
    pub file: Option<(Origin, PlacedFile)>,
    /// The job that writes the document's bytes.
    pub writing: Option<JobId>,
    /// The documents that the platform asks the user to place, in order, with the revisions that count as saved then.
    pub asking: VecDeque<(Origin, Option<u64>)>,
    /// The files that are being written, in order: of which document, and the revision that counts as saved once the bytes
    /// are in them, if they then hold everything.
    pub written: VecDeque<(Origin, Option<u64>)>,
}
