//! Running commands: each is planned, then carried out as one step, or refused with nothing changed.

use super::Editor;
use super::MessageKind;
use super::result::validate_touched;
use crate::document::{Object, ObjectId};
use crate::error::{CommandError, Problem};
use crate::history::{Change, is_reshaping};
use crate::job::face_sources;
use crate::ops::{
    Action, Command, Commit, LocalEdit, NamedMesh, Op, OpId, Place, Symmetry, Target, edit_local,
    refuse_bezier,
};
use crate::outcome::{Before, Elements, Outcome};
use crate::recovery::Event;
use crate::selection::Selection;
use halfedge::words::counted;
use halfedge::{InParts, Mesh};
use std::ops::ControlFlow;
use std::sync::Arc;
use surface::selecting::Finding;

/// The name of the step of `isolate` that shows everything again.
const LEAVE_ISOLATION: &str = "Leave isolation";

/// The work that a command resolves to.
pub(super) enum Planned {
    /// `selects` says whether the result is selected: where the selection gave the elements.
    Local {
        object: ObjectId,
        ops: Vec<Op>,
        symmetry: Symmetry,
        selects: bool,
    },
    Whole {
        op: Op,
        objects: Vec<ObjectId>,
        at: usize,
    },
    Document {
        op: Op,
        changes: Vec<Change>,
    },
    Select {
        op: Op,
        find: Box<Finding>,
    },
}

/// The result of local edits.
pub(super) struct Edited {
    /// The changes that undo them, in order.
    pub back: Vec<Change>,
    pub created: Elements,
    pub removed: Elements,
    pub notes: Vec<String>,
}

impl Editor {
    /// Carries out a command at once, on this thread, as one undo step.
    ///
    /// # Errors
    /// The command is refused; the error names the operation and the field, and the document is unchanged.
    pub fn run(&mut self, command: Command) -> Result<Outcome, CommandError> {
        self.run_with(command, &mut |_| ControlFlow::Continue(()))
    }

    /// [`Editor::run`] with progress, which can cancel the command.
    ///
    /// # Errors
    /// As [`Editor::run`], or the command was cancelled.
    pub fn run_with(
        &mut self,
        command: Command,
        progress: &mut halfedge::Progress<'_>,
    ) -> Result<Outcome, CommandError> {
        self.end_edit();
        let name = command.name();
        self.run_inner(command, progress).map_err(|problem| self.report(CommandError::of(name, problem)))
    }

    /// Whether a command would be carried out and change something: the single answer that menus, buttons
    /// and keys use. It is as exact as possible without running the command. For a local edit it checks
    /// everything except whether positions stay finite; of several edits in one step it checks the first, on
    /// which the others build. For an operation on whole meshes it checks only that its elements and objects
    /// exist.
    ///
    /// Costs O(mesh) at most. If a selection has more than [`Editor::MAX_CHECKED_SELECTION`] elements, or
    /// an edit would run as a job, only the kind of element is checked. Logs nothing.
    ///
    /// # Errors
    /// The command would be refused or change nothing; [`CommandError::reason`] gives the sentence for a
    /// tooltip.
    pub fn can(&self, command: &Command) -> Result<(), CommandError> {
        self.check(command).map_err(|problem| CommandError::of(command.name(), problem))
    }

    /// The largest selection of which [`Editor::can`] checks each element.
    pub const MAX_CHECKED_SELECTION: usize = 1000;

    fn check(&self, command: &Command) -> Result<(), Problem> {
        let op = &command.op;
        if op.is_open() && self.selection.len() > Self::MAX_CHECKED_SELECTION {
            let place = self.place(command);
            let object = place.object()?;
            refuse_bezier(object.name(), object.bezier())?;
            self.check_idle(object.id())?;
            return op.check_selection(&self.target(&place, &Selection::default(), &Mesh::new())?);
        }
        match self.plan(command.clone())? {
            Planned::Local { object, ops, symmetry, .. } => {
                let mesh = self.document.object(object).ok_or_else(object_gone)?.mesh();
                if self.is_small(&ops, symmetry, &[object])
                    && let Some(first) = local_edits(&ops).next()
                {
                    first.can(mesh)?;
                }
                let idle = local_edits(&ops).map(|edit| edit.changes_nothing(mesh));
                nothing_to_do(idle.reduce(Option::and).flatten())
            }
            Planned::Whole { op, objects, .. } => match op.action() {
                Action::WholeMesh(whole) => nothing_to_do(whole.changes_nothing(&self.inputs(&objects))),
                Action::Local(_) | Action::Document(_) | Action::Select(_) => Ok(()),
            },
            Planned::Document { op, .. } => match op.action() {
                Action::Document(edit) => nothing_to_do(edit.changes_nothing(&self.place(command))),
                Action::Local(_) | Action::WholeMesh(_) | Action::Select(_) => Ok(()),
            },
            Planned::Select { .. } => Ok(()),
        }
    }

    /// Logs a refusal.
    pub(super) fn report(&mut self, error: CommandError) -> CommandError {
        if !error.is_cancelled() {
            self.say(MessageKind::Error, error.message());
        }
        error
    }

    fn run_inner(
        &mut self,
        command: Command,
        progress: &mut halfedge::Progress<'_>,
    ) -> Result<Outcome, Problem> {
        let planned = self.plan(command.clone())?;
        self.carry_out(command, planned, progress)
    }

    /// Carries out a command's plan and remembers the command as the last one.
    pub(super) fn carry_out(
        &mut self,
        command: Command,
        planned: Planned,
        progress: &mut halfedge::Progress<'_>,
    ) -> Result<Outcome, Problem> {
        if matches!(planned, Planned::Select { .. }) {
            let before = self.selection.clone();
            let outcome = self.carry_out_step(planned, progress)?;
            self.log(Event::Run(command.clone()));
            self.remember_selecting(command, &before);
            return Ok(outcome);
        }
        let before = self.revision;
        let outcome = self.carry_out_step(planned, progress)?;
        // A command that changed nothing made no step, so there is nothing to adjust.
        if self.revision != before {
            self.log(Event::Run(command.clone()));
            self.remember(command);
        }
        Ok(outcome)
    }

    fn carry_out_step(
        &mut self,
        planned: Planned,
        progress: &mut halfedge::Progress<'_>,
    ) -> Result<Outcome, Problem> {
        match planned {
            Planned::Local { object, ops, symmetry, selects } => {
                let op = ops.first().ok_or_else(|| Problem::internal("the command acts on nothing"))?;
                let before = self.selection.clone();
                let done = self.edit(object, &ops, symmetry, selects)?;
                let outcome = Self::outcome(op, done.created, done.removed);
                let is_step = self.push_step(op.label().to_owned(), done.back, before);
                let outcome = if is_step { outcome } else { outcome.unchanged() };
                Ok(Outcome { warnings: done.notes, ..outcome })
            }
            Planned::Whole { op, objects, at } => {
                let made = self.compute(&op, &objects, progress)?;
                self.commit_whole(&op, &objects, at, made)
            }
            Planned::Document { op, changes } => {
                let before = self.selection.clone();
                let hides = matches!(changes.as_slice(), [Change::Hidden(..)]);
                let back = self.apply_to_document(changes);
                let mut label = op.label().to_owned();
                let mut outcome = Self::outcome(&op, Elements::default(), Elements::default());
                if let (true, Some(Change::Hidden(id, _))) = (hides, back.first()) {
                    let count = self.document.object(*id).map_or(0, |object| object.hidden().len());
                    if op.id() == OpId::Isolate && count == 0 {
                        label = LEAVE_ISOLATION.to_owned();
                    }
                    outcome.message = format!("{label}: {} hidden", counted(count, "face", "faces"));
                }
                Ok(if self.push_step(label, back, before) { outcome } else { outcome.unchanged() })
            }
            Planned::Select { op, find } => {
                let (kind, found) = (find.kind(), find.finish(self.selected_mesh()));
                Ok(self.select_found(&op, kind, found))
            }
        }
    }

    /// Finds out what a command has to do, without doing it.
    pub(super) fn plan(&self, command: Command) -> Result<Planned, Problem> {
        let place = self.place(&command);
        if let Action::Document(edit) = command.op.action() {
            let changes = edit.changes(&place)?;
            self.check_busy(&changes)?;
            return Ok(Planned::Document { op: command.op, changes });
        }
        let (no_selection, no_mesh) = (Selection::default(), Mesh::new());
        let against = self.target(&place, &no_selection, &no_mesh)?;
        let (selects, symmetry) = (command.op.is_open(), command.symmetry);
        if let Action::Select(edit) = command.op.action() {
            let object = place.object()?;
            if self.document.active().map(Object::id) != Some(object.id()) {
                return Err(Problem::field("object", "only the active object has a selection"));
            }
            let find = edit.find(&against)?;
            let find = if edit.takes_hidden() { find } else { find.shown(object.hidden()) };
            return Ok(Planned::Select { op: command.op, find: Box::new(find) });
        }
        let mut ops = command.op.resolve(&against)?;
        if let [op] = ops.as_slice()
            && let Action::WholeMesh(whole) = op.action()
        {
            whole.check()?;
            let objects = whole.objects(&place)?;
            for &id in &objects {
                self.check_idle(id)?;
            }
            whole.check_inputs(&self.inputs(&objects))?;
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
        let object = place.object()?;
        refuse_bezier(object.name(), object.bezier())?;
        self.check_idle(object.id())?;
        Ok(Planned::Local { object: object.id(), ops, symmetry, selects })
    }

    /// The place where a command acts.
    fn place(&self, command: &Command) -> Place<'_> {
        let (document, selection) = (&self.document, &self.selection);
        Place { document, object: command.object, next_object: ObjectId(self.next_object), selection }
    }

    /// The mesh and selection that a command's elements refer to. Only `new` works without an object;
    /// `no_selection` and `no_mesh` then stand in for the object's.
    fn target<'a>(
        &'a self,
        place: &Place<'_>,
        no_selection: &'a Selection,
        no_mesh: &'a Mesh,
    ) -> Result<Target<'a>, Problem> {
        let object = match place.index() {
            Ok(at) => self.document.objects.get(at),
            Err(problem) if place.object.is_some() => return Err(problem),
            Err(_) => None,
        };
        let is_active = object.is_some() && object.map(Object::id) == self.document.active().map(Object::id);
        Ok(Target {
            mesh: object.map_or(no_mesh, Object::mesh),
            object,
            selection: if is_active { &self.selection } else { no_selection },
        })
    }

    /// Applies the changes of a document operation; returns their inverses.
    pub(super) fn apply_to_document(&mut self, changes: Vec<Change>) -> Vec<Change> {
        for change in &changes {
            if let Change::Insert(_, object) = change {
                self.next_object = self.next_object.max(object.id().0 + 1);
            }
        }
        let active = self.document.active().map(Object::id);
        let hides = changes.iter().any(|change| matches!(change, Change::Hidden(..)));
        let back = self.apply(changes);
        if self.document.active().map(Object::id) == active {
            self.drop_gone_from_selection();
            if hides {
                self.drop_hidden_from_selection();
            }
        } else {
            self.selection = Arc::new(Selection::new(self.selection.kind()));
            self.changes.selection = true;
        }
        back
    }

    /// The meshes of objects, shared.
    pub(super) fn inputs(&self, objects: &[ObjectId]) -> Vec<NamedMesh> {
        objects.iter().filter_map(|&id| self.document.object(id)).map(|object| object.named.clone()).collect()
    }

    /// Makes local edits on an object in one validated transaction: all of them or none. Selects what they made if
    /// `selects` is set and the object is active.
    pub(super) fn edit(
        &mut self,
        id: ObjectId,
        ops: &[Op],
        symmetry: Symmetry,
        selects: bool,
    ) -> Result<Edited, Problem> {
        let revision = self.revision;
        let at = self.document.index_of(id).ok_or_else(object_gone)?;
        let object = self.document.objects.get_mut(at).ok_or_else(object_gone)?;
        let mesh = Arc::make_mut(&mut object.named.mesh);
        let before = Before::of(mesh);
        let mut notes = Vec::new();
        let mut images = symmetry.axis().map(|axis| self.images.take(mesh, id, revision, axis));
        let done = mesh.transaction(|mesh| {
            edit_local(ops, images.as_mut(), mesh, &mut notes, &mut |_| ControlFlow::Continue(()))
        });
        if let Some(images) = images {
            self.images.keep(id, revision, images);
        }
        let ((), mut journal) = done?;
        let touched = journal.touched();
        if !journal.is_of_moves()
            && let Err(defect) = validate_touched(mesh, &touched)
        {
            mesh.undo(journal);
            return Err(broken(&defect.to_string()));
        }
        let (created, removed) = before.compare(mesh, &touched);
        let created = created.with_sources(&face_sources(ops, &mut journal));
        let reshaped = is_reshaping(&touched) || created.vertices.len() + removed.vertices.len() > 0;
        let mut back = Vec::new();
        if !journal.changes_nothing(mesh) {
            back.push(Change::Journal(id, journal));
        }
        self.changes.touched(id, mesh, touched);
        if reshaped {
            self.forget_counts(id);
        }
        back.extend(self.follow_edit(id, &created, &removed));
        // An edit that changed nothing is no step, so that undo could not bring back what was selected.
        if self.document.active == at && !back.is_empty() {
            let result = if selects { self.result(ops, &created) } else { None };
            match result {
                Some(selection) => self.replace_selection(selection),
                None => self.drop_gone_from_selection(),
            }
        }
        Ok(Edited { back, created: created.into(), removed: removed.into(), notes })
    }
}

pub(super) fn local_edits(ops: &[Op]) -> impl Iterator<Item = &dyn LocalEdit> {
    ops.iter().filter_map(|op| match op.action() {
        Action::Local(edit) => Some(edit),
        Action::WholeMesh(_) | Action::Document(_) | Action::Select(_) => None,
    })
}

fn nothing_to_do(reason: Option<&str>) -> Result<(), Problem> {
    reason.map_or(Ok(()), |sentence| Err(Problem::nothing_to_do(sentence)))
}

fn object_gone() -> Problem {
    Problem::new("the object is gone")
}

pub(super) fn broken(defect: &str) -> Problem {
    Problem::internal(format!(
        "the result broke a rule of the mesh ({defect}), so nothing was changed; this is an error in Meshwright"
    ))
}
