//! Adjusting the last operation: running it again with other fields, in place of itself.

use super::{Begun, Editor};
use crate::error::CommandError;
use crate::ops::Command;

/// The command that led to the present state.
#[derive(Clone, Debug)]
pub(super) struct Last {
    command: Command,
    revision: u64,
    /// Whether it made an undo step. An adjustment may pass through fields that change nothing.
    is_step: bool,
}

impl Editor {
    /// Remembers the command that led to the present state.
    pub(super) fn remember(&mut self, command: Command) {
        self.last = Some(Last { command, revision: self.revision, is_step: true });
    }

    /// The command that led to the present state, as it was given; none where something else was done
    /// since, such as an undo.
    pub fn last_command(&self) -> Option<&Command> {
        let last = self.last.as_ref()?;
        let edited = self.is_editing() && !self.is_previewing_mesh();
        (last.revision == self.revision && !edited).then_some(&last.command)
    }

    /// Run the last command again with other fields: undoes the last step and begins this command on
    /// the document and selection from before it, so that one step stays one step.
    ///
    /// Where that gives a job, the document is as before the last step until the job is finished;
    /// [`Editor::redo`] brings the last step back if the job fails or is cancelled.
    ///
    /// # Errors
    /// There is no such command, or why the new one is refused; the document is then as it was.
    pub fn adjust(&mut self, command: Command) -> Result<Begun, CommandError> {
        let Some(last) = self.last.clone().filter(|_| self.last_command().is_some()) else {
            return Err(CommandError::refused(
                command.name(),
                "there is no last operation to adjust: something else was done since",
            ));
        };
        self.end_edit();
        if last.is_step {
            self.undo()?;
        }
        let before = self.revision;
        match self.begin(command.clone()) {
            Ok(begun) => {
                if matches!(begun, Begun::Done(_)) && self.revision == before {
                    self.last = Some(Last { command, revision: before, is_step: false });
                }
                Ok(begun)
            }
            Err(error) if !last.is_step => Err(error),
            Err(error) => match self.redo() {
                Ok(_) => {
                    self.last = Some(last);
                    Err(error)
                }
                Err(stuck) => Err(stuck),
            },
        }
    }
}
