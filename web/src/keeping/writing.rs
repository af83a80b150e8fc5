//! Writing the log and checkpoints of the document that the page shows.

use editor::Editor;
use editor::recovery::{Entry, Event, SnapshotCopy, append_record};
use halfedge::Element;
use meshwright_worker::store::{Info, Request};

use super::saved_view::SavedView;
use super::thumbnail::Thumbnail;
use super::{DOCUMENT_SETTING, Keeper, Kept, UNTOUCHED_SETTING, messages};
use crate::session::Session;
use crate::view::View;

/// How much of a checkpoint is copied in a frame: it takes about two milliseconds.
const BYTES_PER_FRAME: usize = 2 << 20;

/// A log that takes longer to repeat gets a checkpoint.
const MAX_REPLAY_SECONDS: f64 = 1.0;

/// A log that is longer than its checkpoint and than this gets a checkpoint.
const MIN_LONG_LOG_BYTES: usize = 1 << 20;

/// How often the view and an ongoing edit are logged.
const DRAFT_SECONDS: f64 = 2.0;

/// How often what the list says about the document is brought up to date.
const INFO_SECONDS: f64 = 5.0;

/// How often the picture in the list is drawn again.
const PICTURE_SECONDS: f64 = 15.0;

/// How long after a failure writing is tried again.
pub(super) const RETRY_SECONDS: f64 = 30.0;

/// The browser is asked to keep what is kept after this many changes: by then there is something to lose.
const CHANGES_BEFORE_PERSISTING: u64 = 10;

/// What is written of a document.
#[derive(Default)]
pub(super) struct Writing {
    /// The checkpoint that is being copied.
    copy: Option<SnapshotCopy>,
    /// Whether there is a checkpoint that the log continues.
    has_checkpoint: bool,
    /// Whether the last checkpoint is on the disk.
    pub is_checked: bool,
    checkpoint_bytes: usize,
    log_bytes: usize,
    /// How long it takes to repeat the log, about.
    replay_seconds: f64,
    /// How long it takes to repeat what was done since the copy was begun.
    seconds_since_copy: f64,
    /// The view that was logged last.
    view: Option<SavedView>,
    view_at: f64,
    draft_at: f64,
    /// What the list was told last, and in which revision.
    info: Option<(Info, u64)>,
    info_at: f64,
    picture_at: Option<f64>,
}

impl Writing {
    /// Goes on after a checkpoint and a log. `info` is what the list says about the document in this revision.
    pub fn after(checkpoint_bytes: usize, log_bytes: usize, replay_seconds: f64, info: (Info, u64)) -> Self {
        let info = Some(info).filter(|(info, _)| info.renamed.is_none());
        let (has_checkpoint, is_checked) = (true, true);
        Self {
            has_checkpoint,
            is_checked,
            checkpoint_bytes,
            log_bytes,
            replay_seconds,
            info,
            ..Self::default()
        }
    }

    /// Whether everything that was done is on its way to the disk: the log continues a checkpoint, also while another one is
    /// copied.
    pub fn is_up_to_date(&self, editor: &Editor) -> bool {
        self.is_checked && self.has_checkpoint && !editor.needs_snapshot()
    }

    fn needs_checkpoint(&self) -> bool {
        !self.has_checkpoint
            || self.replay_seconds > MAX_REPLAY_SECONDS
            || self.log_bytes > self.checkpoint_bytes.max(MIN_LONG_LOG_BYTES)
    }
}

impl Keeper {
    /// Writes what was done in this frame, and more of a checkpoint.
    pub(super) fn write(&mut self, session: &mut Session, view: &View) {
        self.follow_document(session);
        if session.platform.now() >= self.retry_at {
            self.begin_in_new_store(session);
        }
        let Some(kept) = &mut self.kept else { return };
        if !std::mem::replace(&mut self.has_swept, true) {
            let now_ms = session.platform.date_ms();
            session.platform.ask_store(&Request::Sweep { now_ms }, &[]);
        }
        let now = session.platform.now();
        kept.log_view_and_draft(session, view, now);
        kept.touch(session);
        kept.append(session);
        let may_try = self.failure.is_none() || now >= self.retry_at;
        if may_try && kept.writes_checkpoint(session) {
            kept.copy_checkpoint(session, BYTES_PER_FRAME);
            // No checkpoint holds the view.
            kept.log_view_and_draft(session, view, now);
            kept.append(session);
        }
        if self.failure.is_none() {
            kept.describe(session, now);
        }
        if let Some(failure) = self.failure.as_ref().filter(|_| kept.is_touched && !self.has_told) {
            self.has_told = true;
            session.warn(messages::not_kept(failure), Vec::new());
        }
        let changes = session.editor.revision() - kept.first_revision.min(session.editor.revision());
        if !self.has_persisted && changes >= CHANGES_BEFORE_PERSISTING {
            self.has_persisted = true;
            session.platform.persist();
        }
    }

    /// Changes to another kept document when another one was opened or begun, or when undo brought one back.
    fn follow_document(&mut self, session: &mut Session) {
        let origin = session.editor.document().origin();
        if self.kept.as_ref().is_none_or(|kept| kept.origin == origin) {
            return;
        }
        if let Some(kept) = &mut self.kept {
            kept.end(session);
        }
        let known = self.ids.get(&origin).cloned();
        let has_changed = session.editor.revision() != origin.revision;
        let is_touched = known.is_some() || origin.is_file || has_changed;
        let id = known.unwrap_or_else(|| session.platform.new_id());
        self.begin_as(session, id, is_touched);
    }
}

impl Kept {
    fn log_view_and_draft(&mut self, session: &mut Session, view: &View, now: f64) {
        let writing = &mut self.writing;
        let seen = SavedView::of(view);
        if writing.view != Some(seen) && view.frame_due == 0 {
            let due = writing.view_at + DRAFT_SECONDS - now;
            if writing.view.is_none() || due <= 0.0 {
                session.editor.log_view(seen.to_json());
                (writing.view, writing.view_at) = (Some(seen), now);
            } else {
                session.ctx.request_repaint_after_secs(due as f32);
            }
        }
        if session.editor.is_editing() {
            let due = writing.draft_at + DRAFT_SECONDS - now;
            if due <= 0.0 {
                session.editor.log_draft();
                writing.draft_at = now;
            } else {
                session.ctx.request_repaint_after_secs(due as f32);
            }
        } else {
            writing.draft_at = now;
        }
    }

    /// Notes whether something was done in the document.
    fn touch(&mut self, session: &mut Session) {
        if !self.is_touched && session.editor.revision() != self.first_revision {
            self.is_touched = true;
            session.platform.store_tab_setting(UNTOUCHED_SETTING, "");
            session.platform.store_setting(DOCUMENT_SETTING, &self.id);
        }
    }

    fn append(&mut self, session: &mut Session) {
        let entries = session.editor.take_log();
        self.append_entries(session, &entries);
    }

    fn append_entries(&mut self, session: &mut Session, entries: &[Entry]) {
        let edits = entries.iter().filter(|entry| matches!(entry.event, Event::Edit(_))).count();
        let seconds = std::mem::take(&mut session.work_seconds) + edits as f64 * session.edit_seconds;
        self.writing.seconds_since_copy += seconds;
        if entries.is_empty() || !self.writing.has_checkpoint {
            return;
        }
        let bytes = records(entries);
        self.writing.log_bytes += bytes.len();
        self.writing.replay_seconds += seconds;
        session.platform.ask_store(&Request::Append(self.id.clone()), &bytes);
    }

    /// Whether a checkpoint is being copied or has to be.
    fn writes_checkpoint(&self, session: &Session) -> bool {
        self.writing.copy.is_some() || self.writing.needs_checkpoint() || session.editor.needs_snapshot()
    }

    /// Copies this much more of a checkpoint, and begins one if none is being copied.
    fn copy_checkpoint(&mut self, session: &mut Session, bytes: usize) {
        let is_outdated = session.editor.has_outdated_copy();
        let going_on = self.writing.copy.take().filter(|_| !is_outdated);
        let is_first = going_on.is_none();
        // None during an edit: its end is a change, and then there is another frame.
        let Some(copy) = going_on.or_else(|| SnapshotCopy::begin(&mut session.editor)) else { return };
        if is_first {
            self.writing.seconds_since_copy = 0.0;
        }
        self.go_on_copying(session, copy, is_first, bytes, Editor::take_log);
    }

    /// Copies this much more of a checkpoint. `take_log` gives what was done since it was begun, which it ends with.
    fn go_on_copying(
        &mut self,
        session: &mut Session,
        mut copy: SnapshotCopy,
        is_first: bool,
        bytes: usize,
        take_log: impl FnOnce(&mut Editor) -> Vec<Entry>,
    ) {
        let mut part = Vec::with_capacity(bytes.min(copy.total_bytes()));
        copy.step(bytes, &mut |piece| part.extend_from_slice(piece));
        let (id, now_ms) = (self.id.clone(), session.platform.date_ms());
        if !copy.is_done() {
            let request = Request::Checkpoint { id, is_first, is_last: false, log_bytes: 0, now_ms };
            session.platform.ask_store(&request, &part);
            self.writing.copy = Some(copy);
            session.ctx.request_repaint();
            return;
        }
        let checkpoint_bytes = copy.total_bytes();
        copy.finish(&mut session.editor);
        let log = records(&take_log(&mut session.editor));
        part.extend_from_slice(&log);
        let log_bytes = log.len() as u64;
        let request = Request::Checkpoint { id, is_first, is_last: true, log_bytes, now_ms };
        session.platform.ask_store(&request, &part);
        self.writing = Writing {
            has_checkpoint: true,
            checkpoint_bytes,
            log_bytes: log.len(),
            replay_seconds: self.writing.seconds_since_copy,
            info: self.writing.info.take(),
            info_at: self.writing.info_at,
            picture_at: self.writing.picture_at,
            ..Writing::default()
        };
    }

    /// Writes all that is missing at once, because another document is opened.
    pub(super) fn finish(&mut self, session: &mut Session) {
        self.append(session);
        if self.writes_checkpoint(session) {
            self.copy_checkpoint(session, usize::MAX);
        }
    }

    /// Writes all that is missing at once, after another document has taken the place of this one in the editor.
    fn end(&mut self, session: &mut Session) {
        let origin = self.origin;
        if let Some(copy) = self.writing.copy.take() {
            self.go_on_copying(session, copy, false, usize::MAX, |editor| editor.take_log_of(origin));
        } else {
            let entries = session.editor.take_log_of(origin);
            self.append_entries(session, &entries);
        }
    }

    /// Brings up to date what the list of documents says.
    pub(super) fn describe(&mut self, session: &mut Session, now: f64) {
        let (document, revision) = (session.editor.document(), session.editor.revision());
        let last = self.writing.info.as_ref();
        let is_same = |(info, _): &(Info, u64)| {
            (info.name.as_str(), info.is_touched) == (document.name(), self.is_touched)
        };
        let is_listed = last.is_some_and(is_same);
        if is_listed && last.is_some_and(|(_, at)| *at == revision) {
            return;
        }
        let due = self.writing.info_at + INFO_SECONDS - now;
        if is_listed && due > 0.0 {
            session.ctx.request_repaint_after_secs(due as f32);
            return;
        }
        let count = |kind: Element| -> u64 {
            document.objects().iter().map(|object| object.mesh().count(kind) as u64).sum()
        };
        let info = Info {
            name: document.name().to_owned(),
            sizes: [document.objects().len() as u64, count(Element::Vertex), count(Element::Face)],
            changed_ms: session.platform.date_ms(),
            is_touched: self.is_touched,
            ..Info::default()
        };
        session.platform.ask_store(&Request::Describe { id: self.id.clone(), info: info.clone() }, &[]);
        if self.writing.picture_at.is_none_or(|at| now - at >= PICTURE_SECONDS) {
            self.writing.picture_at = Some(now);
            let picture = Thumbnail::of(session.editor.document()).to_bytes();
            session.platform.ask_store(&Request::Picture(self.id.clone()), &picture);
        }
        (self.writing.info, self.writing.info_at) = (Some((info, revision)), now);
    }
}

fn records(entries: &[Entry]) -> Vec<u8> {
    let mut bytes = Vec::new();
    entries.iter().for_each(|entry| append_record(&mut bytes, entry));
    bytes
}
