//! The editor: a document, its selection and its history, changed by commands.

mod adjust;
mod drag;
mod jobs;
mod select;
mod start;

pub use jobs::{Begun, Finished, RunningJob};
pub use select::SelectMode;

use crate::changes::Changes;
use crate::command::{Action, Command, Commit, Op, Output, Place, Target, edit_all};
use crate::document::{Counts, Document, Object, ObjectId};
use crate::error::{CommandError, Problem};
use crate::history::{Change, History, Step, is_reshaping};
use crate::job::{self, Made};
use crate::outcome::{self, Before, Elements, Outcome};
use crate::selection::Selection;
use formats::Import;
use halfedge::{Journal, Mesh, Touched};
use serde::Serialize;
use std::collections::{HashMap, VecDeque};
use std::ops::ControlFlow;
use std::sync::Arc;

/// The editor with no screen.
///
/// Reading is free; writing goes through commands, each of which succeeds as one undo step or
/// changes nothing.
#[derive(Debug)]
pub struct Editor {
    document: Document,
    selection: Arc<Selection>,
    history: History,
    changes: Changes,
    drag: Option<drag::Drag>,
    jobs: Vec<jobs::Waiting>,
    messages: VecDeque<Message>,
    next_object: u64,
    next_job: u64,
    /// The state of the document, the last one given to a state, and the one that was saved.
    revision: u64,
    last_revision: u64,
    saved: u64,
    /// The command of the last step, and the state that it led to.
    last: Option<(Command, u64)>,
    /// The numbers of each object's mesh, until the mesh changes.
    counts: std::sync::Mutex<HashMap<ObjectId, Counts>>,
}

/// Something to tell the user.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Message {
    /// How much it matters.
    pub kind: MessageKind,
    /// What to say.
    pub text: String,
}

/// How much a message matters.
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
    /// How many messages are kept.
    const MESSAGES: usize = 200;

    /// An editor with an empty document.
    pub fn new() -> Self {
        Self {
            document: Document { name: "Untitled".into(), ..Document::default() },
            selection: Arc::new(Selection::default()),
            history: History::new(),
            changes: Changes::default(),
            drag: None,
            jobs: Vec::new(),
            messages: VecDeque::new(),
            next_object: 1,
            next_job: 1,
            revision: 0,
            last_revision: 0,
            saved: 0,
            last: None,
            counts: Default::default(),
        }
    }

    /// An editor with a document of one object, with nothing to undo.
    pub fn with_mesh(name: impl Into<String>, mesh: Mesh) -> Self {
        let mut editor = Self::new();
        let name = name.into();
        editor.document.name.clone_from(&name);
        let object = editor.object(Output { name, mesh: Arc::new(mesh) });
        editor.changes.added(object.id());
        editor.document.objects.push(object);
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
        if self.messages.len() == Self::MESSAGES {
            self.messages.pop_front();
        }
        self.messages.push_back(Message { kind, text: text.into() });
        self.changes.messages = true;
    }

    /// What changed since this was last called.
    pub fn take_changes(&mut self) -> Changes {
        std::mem::take(&mut self.changes)
    }

    /// Whether the document is not as it was when it was opened or last saved.
    pub fn is_dirty(&self) -> bool {
        self.drag.is_some() || self.revision != self.saved
    }

    /// Says that the document as it is now has been saved.
    pub fn mark_saved(&mut self) {
        self.saved = self.revision;
        self.changes.document = true;
    }

    /// The numbers of an object's mesh; counted when asked for after a change.
    pub fn counts(&self, id: ObjectId) -> Option<Counts> {
        let object = self.document.object(id)?;
        let mut cache = self.counts.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        Some(*cache.entry(id).or_insert_with(|| Counts::of(object.mesh())))
    }

    // History.

    /// The labels of what can be undone, the next one last.
    pub fn undo_labels(&self) -> impl Iterator<Item = &str> {
        self.history.undo_labels()
    }

    /// The labels of what can be redone, the next one last.
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

    /// Takes the last step back and gives its label; none where there is nothing to undo. A drag
    /// that is going on is taken back instead.
    ///
    /// # Errors
    /// A job runs on a mesh that would change.
    pub fn undo(&mut self) -> Result<Option<String>, CommandError> {
        if let Some(label) = self.cancel_drag() {
            return Ok(Some(label));
        }
        if let Some(step) = self.history.next_undo() {
            self.refuse_while_busy("undo", &step.changes)?;
        }
        let Some(step) = self.history.take_undo() else { return Ok(None) };
        let label = step.label.clone();
        let back = self.travel(step);
        self.history.keep_redo(back);
        Ok(Some(label))
    }

    /// Makes the last undone step again and gives its label; none where there is nothing to redo.
    ///
    /// # Errors
    /// A job runs on a mesh that would change.
    pub fn redo(&mut self) -> Result<Option<String>, CommandError> {
        self.commit_drag();
        if let Some(step) = self.history.next_redo() {
            self.refuse_while_busy("redo", &step.changes)?;
        }
        let Some(step) = self.history.take_redo() else { return Ok(None) };
        let label = step.label.clone();
        let back = self.travel(step);
        self.history.keep_undo(back);
        Ok(Some(label))
    }

    /// Goes to the other side of a step and gives the step back.
    fn travel(&mut self, step: Step) -> Step {
        let changes = self.make(step.changes);
        let selection = std::mem::replace(&mut self.selection, step.selection);
        let revision = std::mem::replace(&mut self.revision, step.revision);
        self.changes.selection = true;
        self.changes.history = true;
        Step { label: step.label, changes, selection, revision }
    }

    /// Makes changes in order; gives those that take them back, in order.
    fn make(&mut self, changes: Vec<Change>) -> Vec<Change> {
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

    /// Adds the step that takes back what was just done.
    fn push_step(&mut self, label: String, back: Vec<Change>, before: Arc<Selection>) {
        let revision = self.revision;
        self.last_revision += 1;
        self.revision = self.last_revision;
        self.history.push(Step { label, changes: back, selection: before, revision });
        self.changes.history = true;
        self.changes.document = true;
    }

    // Running commands.

    /// Carries out a command at once, on this thread, as one undo step.
    ///
    /// # Errors
    /// Why it was refused, naming the op and the field; the document is then as it was.
    pub fn run(&mut self, command: Command) -> Result<Outcome, CommandError> {
        self.run_with(command, &mut |_| ControlFlow::Continue(()))
    }

    /// [`Editor::run`] with progress, which may stop it.
    ///
    /// # Errors
    /// As [`Editor::run`], and that it was cancelled.
    pub fn run_with(
        &mut self,
        command: Command,
        progress: &mut halfedge::Progress<'_>,
    ) -> Result<Outcome, CommandError> {
        self.commit_drag();
        let name = command.name();
        self.run_inner(command, progress).map_err(|problem| self.report(CommandError::of(name, problem)))
    }

    /// Whether a command would be carried out, as far as can be told without doing it: for a local
    /// edit all but whether positions stay finite (several at once are each looked at on the mesh as
    /// it is), for an operation on whole meshes whether its elements and objects exist.
    /// Costs what finding the elements costs; nothing is logged.
    ///
    /// # Errors
    /// Why it would be refused.
    pub fn can(&self, command: Command) -> Result<(), CommandError> {
        let name = command.name();
        let check = || match self.plan(command)? {
            Planned::Local { object, ops } => {
                let gone = || Problem::new("the object is gone");
                let mesh = self.document.object(object).ok_or_else(gone)?.mesh();
                ops.iter().try_for_each(|op| match op.action() {
                    Action::Local(edit) => edit.can(mesh),
                    Action::WholeMesh(_) | Action::Document(_) => Ok(()),
                })
            }
            Planned::Whole { .. } | Planned::Document { .. } => Ok(()),
        };
        check().map_err(|problem| CommandError::of(name, problem))
    }

    /// Logs a refusal.
    fn report(&mut self, error: CommandError) -> CommandError {
        if !error.is_cancelled() {
            self.say(MessageKind::Error, error.to_string());
        }
        error
    }

    fn run_inner(
        &mut self,
        command: Command,
        progress: &mut halfedge::Progress<'_>,
    ) -> Result<Outcome, Problem> {
        let planned = self.plan(command.clone())?;
        let outcome = self.carry_out(planned, progress)?;
        self.remember(command);
        Ok(outcome)
    }

    fn carry_out(
        &mut self,
        planned: Planned,
        progress: &mut halfedge::Progress<'_>,
    ) -> Result<Outcome, Problem> {
        match planned {
            Planned::Local { object, ops } => {
                let before = self.selection.clone();
                let done = self.edit(object, &ops)?;
                let (spec, back) = (ops.first().map(Op::spec), vec![Change::Journal(object, done.journal)]);
                self.push_step(spec.map_or_else(String::new, |s| s.label.to_owned()), back, before);
                Ok(Outcome { warnings: done.notes, ..Self::outcome(&ops, done.created, done.removed) })
            }
            Planned::Whole { op, objects, at } => {
                let inputs = self.inputs(&objects);
                let made = job::run(std::slice::from_ref(&op), &inputs, progress)?;
                drop(inputs);
                self.commit_whole(op, &objects, at, made)
            }
            Planned::Document { op, changes } => {
                let before = self.selection.clone();
                let active = self.document.active().map(Object::id);
                let back = self.make(changes);
                if self.document.active().map(Object::id) != active {
                    self.selection = Arc::new(Selection::new(before.kind()));
                    self.changes.selection = true;
                }
                if !back.is_empty() {
                    self.push_step(op.spec().label.to_owned(), back, before);
                }
                Ok(Self::outcome(&[op], Elements::default(), Elements::default()))
            }
        }
    }

    /// Finds out what a command has to do, without doing it.
    fn plan(&self, command: Command) -> Result<Planned, Problem> {
        let place = Place { document: &self.document, object: command.object };
        if let Action::Document(edit) = command.op.action() {
            let changes = edit.changes(&place)?;
            self.check_busy(&changes)?;
            return Ok(Planned::Document { op: command.op, changes });
        }
        let empty = Selection::default();
        let nothing = Mesh::new();
        // `new` alone needs no object.
        let target = match place.index() {
            Ok(at) => self.document.objects.get(at),
            Err(problem) if command.object.is_some() => return Err(problem),
            Err(_) => None,
        };
        let is_active = target.is_some() && target.map(Object::id) == self.document.active().map(Object::id);
        let against = Target {
            mesh: target.map_or(&nothing, Object::mesh),
            selection: if is_active { &self.selection } else { &empty },
        };
        let mut ops = command.op.resolve(&against)?;
        if let [op] = ops.as_slice()
            && let Action::WholeMesh(whole) = op.action()
        {
            let objects = whole.objects(&place)?;
            for &id in &objects {
                self.check_idle(id)?;
            }
            if whole.commit() == Commit::NewDocument {
                for object in &self.document.objects {
                    self.check_idle(object.id())?;
                }
            }
            let at = place.index().unwrap_or(0);
            return match ops.pop() {
                Some(op) => Ok(Planned::Whole { op, objects, at }),
                None => Err(Problem::new("there is nothing to do")),
            };
        }
        let object = place.object()?.id();
        self.check_idle(object)?;
        Ok(Planned::Local { object, ops })
    }

    /// The meshes of objects, shared.
    fn inputs(&self, objects: &[ObjectId]) -> Vec<crate::command::Input> {
        objects
            .iter()
            .filter_map(|&id| self.document.object(id))
            .map(|object| crate::command::Input { name: object.name.clone(), mesh: object.mesh.clone() })
            .collect()
    }

    /// Makes local edits on an object in one transaction, validated; all or nothing.
    fn edit(&mut self, id: ObjectId, ops: &[Op]) -> Result<Edited, Problem> {
        let at = self.document.index_of(id).ok_or_else(|| Problem::new("the object is gone"))?;
        let object = self.document.objects.get_mut(at).ok_or_else(|| Problem::new("the object is gone"))?;
        let mesh = Arc::make_mut(&mut object.mesh);
        let before = Before::of(mesh);
        let mut notes = Vec::new();
        let ((), journal) =
            mesh.transaction(|mesh| edit_all(ops, mesh, &mut notes, &mut |_| ControlFlow::Continue(())))?;
        let touched = journal.touched();
        if let Err(defect) = validate_touched(mesh, &touched) {
            mesh.undo(journal);
            return Err(broken(&defect.to_string()));
        }
        let (created, removed) = before.compare(mesh, &touched);
        let reshaped = is_reshaping(&touched) || created.vertices.len() + removed.vertices.len() > 0;
        self.changes.touched(id, mesh, touched);
        if reshaped {
            self.forget_counts(id);
        }
        if self.document.active == at {
            self.drop_gone_from_selection();
        }
        Ok(Edited { journal, created: created.into(), removed: removed.into(), notes })
    }

    /// Puts what a whole-mesh operation made into the document, as one step.
    fn commit_whole(
        &mut self,
        op: Op,
        objects: &[ObjectId],
        at: usize,
        made: Made,
    ) -> Result<Outcome, Problem> {
        let Made::Meshes(outputs, ids, notes) = made else {
            return Err(Problem::internal("the result is of another job"));
        };
        for output in &outputs {
            output.mesh.validate().map_err(|defect| broken(&defect.to_string()))?;
        }
        let commit = match op.action() {
            Action::WholeMesh(whole) => whole.commit(),
            Action::Local(_) | Action::Document(_) => Commit::Replace,
        };
        let sizes = |meshes: &mut dyn Iterator<Item = &Mesh>| {
            meshes.fold([0; 3], |sum, mesh| {
                let size = outcome::sizes(mesh);
                std::array::from_fn(|i| sum[i] + size[i])
            })
        };
        let after = sizes(&mut outputs.iter().map(|output| &*output.mesh));
        let removed_all = commit == Commit::NewDocument;
        let before = sizes(
            &mut self
                .document
                .objects
                .iter()
                .filter(|object| removed_all || objects.contains(&object.id()))
                .map(Object::mesh),
        );
        let (created, removed) = match ids {
            Some((created, removed)) => (created.into(), removed.into()),
            None => (Elements::gained(before, after), Elements::gained(after, before)),
        };
        let keeps_ids = created.ids.is_some();
        let changes = self.changes_for(commit, objects, at, outputs)?;
        let selection = self.selection.clone();
        let back = self.make(changes);
        if keeps_ids {
            self.drop_gone_from_selection();
        } else {
            self.selection = Arc::new(Selection::new(selection.kind()));
            self.changes.selection = true;
        }
        self.push_step(op.spec().label.to_owned(), back, selection);
        Ok(Outcome { warnings: notes, ..Self::outcome(&[op], created, removed) })
    }

    fn changes_for(
        &mut self,
        commit: Commit,
        objects: &[ObjectId],
        at: usize,
        outputs: Vec<Output>,
    ) -> Result<Vec<Change>, Problem> {
        let mut outputs = outputs.into_iter();
        let first = outputs.next().ok_or_else(|| Problem::internal("the operation made nothing"))?;
        let mut changes = Vec::new();
        match commit {
            Commit::Replace | Commit::Join => {
                let gone = || Problem::new("the object is gone");
                let target = *objects.first().ok_or_else(gone)?;
                let index = self.document.index_of(target).ok_or_else(gone)?;
                changes.push(Change::Mesh(target, first.mesh));
                if !first.name.is_empty() {
                    changes.push(Change::Name(target, first.name));
                }
                if commit == Commit::Join {
                    let mut places: Vec<usize> =
                        objects.iter().skip(1).filter_map(|&id| self.document.index_of(id)).collect();
                    places.sort_unstable();
                    let before = places.iter().filter(|&&place| place < index).count();
                    changes.extend(places.into_iter().rev().map(Change::Remove));
                    changes.push(Change::Active(index - before));
                } else {
                    for (offset, output) in outputs.enumerate() {
                        let object = self.object(output);
                        changes.push(Change::Insert(index + 1 + offset, Box::new(object)));
                    }
                    if changes.len() > 1 && self.document.active > index {
                        let inserted = changes.iter().filter(|c| matches!(c, Change::Insert(..))).count();
                        changes.push(Change::Active(self.document.active + inserted));
                    }
                }
            }
            Commit::NewDocument => {
                changes.extend((0..self.document.objects.len()).rev().map(Change::Remove));
                changes.push(Change::DocumentName(first.name.clone()));
                let object = self.object(first);
                changes.push(Change::Insert(0, Box::new(object)));
                changes.push(Change::Active(0));
            }
            Commit::NewObject => {
                let place = if self.document.objects.is_empty() { 0 } else { at + 1 };
                let object = self.object(first);
                changes.push(Change::Insert(place, Box::new(object)));
                changes.push(Change::Active(place));
            }
        }
        Ok(changes)
    }

    fn object(&mut self, output: Output) -> Object {
        let id = ObjectId(self.next_object);
        self.next_object += 1;
        Object::new(id, output.name, output.mesh)
    }

    fn outcome(ops: &[Op], created: Elements, removed: Elements) -> Outcome {
        ops.first().map_or_else(Outcome::default, |op| Outcome::new(op.spec().name, created, removed))
    }

    /// Opens what was read in place of the document, as one step: undo brings the other one back.
    ///
    /// # Errors
    /// A mesh that is not valid, which a reader never makes.
    pub fn open(&mut self, import: Import) -> Result<Outcome, CommandError> {
        self.commit_drag();
        for object in &import.objects {
            object.mesh.validate().map_err(|defect| {
                let problem = broken(&format!("{}: {defect}", object.name));
                self.report(CommandError::of("open", problem))
            })?;
        }
        // What runs on objects that go has nowhere to put its result.
        if !self.jobs.is_empty() {
            self.jobs.clear();
            self.changes.jobs = true;
        }
        let mut changes: Vec<Change> = (0..self.document.objects.len()).rev().map(Change::Remove).collect();
        changes.push(Change::DocumentName(import.name.clone()));
        let mut size = [0; 3];
        for (at, imported) in import.objects.into_iter().enumerate() {
            let own = outcome::sizes(&imported.mesh);
            size = std::array::from_fn(|i| size[i] + own[i]);
            let object = self.object(Output { name: imported.name, mesh: Arc::new(imported.mesh) });
            changes.push(Change::Insert(at, Box::new(object)));
        }
        changes.push(Change::Active(0));
        let before = self.selection.clone();
        let back = self.make(changes);
        self.selection = Arc::new(Selection::new(before.kind()));
        self.changes.selection = true;
        self.push_step("Open".into(), back, before);
        self.saved = self.revision;
        let created = Elements::gained([0; 3], size);
        let message = outcome::message(&format!("Open {}", import.name), &created, &Elements::default());
        let warnings: Vec<String> = import.report.warnings().map(str::to_owned).collect();
        self.say(MessageKind::Info, message.clone());
        for note in import.report.notes() {
            let kind = match note.severity {
                formats::Severity::Info => MessageKind::Info,
                formats::Severity::Warning => MessageKind::Warning,
            };
            self.say(kind, note.text.clone());
        }
        Ok(Outcome { op: "open".into(), created, removed: Elements::default(), message, warnings })
    }
}

/// What a command has to do.
enum Planned {
    Local { object: ObjectId, ops: Vec<Op> },
    Whole { op: Op, objects: Vec<ObjectId>, at: usize },
    Document { op: Op, changes: Vec<Change> },
}

/// What local edits did.
struct Edited {
    journal: Journal,
    created: Elements,
    removed: Elements,
    notes: Vec<String>,
}

fn broken(defect: &str) -> Problem {
    Problem::internal(format!(
        "the result broke a rule of the mesh ({defect}), so nothing was changed; this is an error in Meshwright"
    ))
}

/// Validates what an edit touched, and what lies at the half-edges it touched.
fn validate_touched(mesh: &Mesh, touched: &Touched) -> Result<(), halfedge::Defect> {
    if touched.everything {
        return mesh.validate();
    }
    let mut vertices = touched.vertices.clone();
    let mut faces = touched.faces.clone();
    for &h in touched.halfedges.iter().filter(|h| mesh.has_halfedge(**h)) {
        vertices.push(mesh.to(h));
        faces.extend(mesh.face_of(h));
    }
    vertices.sort_unstable();
    vertices.dedup();
    faces.sort_unstable();
    faces.dedup();
    mesh.validate_near(vertices, faces)
}
