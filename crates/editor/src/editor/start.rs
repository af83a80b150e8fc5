//! The initial document of an editor.

use super::Editor;
use crate::error::CommandError;
use crate::history::History;
use crate::ops::Command;
use crate::outcome::Outcome;

impl Editor {
    /// Runs a command whose result is the initial document: it can't be undone and there is nothing to
    /// save. Use it in an editor where nothing has been done yet; it clears the history.
    ///
    /// # Errors
    /// The command is refused; the document is unchanged.
    pub fn start_with(&mut self, command: Command) -> Result<Outcome, CommandError> {
        let outcome = self.run(command.clone())?;
        self.begin_trail_with(command);
        self.history = History::new();
        self.changes.history = true;
        self.saved = self.revision;
        Ok(outcome)
    }
}
