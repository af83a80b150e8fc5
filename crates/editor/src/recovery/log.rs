//! What is done in an editor, as entries for the log.

use super::entry::{Entry, Event};
use crate::document::Origin;
use crate::editor::Editor;

/// What was done since the last snapshot, and since one that is being copied.
#[derive(Debug, Default)]
pub(crate) struct Log {
    last: Since,
    copied: Option<Since>,
}

/// What was done since a snapshot.
#[derive(Debug, Default)]
struct Since {
    /// The entries that were not taken yet, each with the document that it led to.
    entries: Vec<(Origin, Entry)>,
    /// Steps below this number were made before the snapshot, so that replaying can't undo them.
    first_step: u64,
    /// Whether the last entries show an edit that had not ended.
    has_draft: bool,
    /// Whether something was done that can't be replayed, so that nothing is worth logging before the next snapshot.
    is_broken: bool,
}

impl Since {
    fn put(&mut self, event: Event, revision: u64, origin: Origin) {
        if self.is_broken {
            return;
        }
        self.is_broken = event == Event::Break;
        self.has_draft =
            matches!(event, Event::Draft(_)) || (self.has_draft && matches!(event, Event::View(_)));
        self.entries.push((origin, Entry { event, revision }));
    }
}

impl Log {
    fn parts(&mut self) -> impl Iterator<Item = &mut Since> {
        std::iter::once(&mut self.last).chain(&mut self.copied)
    }
}

impl Editor {
    /// Starts to log what is done from here on: in an editor with the initial document, or after replaying.
    pub fn start_log(&mut self) {
        self.log = Some(Log::default());
    }

    /// The entries since the last call, the oldest first; none if no log was started.
    pub fn take_log(&mut self) -> Vec<Entry> {
        let taken = self.log.as_mut().map(|log| std::mem::take(&mut log.last.entries));
        taken.unwrap_or_default().into_iter().map(|(_, entry)| entry).collect()
    }

    /// As [`Editor::take_log`], but only the entries until another document took the place of this one; those after them are
    /// forgotten.
    pub fn take_log_of(&mut self, origin: Origin) -> Vec<Entry> {
        let taken = self.log.as_mut().map(|log| std::mem::take(&mut log.last.entries));
        let is_of = |(of, entry): &(Origin, Entry)| *of == origin && entry.event != Event::Break;
        taken.unwrap_or_default().into_iter().take_while(is_of).map(|(_, entry)| entry).collect()
    }

    /// Whether something was done that can't be replayed, such as opening a file: only a new snapshot can hold the
    /// document as it is now.
    pub fn needs_snapshot(&self) -> bool {
        self.log.as_ref().is_some_and(|log| log.last.is_broken)
    }

    /// Whether the snapshot that is being copied is worthless, because something was done since that can't be replayed.
    pub fn has_outdated_copy(&self) -> bool {
        self.log.as_ref().and_then(|log| log.copied.as_ref()).is_some_and(|copied| copied.is_broken)
    }

    /// The entry of an ongoing edit of elements, to be logged now and then in case it never ends.
    pub fn log_draft(&mut self) {
        let command = self.ongoing_command().filter(|_| !self.is_previewing_mesh()).cloned();
        if let Some(command) = command {
            self.log(Event::Draft(command));
        }
    }

    /// Logs the state of the viewport, in the page's own JSON. Project files keep the last one.
    pub fn log_view(&mut self, view: impl Into<String>) {
        let view = view.into();
        self.view = Some(view.clone());
        self.log(Event::View(view));
    }

    /// Logs what was just done.
    pub(crate) fn log(&mut self, event: Event) {
        self.extend_trail(&event, None);
        self.put_in_log(event, u64::MAX);
    }

    /// Logs an event of a step of this number.
    fn put_in_log(&mut self, event: Event, number: u64) {
        let (revision, origin) = (self.revision(), self.document().origin());
        for since in self.log.iter_mut().flat_map(Log::parts) {
            let event = if number < since.first_step { Event::Break } else { event.clone() };
            since.put(event, revision, origin);
        }
    }

    /// Logs that the ongoing edit was cancelled or ended without a change, if the log shows it.
    pub(crate) fn log_cancelled(&mut self) {
        if self.log.iter_mut().flat_map(Log::parts).any(|since| since.has_draft) {
            self.log(Event::Cancel);
        }
    }

    /// Logs what is selected.
    pub(crate) fn log_selection(&mut self, continues: bool) {
        let selection = self.shared_selection().clone();
        self.log(Event::Select { selection, continues });
    }

    /// Logs that a step was undone or redone.
    pub(crate) fn log_reversed(&mut self, number: u64, event: Event) {
        self.extend_trail(&event, Some(number));
        self.put_in_log(event, number);
    }

    /// Also logs what is done after a snapshot that is copied from now on.
    pub(super) fn begin_log_of_copy(&mut self) {
        let first_step = self.next_step();
        if let Some(log) = &mut self.log {
            log.copied = Some(Since { first_step, ..Since::default() });
        }
    }

    /// Makes the log one of what was done since the snapshot that was copied.
    pub(super) fn end_log_of_copy(&mut self) {
        if let Some(log) = &mut self.log
            && let Some(copied) = log.copied.take()
        {
            log.last = copied;
        }
    }
}
