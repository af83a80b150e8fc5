//! Undo and redo: one mechanism for every command.
//!
//! A step is a list of [`Change`]s. Applying a change returns its inverse. Undo therefore applies a step's
//! changes in reverse, and their inverses form the redo step. A local edit is stored as a journal, an
//! operation on a whole mesh as the mesh that it replaced, so undoing a step costs no more than the step
//! itself did.
//!
//! A step without changes is a change of the selection. Edits don't count it: it is not among the labels, undoing an
//! edit forgets those made since, and making one forgets no edit that could be redone.

mod change;

pub(crate) use change::{Change, is_reshaping};

use crate::selection::Selection;
use std::collections::VecDeque;
use std::sync::Arc;

/// A step that can be undone or, once undone, redone.
#[derive(Debug)]
pub(crate) struct Step {
    /// The label in menus.
    pub label: String,
    /// The changes that undo the step (or redo it, once undone), in order.
    pub changes: Vec<Change>,
    /// The selection to restore with them.
    pub selection: Arc<Selection>,
    /// The revision to restore with them; documents of equal revision are equal.
    pub revision: u64,
    /// The number of steps that were made before it; it keeps the number when it is undone.
    pub number: u64,
}

impl Step {
    /// Whether only the selection changed.
    pub fn is_selection(&self) -> bool {
        self.changes.is_empty()
    }

    /// About how many elements undoing it changes one by one.
    pub fn elements(&self) -> usize {
        let of_journals = self.changes.iter().map(|change| match change {
            Change::Journal(_, journal) => journal.len(),
            _ => 1,
        });
        of_journals.sum()
    }

    fn bytes(&self) -> usize {
        size_of::<Self>() + self.selection.bytes() + self.changes.iter().map(Change::bytes).sum::<usize>()
    }
}

/// The steps that can be undone and redone, limited by the memory that they take.
#[derive(Debug)]
pub(crate) struct History {
    undo: VecDeque<(Step, usize)>,
    redo: Vec<(Step, usize)>,
    bytes: usize,
    limit: usize,
    /// Whether no edit was dropped because of the limit.
    pub is_whole: bool,
}

impl History {
    /// The default limit of memory, in bytes.
    pub const DEFAULT_LIMIT_BYTES: usize = 512 << 20;

    pub fn new() -> Self {
        Self {
            undo: VecDeque::new(),
            redo: Vec::new(),
            bytes: 0,
            limit: Self::DEFAULT_LIMIT_BYTES,
            is_whole: true,
        }
    }

    /// Adds a step that was just made and forgets the steps that could be redone.
    pub fn push(&mut self, step: Step) {
        self.bytes -= self.redo.drain(..).map(|(_, bytes)| bytes).sum::<usize>();
        self.keep_undo(step);
        self.shrink();
    }

    /// Adds the steps of another history after these, and forgets the steps that could be redone.
    pub fn append(&mut self, other: Self) {
        self.bytes -= self.redo.drain(..).map(|(_, bytes)| bytes).sum::<usize>();
        self.undo.extend(other.undo);
        self.redo = other.redo;
        self.bytes += other.bytes;
        self.is_whole &= other.is_whole;
        self.shrink();
    }

    /// Adds a change of the selection. Forgets the changes of the selection that could be redone next, but no edits:
    /// they fit the document whatever is selected.
    pub fn push_selection(&mut self, step: Step) {
        self.forget_selections_to_redo();
        self.keep_undo(step);
        self.shrink();
    }

    /// Forgets the changes of the selection since the last edit.
    pub fn forget_selections(&mut self) {
        while self.next_undo().is_some_and(Step::is_selection) {
            self.take_undo();
        }
    }

    /// Forgets the changes of the selection that could be redone before an edit.
    pub fn forget_selections_to_redo(&mut self) {
        while self.next_redo().is_some_and(Step::is_selection) {
            self.take_redo();
        }
    }

    pub fn keep_undo(&mut self, step: Step) {
        let bytes = step.bytes();
        self.bytes += bytes;
        self.undo.push_back((step, bytes));
    }

    pub fn keep_redo(&mut self, step: Step) {
        let bytes = step.bytes();
        self.bytes += bytes;
        self.redo.push((step, bytes));
    }

    pub fn take_undo(&mut self) -> Option<Step> {
        let (step, bytes) = self.undo.pop_back()?;
        self.bytes -= bytes;
        Some(step)
    }

    pub fn take_redo(&mut self) -> Option<Step> {
        let (step, bytes) = self.redo.pop()?;
        self.bytes -= bytes;
        Some(step)
    }

    /// Takes all steps that can be redone, the next one last.
    pub fn take_all_redo(&mut self) -> Vec<Step> {
        self.bytes -= self.redo.iter().map(|(_, bytes)| bytes).sum::<usize>();
        self.redo.drain(..).map(|(step, _)| step).collect()
    }

    pub fn next_undo(&self) -> Option<&Step> {
        self.undo.back().map(|(step, _)| step)
    }

    pub fn next_redo(&self) -> Option<&Step> {
        self.redo.last().map(|(step, _)| step)
    }

    /// The steps from the next one to undo to the last of this many edits.
    pub fn steps_back(&self, edits: usize) -> impl Iterator<Item = &Step> {
        up_to(self.undo.iter().rev(), edits)
    }

    /// The steps from the next one to redo to the last of this many edits.
    pub fn steps_forward(&self, edits: usize) -> impl Iterator<Item = &Step> {
        up_to(self.redo.iter().rev(), edits)
    }

    /// The labels of the edits that can be undone, the next one last.
    pub fn undo_labels(&self) -> impl Iterator<Item = &str> {
        self.undo.iter().filter(|(step, _)| !step.is_selection()).map(|(step, _)| step.label.as_str())
    }

    /// The labels of the edits that can be redone, the next one last.
    pub fn redo_labels(&self) -> impl Iterator<Item = &str> {
        self.redo.iter().filter(|(step, _)| !step.is_selection()).map(|(step, _)| step.label.as_str())
    }

    pub fn bytes(&self) -> usize {
        self.bytes
    }

    pub fn limit(&self) -> usize {
        self.limit
    }

    pub fn set_limit(&mut self, limit: usize) {
        self.limit = limit;
        self.shrink();
    }

    /// Drops the oldest steps until the rest fits the limit. Keeps the latest edit whatever its size, so that it can
    /// always be undone.
    fn shrink(&mut self) {
        while self.bytes > self.limit {
            let edits = self.undo.iter().rev().filter(|(step, _)| !step.is_selection());
            let is_last_edit = edits.take(2).count() == 1;
            // Nothing else is left of the steps before the last edit's selections.
            let at = match self.undo.front() {
                Some((step, _)) => usize::from(is_last_edit && !step.is_selection()),
                None => return,
            };
            let Some((step, bytes)) = self.undo.remove(at) else { return };
            self.is_whole &= step.is_selection();
            self.bytes -= bytes;
        }
    }
}

/// The steps up to the last of this many edits.
fn up_to<'a>(
    steps: impl Iterator<Item = &'a (Step, usize)>,
    mut edits: usize,
) -> impl Iterator<Item = &'a Step> {
    steps.map(|(step, _)| step).take_while(move |step| {
        let is_wanted = edits > 0;
        edits -= usize::from(is_wanted && !step.is_selection());
        is_wanted
    })
}
