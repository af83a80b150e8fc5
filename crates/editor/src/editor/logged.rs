//! What the log of changes needs of an editor, and replaying it.

use super::Editor;
use super::jobs::Run;
use super::run::Planned;
use crate::changes::Changes;
use crate::document::Document;
use crate::error::{CommandError, Problem};
use crate::ops::Command;
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
    /// in the list since.
    ///
    /// # Errors
    /// The command is refused, or an object doesn't exist.
    pub(crate) fn replay_job(
        &mut self,
        command: Command,
        selection: Arc<Selection>,
        objects: &[usize],
        at: usize,
    ) -> Result<(), CommandError> {
        let name = command.name();
        self.run_as_job(command, selection, objects, at).map_err(|problem| CommandError::of(name, problem))
    }

    fn run_as_job(
        &mut self,
        command: Command,
        selection: Arc<Selection>,
        places: &[usize],
        at: usize,
    ) -> Result<(), Problem> {
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
        let made = self.compute_all(&ops, symmetry, &objects, &mut |_| ControlFlow::Continue(()))?;
        let run = Run::new(command, selection, op, objects, at);
        self.finish_run(run, made).map(drop).map_err(|error| Problem::new(error.problem))
    }
}
