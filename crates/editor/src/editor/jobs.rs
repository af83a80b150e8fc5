//! Jobs from the editor's side: beginning, finishing and cancelling them.

use super::adjust::Replaced;
use super::begun::{Begun, Finished, RunningJob};
use super::run::{Planned, broken};
use super::{Editor, MessageKind};
use crate::Task;
use crate::document::{Object, ObjectId};
use crate::error::{CommandError, Problem};
use crate::history::Change;
use crate::job::{JobId, JobRequest, JobResult, Made, Work};
use crate::ops::{Action, Command, NamedMesh, Op, Symmetry};
use crate::recovery::Event;
use crate::selection::Selection;
use formats::{NamedBytes, Repairs};
use halfedge::Mesh;
use std::ops::ControlFlow;
use std::sync::Arc;

/// Work on fewer elements is done at once: it takes less time than a frame, and less than sending the mesh to a worker.
pub const MAX_ELEMENTS_AT_ONCE: usize = 20_000;

/// A job that has not finished, and what to do with its result.
#[derive(Debug)]
pub(super) struct Waiting {
    id: JobId,
    pub(super) kind: WaitingFor,
}

#[derive(Debug)]
pub(super) enum WaitingFor {
    Open,
    Export,
    Decode,
    Share,
    Run(Box<Run>),
}

/// A command that runs as a job.
#[derive(Debug)]
pub(super) struct Run {
    /// The command as it was given.
    command: Command,
    /// What was selected then.
    selection: Arc<Selection>,
    /// The first of the operations that the command resolved to.
    op: Op,
    /// The objects that the job reads.
    objects: Vec<ObjectId>,
    /// The place of the command's object in the list.
    at: usize,
    /// The names of the objects.
    names: Vec<String>,
    /// The command that the job adjusts.
    adjusts: Adjusts,
}

impl Run {
    /// Whether an object must stay as it is until the job ends.
    fn needs(&self, id: ObjectId) -> bool {
        let replaced = match &self.adjusts {
            Adjusts::Last(Some(replaced)) => replaced.needs(id),
            Adjusts::Nothing | Adjusts::Last(None) => false,
        };
        replaced || self.objects.contains(&id)
    }

    /// A command that adjusts no other.
    pub(super) fn new(
        command: Command,
        selection: Arc<Selection>,
        op: Op,
        objects: Vec<ObjectId>,
        at: usize,
        names: Vec<String>,
    ) -> Self {
        Self { command, selection, op, objects, at, names, adjusts: Adjusts::Nothing }
    }
}

/// What a job adjusts.
#[derive(Debug)]
enum Adjusts {
    /// Nothing: the command stands on its own.
    Nothing,
    /// The last command, and its step if it made one. The step is restored if the job fails.
    Last(Option<Box<Replaced>>),
}

impl WaitingFor {
    fn task(&self) -> Task {
        match self {
            Self::Open => Task::Open,
            Self::Export => Task::Export,
            Self::Decode => Task::Decode,
            Self::Share => Task::Share,
            Self::Run(run) => Task::Op(run.op.id()),
        }
    }
}

impl Editor {
    /// Carries out a quick command, or returns a job for one that may take long. Until [`Editor::finish`]
    /// the document stays as it is, and edits of the job's objects are refused.
    ///
    /// # Errors
    /// The command is refused; the error names the operation and the field.
    pub fn begin(&mut self, command: Command) -> Result<Begun, CommandError> {
        self.begin_from(command, MAX_ELEMENTS_AT_ONCE)
    }

    /// [`Editor::begin`] with another threshold: a command becomes a job from this many faces of work.
    ///
    /// # Errors
    /// As [`Editor::begin`].
    pub fn begin_from(&mut self, command: Command, faces: usize) -> Result<Begun, CommandError> {
        self.end_edit();
        let name = command.name();
        self.begin_inner(command, faces).map_err(|problem| self.report(CommandError::of(name, problem)))
    }

    fn begin_inner(&mut self, command: Command, faces: usize) -> Result<Begun, Problem> {
        let symmetry = command.symmetry;
        let planned = self.plan(command.clone())?;
        let (objects, ops, at) = match &planned {
            Planned::Whole { op, objects, at } => (objects.clone(), vec![op.clone()], *at),
            Planned::Local { object, ops, .. } => (vec![*object], ops.clone(), 0),
            Planned::Document { .. } => (Vec::new(), Vec::new(), 0),
            Planned::Select { op, find } if find.cost(self.selected_mesh()) >= faces => {
                let (op, find) = (op.clone(), find.clone());
                self.start_selecting(*find, &op, Some(command));
                return Ok(Begun::Selecting);
            }
            Planned::Select { .. } => (Vec::new(), Vec::new(), 0),
        };
        let inputs = self.inputs(&objects);
        let cost = Self::work(&ops, symmetry, &inputs);
        let first = ops.first().cloned();
        match first {
            Some(op) if cost >= faces => {
                let selection = self.selection.clone();
                let names = inputs.iter().map(|input| input.name.clone()).collect();
                let run = Run::new(command, selection, op, objects, at, names);
                let id = self.wait_for(WaitingFor::Run(Box::new(run)));
                Ok(Begun::Job(JobRequest { id, work: Work::Run(ops, symmetry, inputs) }))
            }
            _ => {
                drop(inputs);
                Ok(Begun::Done(self.carry_out(command, planned, &mut |_| ControlFlow::Continue(()))?))
            }
        }
    }

    /// The work of a command, in faces read or created, which decides whether it becomes a job. None if the
    /// command would be refused. Costs O(mesh) at most.
    pub fn cost(&self, command: &Command) -> Option<usize> {
        match self.plan(command.clone()).ok()? {
            Planned::Whole { op, objects, .. } => {
                Some(Self::work(&[op], Symmetry::None, &self.inputs(&objects)))
            }
            Planned::Local { object, ops, symmetry, .. } => {
                Some(Self::work(&ops, symmetry, &self.inputs(&[object])))
            }
            Planned::Document { .. } | Planned::Select { .. } => Some(0),
        }
    }

    /// The work of operations, in faces read or created. With symmetry their mirror images are as much again.
    pub(super) fn work(ops: &[Op], symmetry: Symmetry, inputs: &[NamedMesh]) -> usize {
        let each = ops.iter().map(|op| match op.action() {
            Action::WholeMesh(whole) => whole.cost(inputs),
            Action::Local(edit) => inputs.first().map_or(0, |input| edit.cost(&input.mesh)),
            Action::Document(_) | Action::Select(_) => 0,
        });
        let sides = if symmetry.axis().is_some() { 2 } else { 1 };
        each.fold(0, usize::saturating_add).saturating_mul(sides)
    }

    /// Whether the command would run at once, so that it can be previewed at every change of its fields.
    /// False if it would be refused. Costs O(mesh) at most.
    pub fn is_quick(&self, command: &Command) -> bool {
        self.cost(command).is_some_and(|cost| cost < MAX_ELEMENTS_AT_ONCE)
    }

    /// The mesh that a whole-mesh operation would make of the command's object, without changing the
    /// document; none if the command is refused. Costs as much as running it.
    pub fn try_out(&self, command: &Command) -> Option<Mesh> {
        let Planned::Whole { op, objects, .. } = self.plan(command.clone()).ok()? else { return None };
        let made = self.compute(&op, &objects, &mut |_| ControlFlow::Continue(())).ok()?;
        let Made::Meshes(outputs, ..) = made else { return None };
        outputs.into_iter().next().map(|output| Arc::unwrap_or_clone(output.mesh))
    }

    /// Whether operations on these objects run at once.
    pub(super) fn is_small(&self, ops: &[Op], symmetry: Symmetry, objects: &[ObjectId]) -> bool {
        Self::work(ops, symmetry, &self.inputs(objects)) < MAX_ELEMENTS_AT_ONCE
    }

    /// A job that reads files; [`Editor::finish`] replaces the document by what it read.
    pub fn begin_import(&mut self, files: Vec<NamedBytes>) -> JobRequest {
        self.begin_import_with(files, Repairs::default())
    }

    /// [`Editor::begin_import`] with choices of how to repair faces that do not form a mesh.
    /// `repair-import` makes these choices later.
    pub fn begin_import_with(&mut self, files: Vec<NamedBytes>, repairs: Repairs) -> JobRequest {
        JobRequest { id: self.expect_import(), work: Work::Import(files, repairs) }
    }

    /// Announces an import whose files are still arriving. The job can be cancelled;
    /// [`JobRequest::import_expected`] makes its request once the files are here.
    pub fn expect_import(&mut self) -> JobId {
        self.wait_for(WaitingFor::Open)
    }

    pub(super) fn wait_for(&mut self, kind: WaitingFor) -> JobId {
        let id = JobId(self.next_job);
        self.next_job += 1;
        self.jobs.push(Waiting { id, kind });
        self.changes.jobs = true;
        id
    }

    /// Commits the result of a job as one undo step.
    ///
    /// # Errors
    /// The job failed or its result is invalid; the document is unchanged.
    pub fn finish(
        &mut self,
        id: JobId,
        result: Result<JobResult, CommandError>,
    ) -> Result<Finished, CommandError> {
        let Some(at) = self.jobs.iter().position(|job| job.id == id) else {
            return Err(CommandError {
                kind: crate::error::ErrorKind::Cancelled,
                ..CommandError::refused("finish", "the job was cancelled")
            });
        };
        let job = self.jobs.remove(at);
        self.changes.jobs = true;
        // These change nothing, so an ongoing edit continues.
        if !matches!(job.kind, WaitingFor::Export | WaitingFor::Decode | WaitingFor::Share) {
            self.end_edit();
        }
        let name = job.kind.task().name();
        let made = result.and_then(|JobResult { made, validated }| {
            if !validated {
                made.validate().map_err(|defect| CommandError::of(name, broken(&defect)))?;
            }
            Ok(made)
        });
        let other_job = || CommandError::of(name, Problem::internal("the result is of another job"));
        match (job.kind, made) {
            (WaitingFor::Open, Ok(Made::Import(import))) => Ok(Finished::Done(self.open_valid(import))),
            (WaitingFor::Open, Ok(Made::Project(read))) => Ok(Finished::Done(self.open_project(*read))),
            (WaitingFor::Export, Ok(Made::Files(files))) => Ok(Finished::Exported(files)),
            (WaitingFor::Share, Ok(Made::Link(link))) => Ok(Finished::Shared(link)),
            (WaitingFor::Decode, Ok(Made::Picture(picture))) => Ok(Finished::Decoded(picture)),
            (WaitingFor::Decode, Err(error)) => Err(error),
            (WaitingFor::Run(run), Ok(made @ Made::Meshes(..))) => self.finish_run(*run, made),
            (kind, made) => {
                if let WaitingFor::Run(run) = kind {
                    self.restore_replaced(run.adjusts);
                }
                Err(self.report(made.err().unwrap_or_else(other_job)))
            }
        }
    }

    /// Commits the result of a command's job.
    pub(super) fn finish_run(&mut self, run: Run, made: Made) -> Result<Finished, CommandError> {
        let Run { command, selection, op, objects, at, names, adjusts } = run;
        let is_named = |(id, name): (&ObjectId, &String)| {
            self.document.object(*id).is_some_and(|object| object.name() == name)
        };
        let names = if objects.iter().zip(&names).all(is_named) { Vec::new() } else { names };
        let places = objects.iter().filter_map(|&id| self.document.index_of(id)).collect();
        let before = self.revision;
        let outcome = match self.commit_whole(&op, &objects, at, made) {
            Ok(outcome) => outcome,
            Err(problem) => {
                self.restore_replaced(adjusts);
                return Err(self.report(CommandError::of(op.spec().name, problem)));
            }
        };
        if self.revision != before {
            let is_active = objects.first() == self.document.active().map(Object::id).as_ref();
            if let Some(ids) = outcome.created.ids.as_ref().filter(|_| is_active && command.op.is_open())
                && let Some(selection) = self.result(std::slice::from_ref(&op), ids)
            {
                self.replace_selection(selection);
            }
            self.log(Event::Job { command: command.clone(), selection, objects: places, at, names });
            self.remember(command);
        } else if let Adjusts::Last(replaced) = adjusts {
            if let Some(replaced) = replaced {
                self.keep_redo_of(*replaced);
            }
            self.remember_without_step(command);
        }
        self.say(MessageKind::Info, outcome.message.clone());
        Ok(Finished::Done(outcome))
    }

    /// Makes a job that has just begun an adjustment of the last command, whose step the job replaces.
    pub(super) fn set_adjusts(&mut self, id: JobId, replaced: Option<Replaced>) {
        for job in self.jobs.iter_mut().filter(|job| job.id == id) {
            if let WaitingFor::Run(run) = &mut job.kind {
                run.adjusts = Adjusts::Last(replaced.map(Box::new));
                return;
            }
        }
    }

    fn restore_replaced(&mut self, adjusts: Adjusts) {
        if let Adjusts::Last(Some(replaced)) = adjusts {
            self.restore(*replaced);
        }
    }

    /// Forgets a job and ignores its result. Restores the step that the job was to replace, if any. Returns
    /// whether the job was running.
    pub fn cancel_job(&mut self, id: JobId) -> bool {
        let Some(at) = self.jobs.iter().position(|job| job.id == id) else { return false };
        self.changes.jobs = true;
        if let WaitingFor::Run(run) = self.jobs.remove(at).kind {
            self.restore_replaced(run.adjusts);
        }
        true
    }

    /// The jobs that have not finished, the oldest first.
    pub fn jobs(&self) -> impl Iterator<Item = RunningJob> + '_ {
        self.jobs.iter().map(|job| RunningJob { id: job.id, task: job.kind.task() })
    }

    /// Refuses a change of an object that a job is running on.
    pub(super) fn check_idle(&self, id: ObjectId) -> Result<(), Problem> {
        let busy = self.jobs.iter().find_map(|job| match &job.kind {
            WaitingFor::Run(run) if run.needs(id) => Some(run.op.spec().label),
            _ => None,
        });
        match busy {
            None => Ok(()),
            Some(label) => {
                let name = self.document.object(id).map_or("the object", |object| object.name());
                Err(Problem::new(format!(
                    "“{label}” is still running on {name}; wait until it is done, or cancel it"
                )))
            }
        }
    }

    /// Refuses changes of objects that a job is running on.
    pub(super) fn check_busy<'a>(
        &self,
        changes: impl IntoIterator<Item = &'a Change>,
    ) -> Result<(), Problem> {
        let mut ids: Vec<ObjectId> = self.document.objects().iter().map(|object| object.id()).collect();
        for change in changes {
            let id = match change {
                Change::Journal(id, _) | Change::Mesh(id, _) | Change::Bezier(id, _) => Some(*id),
                // A place refers to the list after the preceding changes.
                Change::Remove(at) if *at < ids.len() => Some(ids.remove(*at)),
                Change::Insert(at, object) if *at <= ids.len() => {
                    ids.insert(*at, object.id());
                    None
                }
                _ => None,
            };
            id.map_or(Ok(()), |id| self.check_idle(id))?;
        }
        Ok(())
    }

    pub(super) fn refuse_while_busy(&self, op: &str, changes: &[Change]) -> Result<(), CommandError> {
        self.check_busy(changes).map_err(|problem| CommandError::of(op, problem))
    }
}
