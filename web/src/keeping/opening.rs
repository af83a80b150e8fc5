//! Opening a kept document: reading its checkpoint, and repeating its log over several frames.

use std::collections::VecDeque;
use std::io::{self, Read};

use editor::recovery::{Entry, Event, NotReplayed, Snapshot, read_log};
use editor::{CommandError, Editor, ErrorKind, JobId, JobRequest, JobResult, MessageKind, Wire};
use meshwright_worker::store::{Bytes, Id, Opened, Request};

use super::saved_view::SavedView;
use super::writing::Writing;
use super::{Keeper, messages};
use crate::session::{Session, ViewTarget};
use crate::shown::Shown;
use crate::view::View;

/// How long changes are repeated in a frame. A single one may take longer.
const SECONDS_PER_FRAME: f64 = 0.03;

/// How long the store may take to send the next part before the page begins without it.
const MAX_WAIT_SECONDS: f64 = 8.0;

/// The number of the job that repeats a change. The editor's own jobs have small numbers.
const REPLAY_JOB: u64 = 1 << 48;

/// A document that is being opened.
#[derive(Default)]
pub(super) struct Opening {
    /// The document, and what a copy of it would be called.
    wanted: (Id, Id),
    /// Whether the user asked for it, in the list.
    is_asked_for: bool,
    /// The revision of the page's document when this one was asked for. If that changes, this one is not shown.
    revision: u64,
    /// The parts of its checkpoint that have arrived.
    parts: VecDeque<Bytes>,
    checkpoint_bytes: usize,
    /// When the page began to wait for the next part, on the platform's clock in seconds.
    waits_since: Option<f64>,
    replaying: Option<Replaying>,
}

/// A document whose log is being repeated.
struct Replaying {
    editor: Editor,
    entries: VecDeque<Entry>,
    view: Option<String>,
    opened: Opened,
    log_bytes: usize,
    seconds: f64,
    /// What a worker repeats.
    waits_for: Option<Repeated>,
    /// Whether a worker has failed to repeat the change that comes next.
    has_failed: bool,
    /// Why the rest could not be repeated, and how many changes are missing.
    stopped: Option<(String, usize)>,
    /// How many changes are missing at the end, because the checkpoint that would hold them was not written.
    unwritten: usize,
}

/// A change that a worker repeats.
struct Repeated {
    entry: Entry,
    /// The job in the editor.
    id: JobId,
    /// When it began, on the platform's clock in seconds.
    since: f64,
}

impl Opening {
    /// Asks for a document.
    pub fn begin(session: &mut Session, id: Id, copy: Id, is_asked_for: bool) -> Self {
        let revision = session.editor.revision();
        let opening = Self { wanted: (id, copy), is_asked_for, revision, ..Self::default() };
        opening.ask(session);
        opening
    }

    fn ask(&self, session: &mut Session) {
        let (id, copy) = self.wanted.clone();
        session.platform.ask_store(&Request::Open { id, copy }, &[]);
    }

    /// Whether this document was asked for.
    pub fn is_of(&self, id: &str) -> bool {
        self.wanted.0 == id
    }

    /// Whether a copy of the document would be called so.
    pub fn is_named(&self, copy: &str) -> bool {
        self.wanted.1 == copy
    }

    /// Asks for the document again after the store has lost it. Returns false if it was read already.
    pub fn read_again(&mut self, session: &mut Session) -> bool {
        if self.is_replaying() {
            return false;
        }
        self.discard();
        self.ask(session);
        true
    }

    /// Cancels the job that repeats a change.
    pub fn cancel(self, session: &mut Session) {
        if self.replaying.is_some_and(|replaying| replaying.waits_for.is_some()) {
            session.platform.cancel_job(REPLAY_JOB);
        }
    }

    /// Whether the document was read.
    pub fn is_replaying(&self) -> bool {
        self.replaying.is_some()
    }

    pub fn add(&mut self, part: Bytes) {
        self.checkpoint_bytes += part.len();
        self.waits_since = None;
        self.parts.push_back(part);
    }

    /// Forgets the parts so far.
    pub fn discard(&mut self) {
        (self.checkpoint_bytes, self.waits_since) = (0, None);
        self.parts.clear();
    }

    /// Reads the checkpoint.
    ///
    /// # Errors
    /// Why it is no document.
    pub fn begin_replay(&mut self, opened: Opened, log: &[u8]) -> Result<(), String> {
        let mut parts = Parts { parts: std::mem::take(&mut self.parts), at: 0 };
        let snapshot =
            Snapshot::read_from(&mut parts, self.checkpoint_bytes).map_err(|error| error.to_string())?;
        let records = read_log(log);
        self.replaying = Some(Replaying {
            editor: snapshot.into_editor(),
            entries: records.entries.into(),
            view: None,
            opened,
            log_bytes: records.valid_bytes,
            seconds: 0.0,
            waits_for: None,
            has_failed: false,
            stopped: None,
            unwritten: 0,
        });
        Ok(())
    }
}

impl Replaying {
    /// Repeats one change, or begins to; returns a job for the worker that it takes.
    fn step(&mut self, now: f64) -> Option<JobRequest> {
        let entry = self.entries.pop_front()?;
        if let Event::View(view) = &entry.event {
            self.view = Some(view.clone());
        }
        match self.editor.begin_replay(&entry) {
            Ok(Some(request)) => {
                self.waits_for = Some(Repeated { entry, id: request.id(), since: now });
                return Some(request);
            }
            Ok(None) => {
                let replayed = self.editor.replay(entry);
                self.stop_if(replayed);
            }
            Err(error) => self.stop_if(Err(error)),
        }
        None
    }

    /// Takes what came of repeating a change in a worker.
    fn finish(&mut self, Repeated { entry, id, .. }: Repeated, result: Result<JobResult, CommandError>) {
        let is_workers = result.as_ref().is_err_and(|error| error.kind == ErrorKind::Internal);
        if is_workers && !std::mem::replace(&mut self.has_failed, true) {
            // The worker failed, not the change: another worker tries it once more.
            self.editor.cancel_job(id);
            self.entries.push_front(entry);
            return;
        }
        self.has_failed = false;
        let replayed = self.editor.finish_replay(&entry, id, result);
        self.stop_if(replayed);
    }

    /// Leaves out the rest of the log if a change could not be repeated.
    fn stop_if(&mut self, replayed: Result<(), NotReplayed>) {
        let Err(error) = replayed else { return };
        let is_change = |entry: &&Entry| !matches!(entry.event, Event::View(_) | Event::Select { .. });
        let missing = self.entries.iter().filter(is_change).count() + 1;
        match error {
            NotReplayed::Broken => self.unwritten = missing,
            error => self.stopped = Some((error.to_string(), missing)),
        }
        self.entries.clear();
    }
}

impl Keeper {
    /// Takes the result of a job that repeats a change, and hands on those of others.
    pub fn job_done(&mut self, session: &mut Session, job: u64, result: Result<JobResult, CommandError>) {
        if job != REPLAY_JOB {
            return session.job_done(job, result);
        }
        let replaying = self.opening.as_mut().and_then(|opening| opening.replaying.as_mut());
        if let Some(replaying) = replaying
            && let Some(repeated) = replaying.waits_for.take()
        {
            replaying.seconds += session.platform.now() - repeated.since;
            replaying.finish(repeated, result);
            session.ctx.request_repaint();
        }
    }

    /// Repeats more of the log, and shows the document when that is done.
    pub(super) fn go_on_opening(&mut self, session: &mut Session, view: &mut View, shown: &mut Shown) {
        let started = session.platform.now();
        let Some(opening) = &mut self.opening else { return };
        let Some(replaying) = &mut opening.replaying else {
            let waited = started - *opening.waits_since.get_or_insert(started);
            if waited > MAX_WAIT_SECONDS {
                let why = messages::unreadable("the storage does not answer");
                self.not_opened(session, Some(why));
            } else {
                session.ctx.request_repaint_after_secs((MAX_WAIT_SECONDS - waited) as f32 + 0.1);
            }
            return;
        };
        let mut now = started;
        if replaying.waits_for.is_some() {
            return;
        }
        while !replaying.entries.is_empty() && now - started < SECONDS_PER_FRAME {
            if let Some(request) = replaying.step(now) {
                replaying.seconds += now - started;
                session.platform.start_job(REPLAY_JOB, &request);
                return;
            }
            now = session.platform.now();
        }
        replaying.seconds += now - started;
        session.ctx.request_repaint();
        if replaying.entries.is_empty()
            && let Some(Opening {
                replaying: Some(replaying), checkpoint_bytes, revision, is_asked_for, ..
            }) = self.opening.take()
        {
            if session.editor.revision() != revision
                || session.editor.is_editing()
                || session.jobs.iter().next().is_some()
            {
                // Something else was begun meanwhile. What was kept stays in the list of documents.
                self.go_back(session);
                if is_asked_for {
                    session.warn(messages::NOT_OPENED_NOW.to_owned(), Vec::new());
                }
                return;
            }
            self.finish_opening(session, view, shown, replaying, checkpoint_bytes);
        }
    }

    fn finish_opening(
        &mut self,
        session: &mut Session,
        view: &mut View,
        shown: &mut Shown,
        replaying: Replaying,
        checkpoint_bytes: usize,
    ) {
        let Replaying { mut editor, view: saved, opened, log_bytes, seconds, stopped, unwritten, .. } =
            replaying;
        let Opened { id, info, is_copy, is_cut_off, .. } = opened;
        editor.end_replay();
        if let Some(name) = &info.renamed {
            editor.rename_document(name);
        }
        editor.take_place_of(&session.editor);
        session.editor = editor;
        // Those of another editor's history.
        self.ids.clear();
        (session.look, session.live) = (None, None);
        // Files and links of the other document are not this one's, though its revisions may have the same numbers.
        (session.in_place, session.sharing) = Default::default();
        (shown.welcome, shown.documents) = (false, false);
        if stopped.is_some() {
            // What was kept stays as it is: a later visit may be able to repeat all of it.
            let name = format!("{} (recovered)", session.editor.document().name());
            session.editor.rename_document(&name);
            self.begin(session, true);
        } else {
            let (is_touched, listed) = (info.is_touched, (info, session.editor.revision()));
            let writing = match self.failure {
                None if unwritten == 0 => Writing::after(checkpoint_bytes, log_bytes, seconds, listed),
                _ => Writing::default(),
            };
            self.show(session, id, is_touched, writing);
        }
        self.begin_in_new_store(session);
        match saved.as_deref().and_then(SavedView::read) {
            Some(saved) => saved.show(view),
            None => session.look = Some(ViewTarget::Document),
        }
        if is_copy {
            session.toast(MessageKind::Info, messages::IS_COPY.to_owned(), Vec::new());
        }
        let unwritten = unwritten.max(usize::from(is_cut_off));
        if let Some((why, missing)) = stopped {
            session.warn(messages::not_repeated(&why, missing), Vec::new());
        } else if unwritten > 0 {
            session.warn(messages::not_written(unwritten), Vec::new());
        }
    }
}

/// Bytes in parts, each freed once it is read.
struct Parts {
    parts: VecDeque<Bytes>,
    at: usize,
}

impl Read for Parts {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        loop {
            let Some(first) = self.parts.front() else { return Ok(0) };
            let rest = first.get(self.at..).unwrap_or_default();
            if rest.is_empty() {
                self.parts.pop_front();
                self.at = 0;
                continue;
            }
            let len = rest.len().min(bytes.len());
            if let (Some(to), Some(from)) = (bytes.get_mut(..len), rest.get(..len)) {
                to.copy_from_slice(from);
            }
            self.at += len;
            return Ok(len);
        }
    }
}
