//! What an editor opens on.

use super::Editor;
use crate::error::CommandError;
use crate::history::History;
use crate::ops::Command;
use crate::outcome::Outcome;

impl Editor {
    /// Runs a command whose result is what the editor opens on: it can't be undone and there is
    /// nothing to save. For an editor in which nothing has been done yet; the history is forgotten.
    ///
    /// # Errors
    /// Why the command is refused; the document is then as it was.
    pub fn start_with(&mut self, command: Command) -> Result<Outcome, CommandError> {
        let outcome = self.run(command)?;
        self.history = History::new();
        self.changes.history = true;
        self.saved = self.revision;
        Ok(outcome)
    }
}
