//! What the log of changes needs of an editor, and replaying it.

use super::Editor;
use super::jobs::{MAX_ELEMENTS_AT_ONCE, Run, WaitingFor};
use super::run::{Planned, broken};
use crate::changes::Changes;
use crate::document::Document;
use crate::error::{CommandError, Problem};
use crate::job::{self, JobRequest, Work};
use crate::ops::{Command, NamedMesh, Op, Symmetry};
use crate::recovery::Numbers;
use crate::selection::Selection;
use std::ops::ControlFlow;
use std::sync::Arc;

impl Editor {
    /// An editor on a document from a snapshot.
    pub(crate) fn restored(document: Document, selection: Arc<Selection>, numbers: Numbers) -> Self {
        let Numbers { next_object, revision, last_revision, saved } = numbers;
        let mut changes = Changes::default();
        document.objects.iter().for_each(|object| changes.added(object));
        (changes.selection, changes.materials) = (true, true);
        let mut editor =
            Self { document, selection, changes, next_object, revision, last_revision, saved, ..Self::new() };
        editor.restart_trail();
        editor
    }

    /// Makes everything count as changed in an editor that takes the place of another one: the changes are those from the
    /// other's document to this one's.
    pub fn take_place_of(&mut self, other: &Self) {
        self.changes = Changes { messages: true, ..Changes::default() };
        self.changes.replaced(&other.document.objects, &self.document.objects);
    }

    /// Where the editor goes on counting.
    pub(crate) fn numbers(&self) -> Numbers {
        Numbers {
            next_object: self.next_object,
            revision: self.revision,
            last_revision: self.last_revision,
            saved: self.saved,
        }
    }

    pub(crate) fn shared_selection(&self) -> &Arc<Selection> {
        &self.selection
    }

    /// The number of the next step, which counts as made now.
    pub(super) fn number_step(&mut self) -> u64 {
        self.next_step += 1;
        self.next_step - 1
    }

    /// The number that the next step will have.
    pub(crate) fn next_step(&self) -> u64 {
        self.next_step
    }

    pub(crate) fn forget_messages(&mut self) {
        self.messages.clear();
        self.changes.messages = true;
    }

    /// Selects something again, as a step or as more of the last one.
    pub(crate) fn replay_selection(&mut self, selection: &Selection, continues: bool) {
        self.finish_selecting();
        if continues {
            self.replace_selection(selection.clone());
        } else {
            self.set_selection(selection.clone());
        }
        self.log_selection(continues);
    }

    /// Carries out a command as its job did: on what was selected when it was given, and on objects that may have moved
    /// in the list or been renamed since.
    ///
    /// # Errors
    /// The command is refused, or an object doesn't exist.
    pub(crate) fn replay_job(&mut self, logged: LoggedJob) -> Result<(), CommandError> {
        let name = logged.command.name();
        self.repeat_job(logged).map_err(|problem| CommandError::of(name, problem))
    }

    fn repeat_job(&mut self, logged: LoggedJob) -> Result<(), Problem> {
        let (run, Prepared { ops, symmetry, inputs }) = self.prepare_job(logged)?;
        let made = job::run(&ops, symmetry, &inputs, &mut |_| ControlFlow::Continue(()))?;
        made.validate().map_err(|defect| broken(&defect))?;
        self.finish_run(run, made).map(drop).map_err(|error| Problem::new(error.problem))
    }

    /// Begins a command as its job was, if that takes long; [`Editor::finish`] ends it.
    ///
    /// # Errors
    /// As [`Editor::replay_job`].
    pub(crate) fn begin_logged_job(&mut self, logged: LoggedJob) -> Result<Option<JobRequest>, CommandError> {
        let name = logged.command.name();
        let (run, Prepared { ops, symmetry, inputs }) =
            self.prepare_job(logged).map_err(|problem| CommandError::of(name, problem))?;
        if Self::work(&ops, symmetry, &inputs) < MAX_ELEMENTS_AT_ONCE {
            return Ok(None);
        }
        let id = self.wait_for(WaitingFor::Run(Box::new(run)));
        Ok(Some(JobRequest { id, work: Work::Run(ops, symmetry, inputs) }))
    }

    fn prepare_job(&mut self, logged: LoggedJob) -> Result<(Run, Prepared), Problem> {
        let LoggedJob { command, selection, objects: places, at, names } = logged;
        let symmetry = command.symmetry;
        let object = |&place: &usize| self.document.objects.get(place).map(|object| object.id());
        let objects: Option<Vec<_>> = places.iter().map(object).collect();
        let objects = objects.ok_or_else(|| Problem::new("an object is missing"))?;
        let active =
            std::mem::replace(&mut self.document.active, places.first().copied().unwrap_or_default());
        let selected = std::mem::replace(&mut self.selection, selection.clone());
        let planned = self.plan(Command { object: None, ..command.clone() });
        self.document.active = active;
        self.selection = selected;
        let ops = match planned? {
            Planned::Whole { op, .. } => vec![op],
            Planned::Local { ops, .. } => ops,
            Planned::Document { .. } | Planned::Select { .. } => Vec::new(),
        };
        let op = ops.first().cloned().ok_or_else(|| Problem::new("this command is no job"))?;
        let mut inputs = self.inputs(&objects);
        for (input, name) in inputs.iter_mut().zip(names) {
            input.name = name;
        }
        let names = inputs.iter().map(|input| input.name.clone()).collect();
        let run = Run::new(command, selection, op, objects, at, names);
        Ok((run, Prepared { ops, symmetry, inputs }))
    }
}

/// A command that was carried out by a job, as the log has it: see [`Event::Job`](crate::recovery::Event::Job).
pub(crate) struct LoggedJob {
    pub command: Command,
    pub selection: Arc<Selection>,
    pub objects: Vec<usize>,
    pub at: usize,
    pub names: Vec<String>,
}

/// What a job needs.
struct Prepared {
    ops: Vec<Op>,
    symmetry: Symmetry,
    inputs: Vec<NamedMesh>,
}
