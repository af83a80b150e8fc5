//! Running commands, opening and saving files, and the jobs for them.

use editor::{
    Begun, Command, CommandError, Finished, JobId, JobRequest, JobResult, MessageKind, OpId, Scope, Task,
};
use formats::{Format, first_few, is_image};

use super::form;
use super::jobs::{Answer, Reply};
use super::preview::MAX_SECONDS_PER_STEP;
use super::toasts::Remedy;
use super::{CANCELLED, Session, ViewTarget, saving, selecting, sharing};
use crate::bezier;
use crate::input::actions::Action;
use crate::platform::{Fetched, NamedBytes};
use halfedge::words::{counted, sentence};

impl Session {
    /// Creates the document that the page starts with.
    pub fn open_first(&mut self) {
        // The initial shape can't be refused; if it were, the page would start empty and say how to go on.
        let _ = form::first_shape().and_then(|command| self.editor.start_with(command));
        self.look = Some(ViewTarget::Document);
    }

    /// Replaces the document by a new one, as one undo step. If the old one was saved there is nothing to lose, and
    /// the new one counts as saved too.
    pub fn new_document(&mut self, command: Result<Command, CommandError>) {
        self.end_live(true);
        let old = self.editor.document().name().to_owned();
        let (was_saved, before) = (!self.editor.is_dirty(), self.editor.revision());
        self.begin_or_refuse(command);
        let revision = self.editor.revision();
        if revision == before {
            return;
        }
        if was_saved {
            self.editor.mark_saved(revision);
        }
        self.toast(
            MessageKind::Info,
            format!("New document. {old} is kept: undo brings it back."),
            Vec::new(),
        );
        self.toasts.offer(Remedy::UndoEdit { revision: self.editor.revision() });
    }

    /// Carries out a command, or shows why there is none.
    pub fn begin_or_refuse(&mut self, command: Result<Command, CommandError>) {
        match command {
            Ok(command) => self.begin(command.mirrored(self.live_settings.symmetry), None),
            Err(error) => self.refuse(&error),
        }
    }

    /// Carries out a command, or starts its job.
    pub fn begin(&mut self, command: Command, reply: Option<Reply>) {
        let (label, id) = (command.op.label(), command.op.id());
        let (scope, revision) = (command.op.spec().scope, self.editor.revision());
        let started = self.platform.now();
        let begun = self.editor.begin(command);
        self.work_seconds += self.platform.now() - started;
        match begun {
            Ok(Begun::Done(outcome)) => {
                if id == OpId::New {
                    self.look_at_new();
                }
                if scope == Scope::Selection && self.editor.revision() == revision {
                    selecting::say_if_nothing_found(self, &outcome);
                }
                // A key pressed by mistake must not change a whole mesh unnoticed.
                // What it does may be out of sight, as the holes at the back are.
                let is_hidden = id == OpId::FillHole && reply.is_none();
                let says = (is_hidden || self.by_key && scope == Scope::Meshes)
                    && self.editor.revision() != revision;
                if !outcome.warnings.is_empty() {
                    self.warn(outcome.message.clone(), outcome.warnings.clone());
                } else if says {
                    self.toast(MessageKind::Info, outcome.message.clone(), Vec::new());
                }
                if says {
                    self.toasts.offer(Remedy::UndoEdit { revision: self.editor.revision() });
                }
                if let Some(reply) = reply {
                    reply(Ok(Answer::Outcome(outcome)));
                }
            }
            Ok(Begun::Selecting) => selecting::wait(self, reply),
            Ok(Begun::Job(request)) => self.start(&request, label.to_owned(), reply),
            Err(error) => self.refused(&error, reply),
        }
    }

    /// Replaces the document by files, which the worker reads: returns that job. Images alone go to the materials that name
    /// them.
    pub fn open_files(&mut self, files: Vec<NamedBytes>, reply: Option<Reply>) -> Option<JobId> {
        let is_image = |file: &NamedBytes| is_image(file) && Format::detect(file).is_none();
        if !files.is_empty() && files.iter().all(is_image) {
            take_images(self, &files, reply);
            return None;
        }
        let label = match files.as_slice() {
            [] => return None,
            [file] => format!("Open {}", file.name),
            [file, ..] => format!("Open {} and {} more", file.name, files.len() - 1),
        };
        let request = self.editor.begin_import(files);
        self.start(&request, label, reply);
        Some(request.id())
    }

    /// Fetches the files that the page's address names, and opens them together.
    pub fn fetch_wanted(&mut self) {
        let wanted = self.platform.wanted();
        let Some(first) = wanted.first() else { return };
        let name = first.split(['?', '#']).next().and_then(|path| path.rsplit('/').next()).unwrap_or(first);
        let id = self.editor.expect_import();
        self.jobs.add(id, format!("Fetch {name}"), None, self.platform.now());
        self.platform.fetch(id.0, wanted);
    }

    /// Opens fetched files as the second part of the same job, or reports why they could not be fetched.
    pub fn fetched(&mut self, job: u64, fetched: Result<Fetched, String>) {
        let id = JobId(job);
        match fetched {
            Ok(Fetched { files, source, notes }) if self.jobs.iter().any(|running| running.id == id) => {
                self.jobs.note(id, notes);
                saving::opening(self, id, source, &files);
                self.platform.start_job(job, &JobRequest::import_expected(id, files));
            }
            Ok(_) => {}
            Err(text) => {
                self.editor.cancel_job(id);
                self.jobs.take(job);
                self.fail(text);
            }
        }
    }

    /// Writes the document for a script.
    pub fn begin_export(&mut self, format: Format, reply: Reply) {
        let request = self.editor.begin_export(format);
        self.start(&request, format!("Write {}", format.name()), Some(reply));
    }

    pub fn start(&mut self, request: &JobRequest, label: String, reply: Option<Reply>) {
        let id = request.id();
        self.jobs.add(id, label, reply, self.platform.now());
        self.platform.start_job(id.0, request);
    }

    /// Handles the result of a job.
    pub fn job_done(&mut self, job: u64, result: Result<JobResult, CommandError>) {
        let Some(running) = self.jobs.take(job) else { return };
        self.work_seconds += self.platform.now() - running.started;
        let id = JobId(job);
        let revision = self.editor.revision();
        let decodes = self.editor.jobs().any(|job| job.id == id && job.task == Task::Decode);
        let finished = self.editor.finish(id, result.map_err(|error| with_notes(error, &running.notes)));
        match finished {
            Ok(Finished::Done(mut outcome)) => {
                for note in &running.notes {
                    self.editor.say(MessageKind::Warning, note.clone());
                }
                if outcome.op == Task::Open {
                    saving::opened(self, id);
                    self.look_at_opened();
                    if self.editor.view().is_some() {
                        self.look = Some(ViewTarget::Kept);
                    }
                    if sharing::opened(self, id) {
                        outcome
                            .message
                            .push_str(". It came by a link: the first change makes it your own copy");
                    }
                    self.say_opened(&outcome, &running.notes);
                } else {
                    if outcome.op == Task::Op(OpId::New) {
                        self.look_at_new();
                    }
                    self.toast(MessageKind::Info, outcome.message.clone(), outcome.warnings.clone());
                    if self.editor.revision() != revision {
                        self.toasts.offer(Remedy::UndoEdit { revision: self.editor.revision() });
                    }
                }
                outcome.warnings.extend(running.notes);
                if let Some(reply) = running.reply {
                    reply(Ok(Answer::Outcome(outcome)));
                }
            }
            Ok(Finished::Exported(files)) => match running.reply {
                Some(reply) => reply(Ok(Answer::Files(files))),
                None => saving::write(self, id, files, running.saves),
            },
            Ok(Finished::Shared(link)) => drop(sharing::made(self, id, Ok(link))),
            Ok(Finished::Decoded(picture)) => self.decoded.push((id, Ok(picture))),
            Err(error) if decodes => self.decoded.push((id, Err(error.problem))),
            Err(error) if sharing::made(self, id, Err(error.message())) => {}
            Err(error) => {
                sharing::failed(self, id);
                self.refused(&error, running.reply);
            }
        }
    }

    /// Frames a new shape if it is the whole document; an added one may belong where the user is looking.
    fn look_at_new(&mut self) {
        if self.editor.document().objects().len() == 1 {
            self.look_at_opened();
        }
    }

    fn look_at_opened(&mut self) {
        let flat = |object: &editor::Object| {
            object.bezier().and_then(editor::Bezier::curve).is_some_and(bezier::is_flat)
        };
        let objects = self.editor.document().objects();
        let is_flat = !objects.is_empty() && objects.iter().all(flat);
        self.look = Some(if is_flat { ViewTarget::FlatCurves } else { ViewTarget::Document });
    }

    /// Says what was opened; `notes` are about files that could not be fetched.
    fn say_opened(&mut self, outcome: &editor::Outcome, notes: &[String]) {
        let mut text = outcome.message.clone();
        let missing = self.editor.document().materials().missing_images();
        match outcome.warnings.as_slice() {
            [] => {}
            [only] => text = format!("{} {}", sentence(&text), sentence(only)),
            [first, rest @ ..] => {
                let rest = counted(rest.len(), "more change", "more changes");
                text = format!("{} {} The import made {rest}.", sentence(&text), sentence(first));
            }
        }
        if let Some(first) = notes.first() {
            text = format!("{} {first}", sentence(&text));
        } else if !missing.is_empty() {
            text = format!(
                "{} Images are missing: drop {} on the page.",
                sentence(&text),
                first_few(&missing, 3)
            );
        }
        let is_clean = outcome.warnings.is_empty() && notes.is_empty() && missing.is_empty();
        let kind = if is_clean { MessageKind::Info } else { MessageKind::Warning };
        // What the text says already is not repeated.
        let warnings = if outcome.warnings.len() > 1 { outcome.warnings.as_slice() } else { &[] };
        let details = warnings.iter().chain(notes.iter().skip(1)).cloned().collect();
        self.toast(kind, text, details);
        if self.editor.document().active().is_some_and(editor::Object::is_repairable) {
            self.toasts.offer(Remedy::Act(Action::Operation(OpId::RepairImport)));
        }
    }

    /// Reports a refusal to the caller that waits for the command, or else to the user.
    pub fn refused(&mut self, error: &CommandError, reply: Option<Reply>) {
        match reply {
            Some(reply) => reply(Err(error.to_string())),
            None => self.refuse(error),
        }
    }

    /// Runs the last operation again with other fields.
    pub fn adjust(&mut self, command: Command) {
        let started = self.platform.now();
        let label = command.op.label();
        let begun = self.editor.adjust(command);
        let seconds = self.platform.now() - started;
        self.work_seconds += seconds;
        match begun {
            Ok(Begun::Done(outcome)) => {
                self.adjusting_is_slow = seconds > MAX_SECONDS_PER_STEP;
                if !outcome.warnings.is_empty() {
                    self.warn(outcome.message, outcome.warnings);
                }
            }
            Ok(Begun::Selecting) => {}
            Ok(Begun::Job(request)) => {
                self.adjusting_is_slow = true;
                self.start(&request, label.to_owned(), None);
            }
            Err(error) => self.refuse(&error),
        }
    }

    /// Cancels a job and tells the caller that waits for it.
    pub fn cancel_job(&mut self, id: JobId) {
        self.editor.cancel_job(id);
        self.platform.cancel_job(id.0);
        if let Some(reply) = self.jobs.take(id.0).and_then(|job| job.reply) {
            reply(Err(CANCELLED.to_owned()));
        }
    }

    /// Starts the job that writes the document's files, and returns it.
    pub fn save(&mut self, format: Format, name: String, brings_back_all: bool) -> JobId {
        // Committed first, so that the revision that counts as saved is the one in the files.
        self.end_live(true);
        self.editor.commit_edit();
        let request = self.editor.begin_export_as(format, name);
        let revision = self.editor.revision();
        self.start(&request, format!("Save as {}", format.name()), None);
        if brings_back_all {
            self.jobs.set_saved_revision(request.id(), revision);
        }
        request.id()
    }
}

/// Gives images to the materials that name them.
fn take_images(session: &mut Session, files: &[NamedBytes], reply: Option<Reply>) {
    session.end_live(true);
    match session.editor.take_images(files) {
        Ok(outcome) => {
            session.toast(MessageKind::Info, outcome.message.clone(), outcome.warnings.clone());
            if let Some(reply) = reply {
                reply(Ok(Answer::Outcome(outcome)));
            }
        }
        Err(error) => session.refused(&error, reply),
    }
}

/// Adds notes to an error: if a file could not be read without a companion file, why that is missing.
fn with_notes(mut error: CommandError, notes: &[String]) -> CommandError {
    for note in notes {
        error.problem = format!("{} {note}", sentence(&error.problem));
    }
    error
}
