//! Opening a kept document: reading its checkpoint, and repeating its log over several frames.

use std::collections::VecDeque;
use std::io::{self, Read};

use editor::recovery::{Entry, Event, Snapshot, read_log};
use editor::{Editor, MessageKind, Wire};
use meshwright_worker::store::{Bytes, Opened};

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

/// A document that is being opened.
#[derive(Default)]
pub(super) struct Opening {
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
    /// Why the rest could not be repeated, and how many changes are missing.
    stopped: Option<(String, usize)>,
}

impl Opening {
    pub fn at(revision: u64) -> Self {
        Self { revision, ..Self::default() }
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
            stopped: None,
        });
        Ok(())
    }
}

impl Replaying {
    /// Repeats one change.
    fn step(&mut self) {
        let Some(entry) = self.entries.pop_front() else { return };
        if let Event::View(view) = &entry.event {
            self.view = Some(view.clone());
        }
        if let Err(error) = self.editor.replay(entry) {
            self.stopped = Some((error.to_string(), self.entries.len() + 1));
            self.entries.clear();
        }
    }
}

impl Keeper {
    /// Repeats more of the log, and shows the document when that is done.
    pub(super) fn go_on_opening(&mut self, session: &mut Session, view: &mut View, shown: &mut Shown) {
        let started = session.platform.now();
        let Some(opening) = &mut self.opening else { return };
        let Some(replaying) = &mut opening.replaying else {
            let waited = started - *opening.waits_since.get_or_insert(started);
            if waited > MAX_WAIT_SECONDS {
                self.not_opened(session, &messages::unreadable("the browser's storage does not answer"));
            } else {
                session.ctx.request_repaint_after_secs((MAX_WAIT_SECONDS - waited) as f32 + 0.1);
            }
            return;
        };
        let mut now = started;
        while !replaying.entries.is_empty() && now - started < SECONDS_PER_FRAME {
            replaying.step();
            now = session.platform.now();
        }
        replaying.seconds += now - started;
        session.ctx.request_repaint();
        if replaying.entries.is_empty()
            && let Some(Opening { replaying: Some(replaying), checkpoint_bytes, revision, .. }) =
                self.opening.take()
        {
            if session.editor.revision() != revision
                || session.editor.is_editing()
                || session.jobs.iter().next().is_some()
            {
                // Something else was begun meanwhile. What was kept stays in the list of documents.
                self.go_back(session);
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
        let Replaying { mut editor, view: saved, opened, log_bytes, seconds, stopped, .. } = replaying;
        let Opened { id, info, is_copy, is_cut_off } = opened;
        editor.end_replay();
        if let Some(name) = &info.renamed {
            editor.rename_document(name);
        }
        editor.take_place_of(&session.editor);
        session.editor = editor;
        // Those of another editor's history.
        self.ids.clear();
        (session.look, session.live) = (None, None);
        (shown.welcome, shown.documents) = (false, false);
        let mut writing = Writing::after(checkpoint_bytes, log_bytes, seconds);
        if stopped.is_some() {
            writing = Writing::default();
        }
        self.show(session, id, info.is_touched, writing);
        match saved.as_deref().and_then(SavedView::read) {
            Some(saved) => saved.show(view),
            None => session.look = Some(ViewTarget::Document),
        }
        if is_copy {
            session.toast(MessageKind::Info, messages::IS_COPY.to_owned(), Vec::new());
        }
        if let Some((why, missing)) = stopped {
            session.warn(messages::not_repeated(&why, missing), Vec::new());
        } else if is_cut_off {
            session.warn(messages::CUT_OFF.to_owned(), Vec::new());
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
