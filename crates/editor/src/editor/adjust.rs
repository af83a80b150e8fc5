//! Adjusting the last operation: replacing its result by that of the same operation with other fields.

use super::{Begun, Editor, MessageKind};
use crate::error::CommandError;
use crate::history::{Change, Step};
use crate::ops::Command;
use crate::selection::Selection;
use std::sync::Arc;

/// The command that led to the present state.
#[derive(Clone, Debug)]
pub(super) struct Last {
    command: Command,
    revision: u64,
    /// Whether the command made an undo step. Some values of an adjustment may change nothing.
    is_step: bool,
    /// The selection that it made, if it only selects.
    selected: Option<Arc<Selection>>,
}

/// A step that a job is to replace.
#[derive(Debug)]
pub(super) struct Replaced {
    /// The step that redoes the change.
    step: Step,
    last: Last,
    /// The document's revision before the step.
    before: u64,
}

impl Editor {
    /// Remembers the command that led to the present state.
    pub(super) fn remember(&mut self, command: Command) {
        self.last = Some(Last { command, revision: self.revision, is_step: true, selected: None });
    }

    /// Remembers a command that changed the selection from what it was before, or left it.
    pub(super) fn remember_selecting(&mut self, command: Command, before: &Arc<Selection>) {
        let is_step = self.selection.is_step_from(before);
        let selected = Some(self.selection.clone());
        self.last = Some(Last { command, revision: self.revision, is_step, selected });
    }

    /// Remembers an adjustment that changed nothing, so that the next one has no step to undo.
    pub(super) fn remember_without_step(&mut self, command: Command) {
        self.last = Some(Last { command, revision: self.revision, is_step: false, selected: None });
    }

    /// The command that led to the current revision, as it was given; none if something else was done
    /// since, such as an undo.
    pub fn last_command(&self) -> Option<&Command> {
        let last = self.last.as_ref()?;
        let edited = self.is_editing() && !self.is_previewing_mesh();
        let selected_more = last.selected.as_ref().is_some_and(|set| !Arc::ptr_eq(set, &self.selection));
        (last.revision == self.revision && !edited && !selected_more).then_some(&last.command)
    }

    /// Runs the last command again with other fields: undoes the last step and begins the new command on
    /// the document and selection from before it, so that there is still one step.
    ///
    /// If that begins a job, the document stays as it was before the last step until the job finishes. If
    /// the job fails or is cancelled, the step is restored.
    ///
    /// # Errors
    /// There is no last command, or the new one is refused; the document is unchanged.
    pub fn adjust(&mut self, command: Command) -> Result<Begun, CommandError> {
        let Some(last) = self.last.clone().filter(|_| self.last_command().is_some()) else {
            return Err(CommandError::refused(
                command.name(),
                "there is no last operation to adjust: something else was done since it",
            ));
        };
        self.end_edit();
        match (last.is_step, &last.selected) {
            (true, None) => drop(self.undo()?),
            (true, Some(_)) => drop(self.undo_step()?),
            (false, _) => {}
        }
        let before = self.revision;
        match self.begin(command.clone()) {
            Ok(begun) => {
                match &begun {
                    Begun::Done(_) if self.revision == before && last.selected.is_none() => {
                        self.remember_without_step(command);
                    }
                    Begun::Done(_) | Begun::Selecting => {}
                    Begun::Job(request) => {
                        // The job keeps the step, so that nothing done meanwhile can drop it.
                        let step = if last.is_step { self.history.take_redo() } else { None };
                        let replaced = step.map(|step| Replaced { step, last, before });
                        self.set_adjusts(request.id(), replaced);
                        self.changes.history = true;
                    }
                }
                Ok(begun)
            }
            Err(error) if !last.is_step => Err(error),
            Err(error) => match self.redo_step() {
                Ok(_) => {
                    self.last = Some(last);
                    Err(error)
                }
                Err(stuck) => Err(stuck),
            },
        }
    }

    /// Restores a step that an adjustment undid but could not replace.
    pub(super) fn restore(&mut self, replaced: Replaced) {
        self.finish_selecting();
        let Replaced { step, last, before } = replaced;
        if self.revision == before {
            let back = self.reverse(step);
            self.history.keep_undo(back);
            self.last = Some(last);
            return;
        }
        // Other objects changed meanwhile. The job's own objects did not, but places in the list of objects
        // may now refer to others.
        let label = step.label.clone();
        let selection = self.selection.clone();
        let back = if step.changes.iter().all(Change::is_of_one_object) {
            self.apply(step.changes)
        } else {
            Vec::new()
        };
        self.drop_gone_from_selection();
        if !self.push_step(label.clone(), back, selection) {
            self.say(
                MessageKind::Warning,
                format!("“{label}” could not be done again: the objects of the document changed meanwhile"),
            );
        }
    }
}
