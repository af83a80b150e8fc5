//! The editor: a document, its selection and its history, changed by commands.

mod adjust;
mod begun;
mod commit;
mod export;
mod forget;
mod images;
mod jobs;
mod jump;
mod kept_images;
mod logged;
mod ongoing;
mod open;
mod open_project;
mod result;
mod run;
mod select;
mod select_by;
mod selecting;
mod start;

pub use begun::{Begun, Finished, RunningJob};
pub use jobs::MAX_ELEMENTS_AT_ONCE;
pub use jump::Jump;
pub(crate) use logged::LoggedJob;
pub use select_by::SelectBy;
pub(crate) use select_by::find_related;

use crate::changes::Changes;
use crate::document::{Counts, Document, Object, ObjectId};
use crate::error::CommandError;
use crate::history::{Change, History, Step};
use crate::outcome::Outcome;
use crate::project::Trail;
use crate::recovery::{Event, Log, Snapshot};

use crate::selection::Selection;
use formats::NamedMesh;
use halfedge::Mesh;
use serde::Serialize;
use std::collections::{HashMap, VecDeque};
use std::sync::Arc;

/// The editor without a screen.
///
/// Reading is unrestricted. Every change goes through a command, which succeeds as one undo step or changes
/// nothing.
#[derive(Debug)]
pub struct Editor {
    document: Document,
    selection: Arc<Selection>,
    /// The stroke that the last change of the selection was part of.
    stroke: Option<u64>,
    history: History,
    changes: Changes,
    ongoing: Option<ongoing::Ongoing>,
    selecting: Option<selecting::Selecting>,
    jumping: Option<Jump>,
    selected: Option<Outcome>,
    jobs: Vec<jobs::Waiting>,
    messages: VecDeque<Message>,
    next_object: u64,
    next_job: u64,
    /// The document's current revision, the highest one given out, and the one that was saved.
    revision: u64,
    last_revision: u64,
    saved: u64,
    /// The number of the next step of the history.
    next_step: u64,
    /// What is done, if it is logged.
    pub(crate) log: Option<Log>,
    /// What led to the document as it is now, for project files.
    pub(crate) trail: Trail,
    /// The last state of the viewport that was logged.
    pub(crate) view: Option<String>,
    /// The command that can be adjusted.
    last: Option<adjust::Last>,
    images: kept_images::KeptImages,
    /// The counts of each object's mesh, kept until the mesh changes.
    counts: std::sync::Mutex<HashMap<ObjectId, Counts>>,
}

/// Something to tell the user.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Message {
    /// How important it is.
    pub kind: MessageKind,
    /// What to say.
    pub text: String,
}

/// How important a message is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum MessageKind {
    /// Something was done.
    Info,
    /// Something was changed or left out.
    Warning,
    /// Something was refused or failed.
    Error,
}

impl Default for Editor {
    fn default() -> Self {
        Self::new()
    }
}

impl Editor {
    /// The number of messages kept.
    const MAX_MESSAGES: usize = 200;

    /// An editor with an empty document.
    pub fn new() -> Self {
        Self {
            document: Document::untitled(),
            selection: Arc::new(Selection::default()),
            stroke: None,
            history: History::new(),
            changes: Changes::default(),
            ongoing: None,
            selecting: None,
            jumping: None,
            selected: None,
            jobs: Vec::new(),
            messages: VecDeque::new(),
            next_object: 1,
            next_job: 1,
            revision: 0,
            last_revision: 0,
            saved: 0,
            next_step: 0,
            log: None,
            trail: Trail::from(Some(Snapshot::empty()), 0),
            view: None,
            last: None,
            images: Default::default(),
            counts: Default::default(),
        }
    }

    /// An editor with a document of one object and nothing to undo.
    pub fn with_mesh(name: impl Into<String>, mesh: Mesh) -> Self {
        let mut editor = Self::new();
        let name = name.into();
        editor.document.name.clone_from(&name);
        let object = editor.object(NamedMesh::new(name, mesh));
        editor.changes.added(&object);
        editor.document.objects.push(object);
        editor.restart_trail();
        editor
    }

    /// The document.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// The selection, on the active object.
    pub fn selection(&self) -> &Selection {
        &self.selection
    }

    /// The mesh of the active object.
    pub fn mesh(&self) -> Option<&Mesh> {
        self.document.active().map(Object::mesh)
    }

    /// The messages, the latest last.
    pub fn messages(&self) -> impl DoubleEndedIterator<Item = &Message> + ExactSizeIterator {
        self.messages.iter()
    }

    /// Adds a message.
    pub fn say(&mut self, kind: MessageKind, text: impl Into<String>) {
        if self.messages.len() == Self::MAX_MESSAGES {
            self.messages.pop_front();
        }
        self.messages.push_back(Message { kind, text: text.into() });
        self.changes.messages = true;
    }

    /// The changes since the last call.
    pub fn take_changes(&mut self) -> Changes {
        std::mem::take(&mut self.changes)
    }

    /// Whether the document differs from what was opened or last saved.
    pub fn is_dirty(&self) -> bool {
        (self.is_editing() && !self.is_previewing_mesh()) || self.revision != self.saved
    }

    /// The document's revision: an edit leads to a new one, undo and redo return to earlier ones.
    pub fn revision(&self) -> u64 {
        self.revision
    }

    /// Records that this revision of the document has been saved.
    pub fn mark_saved(&mut self, revision: u64) {
        self.saved = revision;
        self.changes.document = true;
        self.log(Event::Saved(revision));
    }

    /// The counts of an object's mesh, computed on the first request after a change.
    pub fn counts(&self, id: ObjectId) -> Option<Counts> {
        let object = self.document.object(id)?;
        let mut cache = self.counts.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        Some(*cache.entry(id).or_insert_with(|| Counts::of(object.mesh())))
    }

    /// The last state of the viewport that was logged or came with a project, in the page's own JSON.
    pub fn view(&self) -> Option<&str> {
        self.view.as_deref()
    }

    // History.

    /// The labels of the edits that can be undone, the next one last.
    pub fn undo_labels(&self) -> impl Iterator<Item = &str> {
        self.history.undo_labels()
    }

    /// The labels of the edits that can be redone, the next one last.
    pub fn redo_labels(&self) -> impl Iterator<Item = &str> {
        self.history.redo_labels()
    }

    /// The memory that undo and redo take, in bytes.
    pub fn history_bytes(&self) -> usize {
        self.history.bytes()
    }

    /// The memory that undo and redo may take, in bytes; the latest step is kept whatever its size.
    pub fn history_limit(&self) -> usize {
        self.history.limit()
    }

    /// Sets [`Editor::history_limit`], dropping the oldest steps that no longer fit.
    pub fn set_history_limit(&mut self, bytes: usize) {
        self.history.set_limit(bytes);
        self.changes.history = true;
    }

    /// What [`Editor::undo_step`] would undo: the label of the last edit or of a change of the selection since.
    pub fn next_undo(&self) -> Option<&str> {
        self.history.next_undo().map(|step| step.label.as_str())
    }

    /// What [`Editor::redo_step`] would redo.
    pub fn next_redo(&self) -> Option<&str> {
        self.history.next_redo().map(|step| step.label.as_str())
    }

    /// Undoes the last edit and returns its label; none if there is nothing to undo. Changes of the selection since
    /// are forgotten. If an edit is ongoing, cancels that instead.
    ///
    /// # Errors
    /// A job is running on a mesh that would change.
    pub fn undo(&mut self) -> Result<Option<String>, CommandError> {
        self.finish_parts();
        if self.is_editing() {
            return Ok(self.cancel_edit());
        }
        if self.undo_labels().next().is_none() {
            return Ok(None);
        }
        if let Some(edit) = self.history.steps_back(1).last() {
            self.refuse_while_busy("undo", &edit.changes)?;
        }
        self.history.forget_selections();
        self.undo_one(Event::Undo)
    }

    /// Undoes the last edit or change of the selection, whichever is later, and returns its label; none if there is
    /// nothing to undo. If an edit is ongoing, cancels that instead.
    ///
    /// # Errors
    /// A job is running on a mesh that would change.
    pub fn undo_step(&mut self) -> Result<Option<String>, CommandError> {
        self.finish_parts();
        if let Some(label) = self.cancel_edit() {
            return Ok(Some(label));
        }
        self.undo_one(Event::UndoStep)
    }

    fn undo_one(&mut self, event: Event) -> Result<Option<String>, CommandError> {
        if let Some(step) = self.history.next_undo() {
            self.refuse_while_busy("undo", &step.changes)?;
        }
        let Some(step) = self.history.take_undo() else { return Ok(None) };
        let (label, number) = (step.label.clone(), step.number);
        let back = self.reverse(step);
        self.history.keep_redo(back);
        self.log_reversed(number, event);
        Ok(Some(label))
    }

    /// Redoes the last undone edit and returns its label; none if there is nothing to redo. Undone changes of the
    /// selection before it are forgotten.
    ///
    /// # Errors
    /// A job is running on a mesh that would change.
    pub fn redo(&mut self) -> Result<Option<String>, CommandError> {
        self.end_edit();
        if self.redo_labels().next().is_none() {
            return Ok(None);
        }
        if let Some(edit) = self.history.steps_forward(1).last() {
            self.refuse_while_busy("redo", &edit.changes)?;
        }
        self.history.forget_selections_to_redo();
        self.redo_one(Event::Redo)
    }

    /// Redoes the last undone edit or change of the selection and returns its label; none if there is nothing to redo.
    ///
    /// # Errors
    /// A job is running on a mesh that would change.
    pub fn redo_step(&mut self) -> Result<Option<String>, CommandError> {
        self.end_edit();
        self.redo_one(Event::RedoStep)
    }

    fn redo_one(&mut self, event: Event) -> Result<Option<String>, CommandError> {
        if let Some(step) = self.history.next_redo() {
            self.refuse_while_busy("redo", &step.changes)?;
        }
        let Some(step) = self.history.take_redo() else { return Ok(None) };
        let (label, number) = (step.label.clone(), step.number);
        let back = self.reverse(step);
        self.history.keep_undo(back);
        self.log_reversed(number, event);
        Ok(Some(label))
    }

    /// Applies the changes of a step and returns the inverse step.
    fn reverse(&mut self, step: Step) -> Step {
        self.stroke = None;
        let changes = self.apply(step.changes);
        let selection = std::mem::replace(&mut self.selection, step.selection);
        let revision = std::mem::replace(&mut self.revision, step.revision);
        self.changes.selection = true;
        self.changes.history = true;
        Step { label: step.label, changes, selection, revision, number: step.number }
    }

    /// Applies changes in order; returns their inverses in the order in which to apply them.
    fn apply(&mut self, changes: Vec<Change>) -> Vec<Change> {
        let mut back = Vec::with_capacity(changes.len());
        let counts = self.counts.get_mut().unwrap_or_else(std::sync::PoisonError::into_inner);
        for change in changes {
            let reshaped = |id| {
                counts.remove(&id);
            };
            back.extend(change.make(&mut self.document, &mut self.changes, reshaped));
        }
        back.reverse();
        back
    }

    fn forget_counts(&mut self, id: ObjectId) {
        self.counts.get_mut().unwrap_or_else(std::sync::PoisonError::into_inner).remove(&id);
    }

    /// Adds the undo step of what was just done, unless nothing changed; returns whether it added one.
    fn push_step(&mut self, label: String, mut back: Vec<Change>, before: Arc<Selection>) -> bool {
        if back.is_empty() {
            return false;
        }
        for change in &mut back {
            if let Change::Journal(id, journal) = change
                && let Some(object) = self.document.object(*id)
            {
                journal.fold_moves(object.mesh());
            }
        }
        let revision = self.revision;
        self.last_revision += 1;
        self.revision = self.last_revision;
        let number = self.number_step();
        self.history.push(Step { label, changes: back, selection: before, revision, number });
        self.changes.history = true;
        self.changes.document = true;
        true
    }
}
