//! Toasts: short messages over the viewport. There is at most one small one, which the next replaces; errors stay
//! until they are read. The message list has them all.

use editor::{Editor, MessageKind, Object, ObjectId};

use crate::input::actions::Action;

/// A message with optional details.
#[derive(Clone, Debug)]
pub(crate) struct Toast {
    pub kind: MessageKind,
    pub text: String,
    pub details: Vec<String>,
    pub open: bool,
    /// What helps.
    pub remedy: Option<Remedy>,
    /// The time at which it disappears, on egui's clock; none if the user has to close it.
    until: Option<f64>,
    /// The objects of the document that it is about.
    objects: Vec<ObjectId>,
}

/// What a toast offers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Remedy {
    /// An action.
    Act(Action),
    /// To undo the edit that led to this revision of the document, while that is the current one.
    UndoEdit { revision: u64 },
    /// To bring back the document that was deleted last from the list of documents.
    RestoreDocument,
}

/// A place for a toast.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Slot {
    /// The latest error that was not read.
    Error,
    /// The latest other message.
    Small,
}

/// The toasts that have not been read and have not expired.
#[derive(Debug, Default)]
pub struct Toasts {
    /// The latest last.
    errors: Vec<Toast>,
    small: Option<Toast>,
    /// How often something changed.
    changes: u64,
}

/// How long an informative toast stays, in seconds.
const SECONDS_INFO_STAYS: f64 = 6.0;
/// How long a warning stays, in seconds.
const SECONDS_WARNING_STAYS: f64 = 12.0;
/// The largest number of errors kept for reading.
const MAX_ERRORS: usize = 50;

impl Toasts {
    /// Adds a toast about a document. `now` is the time on egui's clock, in seconds.
    pub(crate) fn add(
        &mut self,
        now: f64,
        kind: MessageKind,
        text: String,
        details: Vec<String>,
        editor: &Editor,
    ) {
        self.changes += 1;
        let objects = editor.document().objects().iter().map(Object::id).collect();
        let stays = match kind {
            MessageKind::Info => Some(SECONDS_INFO_STAYS),
            MessageKind::Warning => Some(SECONDS_WARNING_STAYS),
            MessageKind::Error => None,
        };
        let until = stays.map(|seconds| now + seconds);
        let toast = Toast { kind, text, details, open: false, remedy: None, until, objects };
        if kind == MessageKind::Error {
            // A repeated error counts once.
            self.errors.retain(|error| error.text != toast.text);
            if self.errors.len() == MAX_ERRORS {
                self.errors.remove(0);
            }
            self.errors.push(toast);
        } else {
            self.small = Some(toast);
        }
    }

    /// Offers a remedy in the small toast.
    pub(crate) fn offer(&mut self, remedy: Remedy) {
        if let Some(toast) = &mut self.small {
            toast.remedy = Some(remedy);
            self.changes += 1;
        }
    }

    /// Keeps the small toast until the user closes it or another one comes.
    pub(crate) fn stay(&mut self) {
        if let Some(toast) = &mut self.small {
            toast.until = None;
        }
    }

    /// The visible toasts: the latest error, then the latest other message.
    pub(crate) fn visible(&self) -> impl Iterator<Item = (Slot, &Toast)> {
        let error = self.errors.last().map(|toast| (Slot::Error, toast));
        error.into_iter().chain(self.small.as_ref().map(|toast| (Slot::Small, toast)))
    }

    /// The number of errors before the visible one that were not read.
    pub(crate) fn earlier_errors(&self) -> usize {
        self.errors.len().saturating_sub(1)
    }

    /// A number that differs after every change.
    pub(crate) fn changes(&self) -> u64 {
        self.changes
    }

    /// Removes an expired toast; returns the seconds until the next one expires.
    pub(crate) fn expire(&mut self, now: f64) -> Option<f64> {
        let until = self.small.as_ref()?.until?;
        if until > now {
            return Some(until - now);
        }
        self.dismiss(Slot::Small);
        None
    }

    /// Removes toasts about a document of which no object is left.
    pub(crate) fn follow(&mut self, editor: &Editor) {
        let is_there = |id: &ObjectId| editor.document().object(*id).is_some();
        let is_current = |toast: &Toast| toast.objects.is_empty() || toast.objects.iter().any(is_there);
        let before = self.visible().count() + self.errors.len();
        self.errors.retain(is_current);
        self.small = self.small.take().filter(is_current);
        if self.visible().count() + self.errors.len() != before {
            self.changes += 1;
        }
    }

    /// Shows or hides the details of a toast, which from then on stays until the user closes it.
    pub(crate) fn toggle(&mut self, slot: Slot) {
        let toast = match slot {
            Slot::Error => self.errors.last_mut(),
            Slot::Small => self.small.as_mut(),
        };
        if let Some(toast) = toast {
            toast.open = !toast.open;
            toast.until = None;
            self.changes += 1;
        }
    }

    /// Removes a toast. After an error, the one before it is visible.
    pub(crate) fn dismiss(&mut self, slot: Slot) {
        match slot {
            Slot::Error => drop(self.errors.pop()),
            Slot::Small => self.small = None,
        }
        self.changes += 1;
    }

    /// Removes all errors, which are read in the message list.
    pub(crate) fn errors_are_read(&mut self) {
        self.errors.clear();
        self.changes += 1;
    }
}
