//! How the document became what it is: an earlier document, and what was done since. Project files hold it as the history.
//!
//! It is limited, in bytes and in the work of repeating it; when half of it is full, the document is noted as a later start,
//! which takes the place of the earlier one when all of it is full.

use crate::editor::Editor;
use crate::ops::{Action, Command, Commit};
use crate::recovery::{Entry, Event, Numbers, Snapshot, append_record, new_log};
use crate::selection::Selection;
use std::sync::Arc;

/// Larger documents are not kept as a start: the next edit would have to copy their meshes.
const MAX_START_BYTES: usize = 16 << 20;

/// The longest trail in bytes, in entries, and in faces read or written by commands that are jobs.
const MAX_BYTES: usize = 2 << 20;
const MAX_ENTRIES: usize = 2000;
const MAX_JOB_FACES: usize = 200_000;

/// An earlier document and what was done since.
#[derive(Clone, Debug)]
pub(crate) struct Trail {
    /// None if the document is too large, or if it changed since in a way that can't be repeated.
    start: Option<Arc<Snapshot>>,
    /// A log, as [`crate::recovery`] keeps it.
    log: Vec<u8>,
    length: Length,
    /// Steps below this number were made before the start.
    first_step: u64,
    /// A later start, and how long the trail was there.
    later: Option<(Arc<Snapshot>, u64, Length)>,
}

/// How long a trail is.
#[derive(Clone, Copy, Debug, Default)]
struct Length {
    bytes: usize,
    entries: usize,
    job_faces: usize,
}

impl Length {
    fn exceeds(self, parts: usize) -> bool {
        self.bytes > MAX_BYTES / parts
            || self.entries > MAX_ENTRIES / parts
            || self.job_faces > MAX_JOB_FACES / parts
    }

    fn since(self, earlier: Self) -> Self {
        Self {
            bytes: self.bytes - earlier.bytes,
            entries: self.entries - earlier.entries,
            job_faces: self.job_faces - earlier.job_faces,
        }
    }
}

impl Trail {
    /// A trail that leads nowhere.
    pub fn unknown() -> Self {
        Self::from(None, 0)
    }

    /// A trail that begins with a document.
    pub fn from(start: Option<Snapshot>, first_step: u64) -> Self {
        let start = start.map(Arc::new);
        Self { start, log: new_log(), length: Length::default(), first_step, later: None }
    }

    /// The start and the log of what was done since; none if nothing was, or if it is not known.
    pub fn contents(&self) -> Option<(&Arc<Snapshot>, &[u8])> {
        self.start.as_ref().filter(|_| self.length.entries > 0).map(|start| (start, self.log.as_slice()))
    }

    fn push(&mut self, entry: &Entry, job_faces: usize) {
        let before = self.log.len();
        append_record(&mut self.log, entry);
        self.length.bytes += self.log.len() - before;
        self.length.entries += 1;
        self.length.job_faces += job_faces;
    }

    /// Begins at the later start; false if there is none.
    fn advance(&mut self) -> bool {
        let Some((start, first_step, at)) = self.later.take() else { return false };
        let header = new_log();
        self.log.drain(header.len()..header.len() + at.bytes);
        self.length = self.length.since(at);
        (self.start, self.first_step) = (Some(start), first_step);
        true
    }
}

/// Whether a command makes a new document.
fn makes_document(command: &Command) -> bool {
    matches!(command.op.action(), Action::WholeMesh(whole) if whole.commit() == Commit::NewDocument)
}

impl Editor {
    /// Begins the trail anew with the document as it is now.
    pub(crate) fn restart_trail(&mut self) {
        self.trail = Trail::from(self.start_of_trail(), self.next_step());
    }

    /// The document as it is now, if it is small enough to be kept.
    fn start_of_trail(&self) -> Option<Snapshot> {
        let bytes: usize = self.document().objects().iter().map(|object| object.mesh().bytes()).sum();
        (bytes <= MAX_START_BYTES && !self.is_editing()).then(|| Snapshot::of(self))
    }

    /// Begins the trail with the command that just made a new document: what was before it is another matter.
    pub(crate) fn begin_trail_with(&mut self, command: Command) {
        let Numbers { revision, last_revision, .. } = self.numbers();
        let mut start = Snapshot::empty();
        start.selection = Arc::new(Selection::new(self.selection().kind()));
        start.numbers.revision = revision.saturating_sub(1);
        start.numbers.last_revision = last_revision.saturating_sub(1).max(start.numbers.revision);
        self.trail = Trail::from(Some(start), self.next_step());
        self.trail.push(&Entry { event: Event::Start(command), revision }, 0);
    }

    /// Adds what was just done to the trail. `reversed` is the number of the step that was undone or redone.
    pub(crate) fn extend_trail(&mut self, event: &Event, reversed: Option<u64>) {
        if self.history_limit() == 0 {
            self.trail = Trail::unknown();
            return;
        }
        let is_before = |step: u64| reversed.is_some_and(|number| number < step);
        let job_faces = match event {
            // None of them changes the document or what can be undone.
            Event::Draft(_) | Event::View(_) | Event::Cancel | Event::Saved(_) | Event::Name(_) => return,
            Event::Break => return self.restart_trail(),
            _ if is_before(self.trail.first_step) => return self.restart_trail(),
            Event::Run(command) | Event::Job { command, .. } if makes_document(command) => {
                return self.begin_trail_with(command.clone());
            }
            _ if self.trail.start.is_none() => return,
            Event::Job { .. } => {
                self.document().objects().iter().map(|object| object.mesh().face_count()).sum()
            }
            _ => 0,
        };
        let entry = Entry { event: event.clone(), revision: self.revision() };
        let trail = &mut self.trail;
        trail.later = trail.later.take().filter(|(_, first_step, _)| !is_before(*first_step));
        trail.push(&entry, job_faces);
        if self.trail.length.exceeds(1) {
            if !self.trail.advance() {
                self.restart_trail();
            }
        } else if self.trail.length.exceeds(2) && self.trail.later.is_none() {
            let (first_step, length) = (self.next_step(), self.trail.length);
            self.trail.later = self.start_of_trail().map(|start| (Arc::new(start), first_step, length));
        }
    }
}
