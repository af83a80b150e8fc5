//! Commands begun, files opened, and the jobs that come of them.

use editor::{Begun, Command, CommandError, Finished, JobId, JobRequest, JobResult, MessageKind, OpId};
use formats::Format;
use halfedge::Element;

use super::App;
use crate::bezier;
use crate::input::actions::Action;
use crate::panels::fields;
use crate::panels::save::{FORMAT_SETTING, code};
use crate::platform::{Fetched, NamedBytes};
use crate::session::jobs::{Answer, Reply};
use crate::session::preview::MAX_SECONDS_PER_STEP;
use crate::session::sentence;

/// Yaw and pitch of a view on the plane that flat curves lie in.
const FROM_ABOVE: (f64, f64) = (0.0, 0.0);

/// What `meshwright.cancel()` stopped.
const CANCELLED: &str = "cancelled";

impl App {
    /// The document that the page opens on.
    pub(super) fn open_first(&mut self) {
        // The first shape can't be refused; were it, the page would open empty and say how to go on.
        let shape = fields::initial(OpId::New.spec(), &editor::Facts::default());
        let _ =
            fields::command(OpId::New, &shape).and_then(|command| self.session.editor.start_with(command));
        self.follow();
        self.view.frame_all();
    }

    /// Carries out a command, or says why there is none.
    pub(super) fn begin_or_refuse(&mut self, command: Result<Command, CommandError>) {
        match command {
            Ok(command) => self.begin(command, None),
            Err(error) => self.session.refuse(&error),
        }
    }

    /// Carries out a command, or starts its job.
    pub(super) fn begin(&mut self, command: Command, reply: Option<Reply>) {
        let (label, is_new) = (command.op.spec().label, command.op.id() == OpId::New);
        match self.session.editor.begin(command) {
            Ok(Begun::Done(outcome)) => {
                if is_new {
                    self.look_at_new();
                }
                if !outcome.warnings.is_empty() {
                    self.session.toast(
                        MessageKind::Warning,
                        outcome.message.clone(),
                        outcome.warnings.clone(),
                    );
                }
                if let Some(reply) = reply {
                    reply(Ok(Answer::Outcome(outcome)));
                }
            }
            Ok(Begun::Job(request)) => self.start(&request, label.to_owned(), reply),
            Err(error) => self.refused(&error, reply),
        }
    }

    /// Opens files in place of the document, through the worker.
    pub(super) fn open_files(&mut self, files: Vec<NamedBytes>, reply: Option<Reply>) {
        let label = match files.as_slice() {
            [] => return,
            [file] => format!("Open {}", file.name),
            [file, ..] => format!("Open {} and {} more", file.name, files.len() - 1),
        };
        let request = self.session.editor.begin_import(files);
        self.start(&request, label, reply);
    }

    /// Fetches the files that the page's address asks for, and opens them together.
    pub(super) fn fetch_wanted(&mut self) {
        let wanted = self.session.platform.wanted();
        let Some(first) = wanted.first() else { return };
        let name = first.split(['?', '#']).next().and_then(|path| path.rsplit('/').next()).unwrap_or(first);
        let id = self.session.editor.expect_import();
        self.session.jobs.add(id, format!("Fetch {name}"), None);
        self.session.platform.fetch(id.0, wanted);
    }

    /// Opens what was fetched, as the rest of the same job; or says why it can't.
    pub(super) fn fetched(&mut self, job: u64, fetched: Result<Fetched, String>) {
        let id = JobId(job);
        match fetched {
            Ok(Fetched { files, notes }) if self.session.jobs.iter().any(|running| running.id == id) => {
                self.session.jobs.note(id, notes);
                self.session.platform.start_job(job, JobRequest::import_expected(id, files).to_bytes());
            }
            Ok(_) => {}
            Err(text) => {
                self.session.editor.cancel_job(id);
                self.session.jobs.take(job);
                self.session.fail(text);
            }
        }
    }

    /// Writes the document for a script.
    pub(super) fn begin_export(&mut self, format: Format, reply: Reply) {
        let request = self.session.editor.begin_export(format);
        self.start(&request, format!("Write {}", format.name()), Some(reply));
    }

    pub(super) fn start(&mut self, request: &JobRequest, label: String, reply: Option<Reply>) {
        let id = request.id();
        self.session.jobs.add(id, label, reply);
        self.session.platform.start_job(id.0, request.to_bytes());
    }

    /// Takes in what came of a job.
    pub(super) fn job_done(&mut self, job: u64, result: Result<Vec<u8>, CommandError>) {
        let Some(running) = self.session.jobs.take(job) else { return };
        let id = JobId(job);
        let result = result.and_then(|bytes| {
            JobResult::from_bytes(&bytes)
                .map_err(|error| CommandError::refused(&*running.label, error.to_string()))
        });
        let finished =
            self.session.editor.finish(id, result.map_err(|error| with_notes(error, &running.notes)));
        self.adjustment_ended(id, finished.is_ok());
        match finished {
            Ok(Finished::Done(mut outcome)) => {
                if outcome.op == "open" {
                    self.look_at_opened();
                    self.say_opened(&outcome);
                } else {
                    if OpId::named(&outcome.op) == Some(OpId::New) {
                        self.look_at_new();
                    }
                    self.session.toast(MessageKind::Info, outcome.message.clone(), outcome.warnings.clone());
                }
                for note in running.notes {
                    self.session.editor.say(MessageKind::Warning, note.clone());
                    self.session.toast(MessageKind::Warning, note.clone(), Vec::new());
                    outcome.warnings.push(note);
                }
                if let Some(reply) = running.reply {
                    reply(Ok(Answer::Outcome(outcome)));
                }
            }
            Ok(Finished::Exported(files)) => match running.reply {
                Some(reply) => reply(Ok(Answer::Files(files))),
                None => self.saved(files, running.saves),
            },
            Err(error) => self.refused(&error, running.reply),
        }
    }

    /// Looks at what was opened: flat curves from straight above their plane, so that they are seen as
    /// they were drawn.
    fn look_at_opened(&mut self) {
        let flat = |object: &editor::Object| {
            object.bezier().and_then(editor::Bezier::curve).is_some_and(bezier::is_flat)
        };
        let objects = self.session.editor.document().objects();
        let was_from_above = (self.view.camera.yaw, self.view.camera.pitch) == FROM_ABOVE;
        if !objects.is_empty() && objects.iter().all(flat) {
            (self.view.camera.yaw, self.view.camera.pitch) = FROM_ABOVE;
        } else if was_from_above {
            // What is not flat hides its depth there.
            self.view.reset();
        }
        self.view.frame_when_seen();
        if self.session.editor.mesh().is_some_and(|mesh| mesh.count(self.shown.kind) == 0) {
            // Points without faces: what there is to point at.
            self.shown.kind = Element::Vertex;
        }
        // What was offered for another document has nothing to work on here.
        self.session.toasts.withdraw();
    }

    /// Looks at a shape that is the whole document; one that was added may be meant for where one looks.
    fn look_at_new(&mut self) {
        if self.session.editor.document().objects().len() == 1 {
            self.look_at_opened();
        }
    }

    fn say_opened(&mut self, outcome: &editor::Outcome) {
        let kind = if outcome.warnings.is_empty() { MessageKind::Info } else { MessageKind::Warning };
        let mut text = outcome.message.clone();
        match outcome.warnings.len() {
            0 => {}
            1 => text.push_str("; one thing was changed on the way in"),
            many => text.push_str(&format!("; {many} things were changed on the way in")),
        }
        self.session.toast(kind, text, outcome.warnings.clone());
        if self.session.editor.document().active().is_some_and(editor::Object::is_repairable) {
            self.session.toasts.offer(Action::Operation(OpId::RepairImport));
        }
    }

    /// Tells of a refusal, and who waits for the command.
    pub(super) fn refused(&mut self, error: &CommandError, reply: Option<Reply>) {
        match reply {
            Some(reply) => reply(Err(error.to_string())),
            None => self.session.refuse(error),
        }
    }

    /// Runs the last operation again with other fields.
    pub(super) fn adjust(&mut self, command: Command) {
        let started = self.session.platform.now();
        let label = command.op.spec().label;
        match self.session.editor.adjust(command) {
            Ok(Begun::Done(outcome)) => {
                self.session.adjusting_is_slow = self.session.platform.now() - started > MAX_SECONDS_PER_STEP;
                if !outcome.warnings.is_empty() {
                    self.session.toast(MessageKind::Warning, outcome.message, outcome.warnings);
                }
            }
            Ok(Begun::Job(request)) => {
                self.session.adjusting_is_slow = true;
                self.session.adjusting = Some(request.id());
                self.start(&request, label.to_owned(), None);
            }
            Err(error) => self.session.refuse(&error),
        }
    }

    /// Brings the step back that an adjustment was to replace, where the adjustment came to nothing.
    fn adjustment_ended(&mut self, job: JobId, done: bool) {
        if self.session.adjusting.take_if(|adjusting| *adjusting == job).is_some()
            && !done
            && let Err(error) = self.session.editor.redo()
        {
            self.session.refuse(&error);
        }
    }

    /// Forgets a job and tells who waits for it.
    pub(super) fn cancel_job(&mut self, id: JobId) {
        self.session.editor.cancel_job(id);
        self.session.platform.cancel_job(id.0);
        self.adjustment_ended(id, false);
        if let Some(reply) = self.session.jobs.take(id.0).and_then(|job| job.reply) {
            reply(Err(CANCELLED.to_owned()));
        }
    }

    /// Starts the job that writes the document's files.
    pub(super) fn save(&mut self, format: Format, name: String, holds_all: bool) {
        self.session.platform.store_setting(FORMAT_SETTING, &code(format));
        let revision = self.session.editor.revision();
        let request = self.session.editor.begin_export_as(format, name);
        self.start(&request, format!("Save as {}", format.name()), None);
        if holds_all {
            self.session.jobs.saves(request.id(), revision);
        }
    }

    /// Hands written files to the person. The document is saved where they hold all of it.
    fn saved(&mut self, files: Vec<NamedBytes>, revision: Option<u64>) {
        let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
        let text = format!("Saved {}", names.join(" and "));
        let mut details = Vec::new();
        match revision {
            Some(revision) => self.session.editor.mark_saved(revision),
            None => details.push(
                "The format holds less than the document does, so the document still counts as changed."
                    .to_owned(),
            ),
        }
        self.session.editor.say(MessageKind::Info, text.clone());
        self.session.toast(MessageKind::Info, text, details);
        self.session.platform.download(files);
    }
}

/// What failed, with what is known besides: where a file could not be read without another one, why
/// that is not there.
fn with_notes(mut error: CommandError, notes: &[String]) -> CommandError {
    for note in notes {
        error.problem = format!("{} {note}", sentence(&error.problem));
    }
    error
}
