//! Adjusting the last operation: replacing its result by that of the same operation with other fields.

use super::jobs::MAX_ELEMENTS_AT_ONCE;
use super::{Begun, Editor, MessageKind};
use crate::document::ObjectId;
use crate::error::CommandError;
use crate::history::{Change, Step};
use crate::ops::Command;
use crate::recovery::Event;
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
    /// The steps that could be redone after it, the next one last.
    later: Vec<Step>,
    last: Last,
    /// The document's revision before the step.
    before: u64,
    /// The last revision that was made when the step was taken out.
    last_revision: u64,
    /// What [`Editor::place_in_history`] was when the step was taken out.
    place: (u64, Option<u64>),
}

impl Replaced {
    /// Whether the step changes an object, which must stay as it is until the step is restored or dropped.
    pub(super) fn needs(&self, id: ObjectId) -> bool {
        self.step.changes.iter().any(|change| change.object() == Some(id))
    }
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
        self.adjust_from(command, MAX_ELEMENTS_AT_ONCE)
    }

    /// [`Editor::adjust`] with another threshold: a command becomes a job from this many faces of work.
    ///
    /// # Errors
    /// As [`Editor::adjust`].
    pub fn adjust_from(&mut self, command: Command, faces: usize) -> Result<Begun, CommandError> {
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
        match self.begin_from(command.clone(), faces) {
            Ok(begun) => {
                match &begun {
                    Begun::Done(_) if self.revision == before && last.selected.is_none() => {
                        self.remember_without_step(command);
                    }
                    Begun::Done(_) | Begun::Selecting => {}
                    Begun::Job(request) => {
                        // The job keeps the step, so that nothing done meanwhile can drop it, and what could be
                        // redone after it, which fits no document without it.
                        let step = if last.is_step { self.history.take_redo() } else { None };
                        let later = if step.is_some() { self.history.take_all_redo() } else { Vec::new() };
                        let place = self.place_in_history();
                        let last_revision = self.last_revision;
                        let replaced =
                            step.map(|step| Replaced { step, later, last, before, last_revision, place });
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

    /// The number of the next step and of the one that would be undone: the same if nothing was done or undone.
    fn place_in_history(&self) -> (u64, Option<u64>) {
        (self.next_step, self.history.next_undo().map(|step| step.number))
    }

    /// Lets a step be redone that a job was to replace, but the job changed nothing: as after an adjustment that is made at
    /// once. An edit that was made meanwhile has forgotten what could be redone.
    pub(super) fn keep_redo_of(&mut self, replaced: Replaced) {
        let Replaced { step, mut later, last_revision, .. } = replaced;
        if last_revision != self.last_revision {
            return;
        }
        later.push(step);
        later.extend(self.history.take_all_redo());
        later.into_iter().for_each(|step| self.history.keep_redo(step));
        self.changes.history = true;
    }

    /// Restores a step that an adjustment undid but could not replace.
    pub(super) fn restore(&mut self, replaced: Replaced) {
        self.end_edit();
        let Replaced { step, later, last, before, place, .. } = replaced;
        if self.revision == before {
            let number = step.number;
            let is_next = self.place_in_history() == place;
            // What was undone since was done before the step.
            self.history.take_all_redo();
            let back = self.reverse(step);
            self.history.keep_undo(back);
            if is_next {
                later.into_iter().for_each(|step| self.history.keep_redo(step));
            }
            self.log_reversed(number, if is_next { Event::RedoStep } else { Event::Break });
            self.last = Some(last);
            return;
        }
        // Other objects changed meanwhile. Those of the step did not, but places in the list of objects may now
        // refer to others.
        let label = step.label.clone();
        let selection = self.selection.clone();
        let objects: Option<Vec<ObjectId>> = step.changes.iter().map(Change::object).collect();
        let mut back = Vec::new();
        if let Some(objects) = objects {
            back = self.apply(step.changes);
            for id in objects {
                back.extend(self.forget_gone(id));
            }
        }
        self.drop_gone_from_selection();
        let is_step = self.push_step(label.clone(), back, selection);
        self.log(Event::Break);
        if !is_step {
            self.say(
                MessageKind::Warning,
                format!("“{label}” could not be done again: the objects of the document changed meanwhile"),
            );
        }
    }
}
