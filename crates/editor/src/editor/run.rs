//! Running commands: planned, then carried out as one step, or refused with nothing changed.

use super::Editor;
use super::MessageKind;
use crate::command::{Action, Command, Commit, Op, Place, Target, edit_all, refuse_bezier};
use crate::document::{Object, ObjectId};
use crate::error::{CommandError, Problem};
use crate::history::{Change, is_reshaping};
use crate::job;
use crate::outcome::{Before, Elements, Outcome};
use crate::selection::Selection;
use halfedge::{Journal, Mesh, Touched};
use std::ops::ControlFlow;
use std::sync::Arc;

/// What a command has to do.
pub(super) enum Planned {
    Local { object: ObjectId, ops: Vec<Op> },
    Whole { op: Op, objects: Vec<ObjectId>, at: usize },
    Document { op: Op, changes: Vec<Change> },
}

/// What local edits did.
pub(super) struct Edited {
    pub journal: Journal,
    pub created: Elements,
    pub removed: Elements,
    pub notes: Vec<String>,
}

impl Editor {
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
        self.settle();
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
    pub(super) fn report(&mut self, error: CommandError) -> CommandError {
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
        self.carry_out(command, planned, progress)
    }

    /// Does what was planned for a command, which is the last from then on.
    pub(super) fn carry_out(
        &mut self,
        command: Command,
        planned: Planned,
        progress: &mut halfedge::Progress<'_>,
    ) -> Result<Outcome, Problem> {
        let before = self.revision;
        let outcome = self.carry_out_step(planned, progress)?;
        // What changed nothing is no step, and there is nothing of it to adjust.
        if self.revision != before {
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
            Planned::Local { object, ops } => {
                let before = self.selection.clone();
                let done = self.edit(object, &ops)?;
                let (spec, back) = (ops.first().map(Op::spec), vec![Change::Journal(object, done.journal)]);
                self.push_step(spec.map_or_else(String::new, |s| s.label.to_owned()), back, before);
                Ok(Outcome { warnings: done.notes, ..Self::outcome(&ops, done.created, done.removed) })
            }
            Planned::Whole { op, objects, at } => {
                let made = self.compute(&op, &objects, progress)?;
                self.commit_whole(&op, &objects, at, made)
            }
            Planned::Document { op, changes } => {
                let before = self.selection.clone();
                let back = self.make_document(changes);
                if !back.is_empty() {
                    self.push_step(op.spec().label.to_owned(), back, before);
                }
                Ok(Self::outcome(&[op], Elements::default(), Elements::default()))
            }
        }
    }

    /// What a whole-mesh operation makes of objects; it is valid.
    pub(super) fn compute(
        &self,
        op: &Op,
        objects: &[ObjectId],
        progress: &mut halfedge::Progress<'_>,
    ) -> Result<job::Made, Problem> {
        let made = job::run(std::slice::from_ref(op), &self.inputs(objects), progress)?;
        made.validate().map_err(|defect| broken(&defect))?;
        Ok(made)
    }

    /// Finds out what a command has to do, without doing it.
    pub(super) fn plan(&self, command: Command) -> Result<Planned, Problem> {
        let next_object = ObjectId(self.next_object);
        let place = Place { document: &self.document, object: command.object, next_object };
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
        Ok(Planned::Local { object: object.id(), ops })
    }

    /// Makes the changes of an operation on the document; gives those that take them back.
    pub(super) fn make_document(&mut self, changes: Vec<Change>) -> Vec<Change> {
        for change in &changes {
            if let Change::Insert(_, object) = change {
                self.next_object = self.next_object.max(object.id().0 + 1);
            }
        }
        let active = self.document.active().map(Object::id);
        let back = self.make(changes);
        if self.document.active().map(Object::id) == active {
            self.drop_gone_from_selection();
        } else {
            self.selection = Arc::new(Selection::new(self.selection.kind()));
            self.changes.selection = true;
        }
        back
    }

    /// The meshes of objects, shared.
    pub(super) fn inputs(&self, objects: &[ObjectId]) -> Vec<crate::command::Input> {
        objects
            .iter()
            .filter_map(|&id| self.document.object(id))
            .map(|object| crate::command::Input {
                name: object.name.clone(),
                mesh: object.mesh.clone(),
                bezier: object.bezier.clone(),
                soup: object.soup.clone(),
            })
            .collect()
    }

    /// Makes local edits on an object in one transaction, validated; all or nothing.
    pub(super) fn edit(&mut self, id: ObjectId, ops: &[Op]) -> Result<Edited, Problem> {
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
}

pub(super) fn broken(defect: &str) -> Problem {
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
