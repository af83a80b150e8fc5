//! Adjusting the last operation: doing it again with other fields, in place of itself.

use super::{Begun, Editor};
use crate::command::Command;
use crate::error::CommandError;

impl Editor {
    /// Notes the command that led to the present state.
    pub(super) fn remember(&mut self, command: Command) {
        self.last = Some((command, self.revision));
    }

    /// The command that led to the present state, as it was given; none where the last thing done
    /// was something else, such as an undo.
    pub fn last_command(&self) -> Option<&Command> {
        let (command, revision) = self.last.as_ref()?;
        let edited = self.is_dragging() && !self.is_trying();
        (*revision == self.revision && !edited).then_some(command)
    }

    /// Does the last command again with other fields: takes the last step back and begins this
    /// command on the document and selection from before it, so that one step stays one step.
    ///
    /// Where that gives a job, the document is as before the last step until the job is finished;
    /// [`Editor::redo`] brings the last step back if the job fails or is cancelled.
    ///
    /// # Errors
    /// There is no such command, or why the new one is refused; the document is then as it was.
    pub fn adjust(&mut self, command: Command) -> Result<Begun, CommandError> {
        if self.last_command().is_none() {
            return Err(CommandError::refused(
                command.name(),
                "there is no last operation to adjust: something else was done since",
            ));
        }
        let last = self.last.clone();
        self.settle();
        self.undo()?;
        self.begin(command).map_err(|error| match self.redo() {
            Ok(_) => {
                self.last = last;
                error
            }
            Err(stuck) => stuck,
        })
    }
}
