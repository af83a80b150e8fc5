//! Opening models read from files.

use super::jobs::WaitingFor;
use super::run::broken;
use super::{Editor, MessageKind};
use crate::Task;
use crate::bezier::fill_previews;
use crate::error::{CommandError, Problem, not_opened};
use crate::history::Change;
use crate::outcome::{self, Elements, Outcome};
use crate::recovery::Event;
use crate::selection::Selection;
use formats::{Import, ImportReport};
use std::sync::Arc;

impl Editor {
    /// Replaces the document by an import, as one step: undo restores the previous document.
    ///
    /// # Errors
    /// A mesh is invalid, which no reader produces, or a Bezier surface has too many patches.
    pub fn open(&mut self, mut import: Import) -> Result<Outcome, CommandError> {
        fill_previews(&mut import).map_err(|problem| self.report(CommandError::of(Task::Open, problem)))?;
        for object in &import.model.objects {
            object.mesh.validate().map_err(|defect| {
                let why = broken(&defect.to_string()).text;
                let problem = Problem::internal(not_opened(&object.name, &why));
                self.report(CommandError::of(Task::Open, problem))
            })?;
        }
        Ok(self.open_valid(import))
    }

    /// Gives the document the name of the file that it was saved as. That is no step of the history.
    pub fn rename_document(&mut self, name: &str) {
        if self.document.name != name {
            name.clone_into(&mut self.document.name);
            self.changes.document = true;
            self.log(Event::Name(name.to_owned()));
        }
    }

    /// Opens an import whose meshes are known to be valid.
    pub(super) fn open_valid(&mut self, import: Import) -> Outcome {
        self.end_edit();
        // Jobs on objects that are removed have nowhere to put their results. Later imports replace the document in turn.
        self.jobs.retain(|job| matches!(job.kind, WaitingFor::Open));
        self.changes.jobs = true;
        let mut changes: Vec<Change> = (0..self.document.objects.len()).rev().map(Change::Remove).collect();
        let Import { model, report } = import;
        let model_name = model.name.clone();
        changes.push(self.another_document(true));
        changes.push(Change::DocumentName(model.name.clone()));
        changes.push(Change::Offset(model.offset));
        changes.push(Change::Materials(model.materials));
        let size = outcome::sizes(model.objects.iter().map(|imported| imported.mesh.as_ref()));
        for (at, imported) in model.objects.into_iter().enumerate() {
            let object = self.object(imported);
            changes.push(Change::Insert(at, Box::new(object)));
        }
        changes.push(Change::Active(0));
        let before = self.selection.clone();
        let back = self.apply(changes);
        self.selection = Arc::new(Selection::new(before.kind()));
        self.changes.selection = true;
        self.push_step(format!("Open {model_name}"), back, before);
        self.saved = self.revision;
        self.view = None;
        self.log(Event::Break);
        self.say_opened(&model_name, size, &report)
    }

    /// Says what was opened, and gives the outcome.
    pub(super) fn say_opened(&mut self, name: &str, size: [usize; 3], report: &ImportReport) -> Outcome {
        let created = Elements::gained([0; 3], size);
        let contents = created.words().map_or_else(String::new, |words| format!(": {words}"));
        let message = format!("Opened {name}{contents}");
        let warnings: Vec<String> = report.warnings().map(str::to_owned).collect();
        self.say(MessageKind::Info, message.clone());
        for note in report.notes() {
            let kind = match note.severity {
                formats::Severity::Info => MessageKind::Info,
                formats::Severity::Warning => MessageKind::Warning,
            };
            self.say(kind, note.text.clone());
        }
        let report = report.notes().to_vec();
        Outcome { op: Task::Open, created, removed: Elements::default(), message, warnings, report }
    }
}
