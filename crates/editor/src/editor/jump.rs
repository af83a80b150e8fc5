//! Going to any state of the history, at once or some steps at a time. Each step is a whole undo or redo, so the document
//! is consistent after each. Anything else that is done first completes the jump.

use super::{Editor, MessageKind};
use crate::error::CommandError;
use halfedge::Budget;

/// A jump in progress.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Jump {
    /// Whether it undoes edits.
    pub back: bool,
    /// The number of edits still to be undone or redone.
    pub left: usize,
    /// The number of edits that it undoes or redoes in all.
    pub all: usize,
}

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
        self.begin_jump(edits)?;
        self.jump_some(&mut Budget::unlimited())
    }

    /// Begins to go to a state as [`Editor::jump_to`] does; [`Editor::jump_some`] goes on. A jump in progress goes there
    /// instead, from where it is.
    ///
    /// # Errors
    /// As [`Editor::jump_to`].
    pub fn begin_jump(&mut self, edits: usize) -> Result<(), CommandError> {
        self.finish_selecting();
        let done = self.undo_labels().count();
        let (back, forward) = (done.saturating_sub(edits), edits.saturating_sub(done));
        let undone = self.history.steps_back(back).flat_map(|step| &step.changes);
        self.check_busy(undone.chain(self.history.steps_forward(forward).flat_map(|step| &step.changes)))
            .map_err(|problem| CommandError::of("history", problem))?;
        self.cancel_edit();
        let forward = forward.min(self.redo_labels().count());
        let all = back + forward;
        self.jumping = (all > 0).then_some(Jump { back: back > 0, left: all, all });
        self.changes.history = true;
        Ok(())
    }

    /// Undoes or redoes more steps of a jump, as many as the budget has elements for, which counts those that a step
    /// changes; one more that it has not is completed.
    ///
    /// # Errors
    /// A job is running on a mesh that would change; the jump ends where it is.
    pub fn jump_some(&mut self, budget: &mut Budget) -> Result<(), CommandError> {
        // Taken out, because undo and redo complete a jump.
        let Some(mut jump) = self.jumping.take() else { return Ok(()) };
        self.changes.history = true;
        while jump.left > 0 {
            let next = if jump.back { self.history.next_undo() } else { self.history.next_redo() };
            let Some(step) = next else { break };
            if budget.is_spent() {
                self.jumping = Some(jump);
                break;
            }
            budget.take(step.elements());
            jump.left -= usize::from(!step.is_selection());
            if jump.back {
                self.undo_step()?
            } else {
                self.redo_step()?
            };
        }
        Ok(())
    }

    /// The jump in progress.
    pub fn jump(&self) -> Option<Jump> {
        self.jumping
    }

    /// Ends a jump where it is; returns whether there was one.
    pub fn stop_jump(&mut self) -> bool {
        self.changes.history |= self.jumping.is_some();
        self.jumping.take().is_some()
    }

    /// Completes a jump and what is being looked for.
    pub(super) fn finish_parts(&mut self) {
        if let Err(error) = self.jump_some(&mut Budget::unlimited()) {
            self.say(MessageKind::Error, error.message());
        }
        self.finish_selecting();
    }
}
