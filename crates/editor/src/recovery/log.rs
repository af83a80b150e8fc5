//! What is done in an editor, as entries for the log.

use super::entry::{Entry, Event};
use crate::editor::Editor;

/// The entries that were not taken yet.
#[derive(Debug, Default)]
pub(crate) struct Log {
    entries: Vec<Entry>,
    /// Steps below this number were made before the last snapshot, so that replaying can't undo them.
    first_step: u64,
    /// Whether the last entries show an edit that had not ended.
    has_draft: bool,
    /// Whether something was done that can't be replayed, so that nothing is worth logging before the next snapshot.
    is_broken: bool,
}

impl Editor {
    /// Starts to log what is done from here on: in an editor with the initial document, or after replaying.
    pub fn start_log(&mut self) {
        self.log = Some(Log::default());
    }

    /// The entries since the last call, the oldest first; none if no log was started.
    pub fn take_log(&mut self) -> Vec<Entry> {
        self.log.as_mut().map(|log| std::mem::take(&mut log.entries)).unwrap_or_default()
    }

    /// Whether something was done that can't be replayed, such as opening a file: only a new snapshot can hold the
    /// document as it is now.
    pub fn needs_snapshot(&self) -> bool {
        self.log.as_ref().is_some_and(|log| log.is_broken)
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
        self.put_in_log(event);
    }

    fn put_in_log(&mut self, event: Event) {
        let revision = self.revision();
        if let Some(log) = self.log.as_mut().filter(|log| !log.is_broken) {
            log.is_broken = event == Event::Break;
            log.has_draft =
                matches!(event, Event::Draft(_)) || (log.has_draft && matches!(event, Event::View(_)));
            log.entries.push(Entry { event, revision });
        }
    }

    /// Logs that the ongoing edit was cancelled or ended without a change, if the log shows it.
    pub(crate) fn log_cancelled(&mut self) {
        if self.log.as_ref().is_some_and(|log| log.has_draft) {
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
        let is_older = self.log.as_ref().is_some_and(|log| number < log.first_step);
        self.extend_trail(&event, Some(number));
        self.put_in_log(if is_older { Event::Break } else { event });
    }

    /// Begins the log again after a snapshot.
    pub(super) fn restart_log(&mut self) {
        let first_step = self.next_step();
        if let Some(log) = &mut self.log {
            *log = Log { first_step, ..Log::default() };
        }
    }
}
