//! Jobs as the editor sees them: begun, waited for, finished or cancelled.

use super::adjust::Replaced;
use super::run::{Planned, broken};
use super::{Editor, MessageKind};
use crate::document::ObjectId;
use crate::error::{CommandError, Problem};
use crate::history::Change;
use crate::job::{ExportHead, JobId, JobRequest, JobResult, Made, Work};
use crate::ops::{Action, Command, Input, Op};
use crate::outcome::Outcome;
use formats::{Format, NamedBytes, Repairs};
use halfedge::Mesh;
use std::ops::ControlFlow;
use std::sync::Arc;

/// The work up to which operations run at once, in faces: that takes less time than a frame, and less
/// than sending the mesh to a worker.
const MAX_FACES_AT_ONCE: usize = 20_000;

/// What became of a command that was begun.
#[derive(Debug)]
pub enum Begun {
    /// It is done.
    Done(Outcome),
    /// It takes long: run this somewhere and give what comes of it to [`Editor::finish`].
    Job(JobRequest),
}

/// What became of a job that was finished.
#[derive(Debug)]
#[allow(
    clippy::large_enum_variant,
    reason = "there is one at a time, and it is taken apart at once; small on wasm32"
)]
pub enum Finished {
    /// A command is done, or a file is open.
    Done(Outcome),
    /// Files to save were written.
    Exported(Vec<NamedBytes>),
}

/// A job that was begun and is waited for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RunningJob {
    /// Which one.
    pub id: JobId,
    /// Its op, or `open` or `export`.
    pub op: &'static str,
}

/// A job that is waited for, with what to do with its result.
#[derive(Debug)]
pub(super) struct Waiting {
    id: JobId,
    kind: WaitingFor,
}

#[derive(Debug)]
enum WaitingFor {
    Open,
    Export,
    Run(Box<Run>),
}

/// A command that runs as a job.
#[derive(Debug)]
struct Run {
    /// As it was given.
    command: Command,
    /// The first of the operations it was resolved to.
    op: Op,
    /// The objects it reads.
    objects: Vec<ObjectId>,
    /// The place of the object it is for.
    at: usize,
    /// What it does in place of another command.
    adjusts: Adjusts,
}

/// What a job adjusts.
#[derive(Debug)]
enum Adjusts {
    /// Nothing: it is a command of its own.
    Nothing,
    /// The last command, and the step that made, if it made one. It comes back where the job fails.
    Last(Option<Box<Replaced>>),
}

impl WaitingFor {
    fn op(&self) -> &'static str {
        match self {
            Self::Open => "open",
            Self::Export => "export",
            Self::Run(run) => run.op.spec().name,
        }
    }
}

impl Editor {
    /// Carries out a command that is quick, or gives the job to do for one that may take long. Until
    /// [`Editor::finish`] the document stays as it is, and edits of the job's objects are refused.
    ///
    /// # Errors
    /// Why the command is refused, naming the op and the field.
    pub fn begin(&mut self, command: Command) -> Result<Begun, CommandError> {
        self.begin_from(command, MAX_FACES_AT_ONCE)
    }

    /// [`Editor::begin`] with another threshold: work of this many faces or more becomes a job.
    ///
    /// # Errors
    /// As [`Editor::begin`].
    pub fn begin_from(&mut self, command: Command, faces: usize) -> Result<Begun, CommandError> {
        self.end_edit();
        let name = command.name();
        self.begin_inner(command, faces).map_err(|problem| self.report(CommandError::of(name, problem)))
    }

    fn begin_inner(&mut self, command: Command, faces: usize) -> Result<Begun, Problem> {
        let planned = self.plan(command.clone())?;
        let (objects, ops, at) = match &planned {
            Planned::Whole { op, objects, at } => (objects.clone(), vec![op.clone()], *at),
            Planned::Local { object, ops } => (vec![*object], ops.clone(), 0),
            Planned::Document { .. } => (Vec::new(), Vec::new(), 0),
        };
        let inputs = self.inputs(&objects);
        let cost = Self::work(&ops, &inputs);
        let first = ops.first().cloned();
        match first {
            Some(op) if cost >= faces => {
                let run = Run { command, op, objects, at, adjusts: Adjusts::Nothing };
                let id = self.wait_for(WaitingFor::Run(Box::new(run)));
                Ok(Begun::Job(JobRequest { id, work: Work::Run(ops, inputs) }))
            }
            _ => {
                drop(inputs);
                Ok(Begun::Done(self.carry_out(command, planned, &mut |_| ControlFlow::Continue(()))?))
            }
        }
    }

    /// The work of a command in faces read or made: what decides whether it becomes a job. None where
    /// the command would be refused. Costs O(mesh) at most.
    pub fn cost(&self, command: &Command) -> Option<usize> {
        match self.plan(command.clone()).ok()? {
            Planned::Whole { op, objects, .. } => Some(Self::work(&[op], &self.inputs(&objects))),
            Planned::Local { object, ops } => Some(Self::work(&ops, &self.inputs(&[object]))),
            Planned::Document { .. } => Some(0),
        }
    }

    /// The work of operations, in faces read or made.
    fn work(ops: &[Op], inputs: &[Input]) -> usize {
        let each = ops.iter().map(|op| match op.action() {
            Action::WholeMesh(whole) => whole.cost(inputs),
            Action::Local(edit) => inputs.first().map_or(0, |input| edit.cost(&input.mesh)),
            Action::Document(_) => 0,
        });
        each.fold(0, usize::saturating_add)
    }

    /// Whether a command runs at once when it is begun, and so can be previewed at every change of its
    /// fields; one that would be refused is not quick. Costs O(mesh) at most.
    pub fn is_quick(&self, command: &Command) -> bool {
        self.cost(command).is_some_and(|cost| cost < MAX_FACES_AT_ONCE)
    }

    /// The mesh that an operation on whole meshes would make of the command's object, without doing it;
    /// none where it is refused. Costs what running it costs.
    pub fn try_out(&self, command: &Command) -> Option<Mesh> {
        let Planned::Whole { op, objects, .. } = self.plan(command.clone()).ok()? else { return None };
        let made = self.compute(&op, &objects, &mut |_| ControlFlow::Continue(())).ok()?;
        let Made::Meshes(outputs, ..) = made else { return None };
        outputs.into_iter().next().map(|output| Arc::unwrap_or_clone(output.mesh))
    }

    /// Whether operations on these objects run at once.
    pub(super) fn is_small(&self, ops: &[Op], objects: &[ObjectId]) -> bool {
        Self::work(ops, &self.inputs(objects)) < MAX_FACES_AT_ONCE
    }

    /// The job of reading files, whose result [`Editor::finish`] opens in place of the document.
    pub fn begin_import(&mut self, files: Vec<NamedBytes>) -> JobRequest {
        self.begin_import_with(files, Repairs::default())
    }

    /// [`Editor::begin_import`] with choices in how meshes are made of what is not one as it
    /// stands. `repair-import` makes them later.
    pub fn begin_import_with(&mut self, files: Vec<NamedBytes>, repairs: Repairs) -> JobRequest {
        JobRequest { id: self.expect_import(), work: Work::Import(files, repairs) }
    }

    /// Announces an import whose files are still on their way: a job that can be cancelled, and whose
    /// request [`JobRequest::import_expected`] makes once they are here.
    pub fn expect_import(&mut self) -> JobId {
        self.wait_for(WaitingFor::Open)
    }

    /// The job of writing the document's objects to files of a format, called after the document. An
    /// ongoing edit of elements is written as it stands and goes on; the preview of an operation is
    /// cancelled.
    pub fn begin_export(&mut self, format: Format) -> JobRequest {
        self.begin_export_as(format, self.document.name.clone())
    }

    /// [`Editor::begin_export`] to files of another name, given without an extension.
    pub fn begin_export_as(&mut self, format: Format, name: String) -> JobRequest {
        if self.is_previewing_mesh() {
            self.cancel_edit();
        }
        let objects: Vec<ObjectId> = self.document.objects().iter().map(|object| object.id()).collect();
        let id = self.wait_for(WaitingFor::Export);
        let head = ExportHead {
            format,
            name,
            offset: self.document.offset,
            materials: self.document.materials.clone(),
        };
        JobRequest { id, work: Work::Export(head, self.inputs(&objects)) }
    }

    fn wait_for(&mut self, kind: WaitingFor) -> JobId {
        let id = JobId(self.next_job);
        self.next_job += 1;
        self.jobs.push(Waiting { id, kind });
        self.changes.jobs = true;
        id
    }

    /// Takes in what came of a job, as one undo step.
    ///
    /// # Errors
    /// What the job failed with, or what is wrong with its result; the document is as it was.
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
        // Writing a file changes nothing, so an ongoing edit goes on.
        if !matches!(job.kind, WaitingFor::Export) {
            self.end_edit();
        }
        let name = job.kind.op();
        let made = result.and_then(|JobResult { made, validated }| {
            if !validated {
                made.validate().map_err(|defect| CommandError::of(name, broken(&defect)))?;
            }
            Ok(made)
        });
        let other_job = || CommandError::of(name, Problem::internal("the result is of another job"));
        match (job.kind, made) {
            (WaitingFor::Open, Ok(Made::Import(import))) => Ok(Finished::Done(self.open_valid(import))),
            (WaitingFor::Export, Ok(Made::Files(files))) => Ok(Finished::Exported(files)),
            (WaitingFor::Run(run), Ok(made @ Made::Meshes(..))) => self.finish_run(*run, made),
            (kind, made) => {
                if let WaitingFor::Run(run) = kind {
                    self.bring_back(run.adjusts);
                }
                Err(self.report(made.err().unwrap_or_else(other_job)))
            }
        }
    }

    /// Takes in what a command's job made.
    fn finish_run(&mut self, run: Run, made: Made) -> Result<Finished, CommandError> {
        let Run { command, op, objects, at, adjusts } = run;
        let before = self.revision;
        let outcome = match self.commit_whole(&op, &objects, at, made) {
            Ok(outcome) => outcome,
            Err(problem) => {
                self.bring_back(adjusts);
                return Err(self.report(CommandError::of(op.spec().name, problem)));
            }
        };
        if self.revision != before {
            self.remember(command);
        } else if matches!(adjusts, Adjusts::Last(_)) {
            self.remember_without_step(command);
        }
        self.say(MessageKind::Info, outcome.message.clone());
        Ok(Finished::Done(outcome))
    }

    /// Makes a job that was just begun the adjustment of the last command, whose step it replaces.
    pub(super) fn set_adjusts(&mut self, id: JobId, replaced: Option<Replaced>) {
        for job in self.jobs.iter_mut().filter(|job| job.id == id) {
            if let WaitingFor::Run(run) = &mut job.kind {
                run.adjusts = Adjusts::Last(replaced.map(Box::new));
                return;
            }
        }
    }

    fn bring_back(&mut self, adjusts: Adjusts) {
        if let Adjusts::Last(Some(replaced)) = adjusts {
            self.restore(*replaced);
        }
    }

    /// Forgets a job; what comes of it is not taken in. A step that the job was to replace comes back.
    /// Returns whether the job was waited for.
    pub fn cancel_job(&mut self, id: JobId) -> bool {
        let Some(at) = self.jobs.iter().position(|job| job.id == id) else { return false };
        self.changes.jobs = true;
        if let WaitingFor::Run(run) = self.jobs.remove(at).kind {
            self.bring_back(run.adjusts);
        }
        true
    }

    /// The jobs that are waited for, the oldest first.
    pub fn jobs(&self) -> impl Iterator<Item = RunningJob> + '_ {
        self.jobs.iter().map(|job| RunningJob { id: job.id, op: job.kind.op() })
    }

    /// Refuses to change an object that a job runs on.
    pub(super) fn check_idle(&self, id: ObjectId) -> Result<(), Problem> {
        let busy = self.jobs.iter().find_map(|job| match &job.kind {
            WaitingFor::Run(run) if run.objects.contains(&id) => Some(run.op.spec().label),
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

    /// Refuses changes to an object that a job runs on.
    pub(super) fn check_busy(&self, changes: &[Change]) -> Result<(), Problem> {
        let mut ids: Vec<ObjectId> = self.document.objects().iter().map(|object| object.id()).collect();
        for change in changes {
            let id = match change {
                Change::Journal(id, _) | Change::Mesh(id, _) | Change::Bezier(id, _) => Some(*id),
                // Places are those after the changes before it.
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
