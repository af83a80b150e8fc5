//! Going to any state of the history at once.

use super::Editor;
use crate::error::CommandError;

impl Editor {
    /// Whether the history begins with the first document. If not, its oldest steps were dropped because they took too
    /// much memory.
    pub fn has_whole_history(&self) -> bool {
        self.history.is_whole
    }

    /// Goes to the state right after the first `edits` edits of the history, which counts those that can be redone. Cancels
    /// an ongoing edit. Undoes or redoes one step after the other, at the cost of all of them together.
    ///
    /// # Errors
    /// A job is running on a mesh that would change; nothing is changed.
    pub fn jump_to(&mut self, edits: usize) -> Result<(), CommandError> {
        self.finish_selecting();
        let done = self.undo_labels().count();
        let mut back = done.saturating_sub(edits);
        let mut forward = edits.saturating_sub(done);
        let undone = self.history.steps_back(back).flat_map(|step| &step.changes);
        self.check_busy(undone.chain(self.history.steps_forward(forward).flat_map(|step| &step.changes)))
            .map_err(|problem| CommandError::of("history", problem))?;
        self.cancel_edit();
        while back > 0 && self.history.next_undo().is_some() {
            back -= usize::from(self.history.next_undo().is_some_and(|step| !step.is_selection()));
            self.undo_step()?;
        }
        while forward > 0 && self.history.next_redo().is_some() {
            forward -= usize::from(self.history.next_redo().is_some_and(|step| !step.is_selection()));
            self.redo_step()?;
        }
        Ok(())
    }
}
