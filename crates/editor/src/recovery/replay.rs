//! Repeating what a log says.

use super::entry::{Entry, Event};
use crate::editor::{Editor, LoggedJob};
use crate::error::CommandError;
use crate::job::{JobId, JobRequest, JobResult};
use std::fmt;

/// Why an entry could not be repeated. The document is as it was before the entry, or as the command left it.
#[derive(Clone, Debug, PartialEq)]
pub enum NotReplayed {
    /// Its command was refused.
    Refused(CommandError),
    /// It led to another revision than before, so that later entries would act on something else.
    Differs,
    /// What was done can't be replayed.
    Broken,
}

impl fmt::Display for NotReplayed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused(error) => write!(f, "{error}"),
            Self::Differs => f.write_str("the change did not lead to the same state as before"),
            Self::Broken => f.write_str("the change was not kept"),
        }
    }
}

impl std::error::Error for NotReplayed {}

/// What was recovered besides the document.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Recovered {
    /// The last state of the viewport that was logged.
    pub view: Option<String>,
    /// Whether an edit had not ended. It is committed.
    pub had_draft: bool,
}

impl Editor {
    /// Does again what an entry says. Entries must be replayed in order, on the document that the log started with.
    /// Costs as much as the command did.
    ///
    /// # Errors
    /// The entry can't be repeated: leave out this one and those after it.
    pub fn replay(&mut self, entry: Entry) -> Result<(), NotReplayed> {
        let Entry { event, revision } = entry;
        if !matches!(event, Event::Draft(_) | Event::View(_) | Event::Edit(_)) {
            // The drag that it shows was cancelled.
            self.cancel_edit();
        }
        let refused = NotReplayed::Refused;
        match event {
            Event::Start(command) => drop(self.start_with(command).map_err(refused)?),
            Event::Run(command) => drop(self.run(command).map_err(refused)?),
            Event::Job { command, selection, objects, at, names } => {
                self.replay_job(LoggedJob { command, selection, objects, at, names }).map_err(refused)?;
            }
            Event::Edit(command) => {
                self.update_edit(command).map_err(refused)?;
                self.commit_edit();
            }
            Event::Draft(command) => drop(self.update_edit(command).map_err(refused)?),
            Event::Select { selection, continues } => self.replay_selection(&selection, continues),
            Event::Undo => drop(self.undo().map_err(refused)?),
            Event::UndoStep => drop(self.undo_step().map_err(refused)?),
            Event::Redo => drop(self.redo().map_err(refused)?),
            Event::RedoStep => drop(self.redo_step().map_err(refused)?),
            Event::Name(name) => self.rename_document(&name),
            Event::Saved(revision) => self.mark_saved(revision),
            Event::Cancel | Event::View(_) => {}
            Event::Break => return Err(NotReplayed::Broken),
        }
        if self.revision() == revision { Ok(()) } else { Err(NotReplayed::Differs) }
    }

    /// Begins what an entry says, if it is a job that takes long: it may run anywhere, and [`Editor::finish_replay`] takes
    /// its result. None for everything else, which [`Editor::replay`] does at once.
    ///
    /// # Errors
    /// As [`Editor::replay`].
    pub fn begin_replay(&mut self, entry: &Entry) -> Result<Option<JobRequest>, NotReplayed> {
        let Event::Job { command, selection, objects, at, names } = entry.event.clone() else {
            return Ok(None);
        };
        self.cancel_edit();
        self.begin_logged_job(LoggedJob { command, selection, objects, at, names })
            .map_err(NotReplayed::Refused)
    }

    /// Ends what [`Editor::begin_replay`] began for this entry.
    ///
    /// # Errors
    /// As [`Editor::replay`].
    pub fn finish_replay(
        &mut self,
        entry: &Entry,
        job: JobId,
        result: Result<JobResult, CommandError>,
    ) -> Result<(), NotReplayed> {
        self.finish(job, result).map_err(NotReplayed::Refused)?;
        if self.revision() == entry.revision { Ok(()) } else { Err(NotReplayed::Differs) }
    }

    /// Ends replaying: commits an edit that had not ended, forgets the messages, and logs from here on.
    pub fn end_replay(&mut self) {
        self.forget_messages();
        self.start_log();
        self.commit_edit();
    }
}
