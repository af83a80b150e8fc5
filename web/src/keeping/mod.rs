//! Keeping the document in the browser, so that nothing is lost when the page ends.
//!
//! What is done is logged within the frame. Now and then the document as a whole is copied, in parts, as a checkpoint; the
//! log begins again after it. At the next visit, [`opening`] reads the checkpoint and repeats the log.

mod list;
mod messages;
mod opening;
mod place;
mod saved_view;
mod thumbnail;
mod writing;

pub(crate) use list::{OfDocument, toggle_list};
pub(crate) use saved_view::SavedView;
pub(crate) use thumbnail::Thumbnail;

use std::collections::HashMap;

use editor::{Editor, MessageKind, Origin};
use meshwright_worker::store::{Answer, Bytes, Failure, Id, Request, WhyNot};

use crate::embedding;
use crate::session::toasts::Remedy;
use crate::session::{Session, sharing};
use crate::shown::Shown;
use crate::view::View;
use opening::Opening;
use place::Place;
use writing::Writing;

/// The setting with the document that the next visit opens, and in which this tab shows what it shows.
const DOCUMENT_SETTING: &str = "document";

/// The setting with this tab's document as long as nothing was done in it: another tab may sweep it while this one is closed.
const UNTOUCHED_SETTING: &str = "untouched";

/// The setting with the document that the next visit opens if the one above never came to the disk.
const BEFORE_SETTING: &str = "document-before";

/// How the document is kept.
#[derive(Default)]
pub(crate) struct Keeper {
    /// The document that is being opened.
    opening: Option<Opening>,
    /// The document that the page shows; none while the page waits for one.
    kept: Option<Kept>,
    /// The documents that the history goes back to.
    ids: HashMap<Origin, Id>,
    /// The last document that was shown and is on the disk.
    on_disk: Option<Id>,
    /// Why nothing is kept.
    failure: Option<Failure>,
    /// When to try again after a failure, on the platform's clock in seconds.
    retry_at: f64,
    /// Whether the store's program has ended since the last checkpoint.
    has_crashed: bool,
    /// Whether the store's program is another one than that which opened the document.
    store_is_new: bool,
    /// Whether the user was told about the failure.
    has_told: bool,
    /// Whether the browser was asked to keep what is kept.
    has_persisted: bool,
    /// The file that it is saved to.
    place: Place,
    /// Whether the store was asked to remove what earlier visits left behind.
    has_swept: bool,
}

/// The document that the page shows.
struct Kept {
    id: Id,
    origin: Origin,
    /// The revision in which nothing was done yet.
    first_revision: u64,
    is_touched: bool,
    writing: Writing,
}

impl Keeper {
    /// Starts with the document of this tab, or else that of the last visit, unless the page's address names files; or
    /// with a new one.
    pub fn start(session: &mut Session) -> Self {
        let mut keeper = Self::default();
        let platform = &mut session.platform;
        if embedding::is_embedded(&**platform) {
            // The page around it must neither see nor replace what the user keeps.
            session.open_first();
            sharing::open_address(session);
            return keeper;
        }
        if sharing::is_link(&platform.fragment()) {
            keeper.start_new(session);
            return keeper;
        }
        let last = || match platform.wanted().is_empty() {
            true => platform.load_setting(DOCUMENT_SETTING),
            false => None,
        };
        let kept = platform.load_tab_setting(DOCUMENT_SETTING).or_else(last).filter(|id| !id.is_empty());
        match kept {
            Some(id) => {
                let copy = platform.new_id();
                keeper.opening = Some(Opening::begin(session, id, copy, false));
            }
            None => keeper.start_new(session),
        }
        keeper
    }

    /// Whether the page waits for the document of the last visit.
    pub fn is_opening(&self) -> bool {
        self.opening.is_some()
    }

    /// Whether leaving the page loses nothing.
    pub fn keeps_all(&self, editor: &Editor) -> bool {
        self.failure.is_none() && self.kept.as_ref().is_some_and(|kept| kept.writing.is_up_to_date(editor))
    }

    /// Begins with the document of a first visit, unless something was opened meanwhile.
    fn start_new(&mut self, session: &mut Session) {
        session.editor.start_log();
        let is_untouched = session.editor.revision() == 0;
        if is_untouched {
            session.open_first();
        }
        self.begin(session, !is_untouched);
        sharing::open_address(session);
    }

    /// Goes on with what the page shows, because no other document is opened.
    fn go_back(&mut self, session: &mut Session) {
        match self.kept.take() {
            Some(Kept { id, is_touched, .. }) => self.begin_as(session, id, is_touched),
            None => self.start_new(session),
        }
    }

    /// Begins to keep the editor's document as a new one.
    fn begin(&mut self, session: &mut Session, is_touched: bool) {
        let id = session.platform.new_id();
        self.begin_as(session, id, is_touched);
    }

    /// Begins to keep the editor's document as this one. A checkpoint follows.
    fn begin_as(&mut self, session: &mut Session, id: Id, is_touched: bool) {
        session.platform.ask_store(&Request::Begin(id.clone()), &[]);
        self.show(session, id, is_touched, Writing::default());
    }

    /// Makes the editor's document the one that the page shows.
    fn show(&mut self, session: &mut Session, id: Id, is_touched: bool, writing: Writing) {
        let origin = session.editor.document().origin();
        session.platform.store_tab_setting(DOCUMENT_SETTING, &id);
        session.platform.store_tab_setting(UNTOUCHED_SETTING, if is_touched { "" } else { &id });
        if is_touched {
            session.platform.store_setting(DOCUMENT_SETTING, &id);
        }
        if writing.is_checked {
            self.on_disk = Some(id.clone());
        }
        set_before(session, self.on_disk.as_ref().filter(|before| **before != id));
        session.documents.shown = Some(id.clone());
        self.ids.insert(origin, id.clone());
        let first_revision = session.editor.revision();
        self.kept = Some(Kept { id, origin, first_revision, is_touched, writing });
    }

    /// Handles an answer of the store. Returns whether the page begins with a new document because of it.
    pub fn answered(&mut self, session: &mut Session, answer: Answer, bytes: Bytes) -> bool {
        match answer {
            Answer::Part { opening } => {
                if let Some(opening) = self.opening_of(&opening) {
                    opening.add(bytes);
                }
            }
            Answer::Discard { opening } => {
                if let Some(opening) = self.opening_of(&opening) {
                    opening.discard();
                }
            }
            Answer::Opened(opened) => {
                let opening = self.opening_of(&opened.opening);
                let begun = opening.map(|opening| opening.begin_replay(opened, &bytes));
                if let Some(Err(reason)) = begun {
                    return self.not_opened(session, Some(messages::unreadable(&reason)));
                }
                session.ctx.request_repaint();
            }
            Answer::NotOpened { opening, why } => {
                let untouched = session.platform.load_tab_setting(UNTOUCHED_SETTING);
                let Some(opening) = self.opening_of(&opening) else { return false };
                let is_no_loss = why == WhyNot::Missing && untouched.is_some_and(|id| opening.is_of(&id));
                let is_gone = matches!(why, WhyNot::Missing | WhyNot::Damaged);
                if self.kept.is_none() && is_gone && self.open_before(session) {
                    return false;
                }
                let said = (!is_no_loss).then(|| messages::not_opened(&why));
                return self.not_opened(session, said);
            }
            Answer::Busy(id) => {
                if let Some(kept) = self.kept.take_if(|kept| kept.id == id) {
                    self.begin(session, kept.is_touched);
                    session.toast(MessageKind::Info, messages::IS_COPY.to_owned(), Vec::new());
                }
            }
            Answer::Checked(id) => self.checked(session, &id),
            Answer::Failed(failure) => self.fail(session, failure),
            Answer::Crashed(reason) => return self.crashed(session, reason),
            Answer::Listed { documents, picture_bytes } => {
                list::listed(session, documents, &picture_bytes, &bytes);
            }
            Answer::Refused(refusal) => session.warn(messages::refused(&refusal), Vec::new()),
            Answer::Ready => {}
        }
        false
    }

    /// Opens the document before the one that was asked for, which never came to the disk; false if there is none.
    fn open_before(&mut self, session: &mut Session) -> bool {
        let setting = session.platform.load_tab_setting(BEFORE_SETTING);
        let setting = setting.or_else(|| session.platform.load_setting(BEFORE_SETTING));
        let Some(before) = setting.filter(|id| !id.is_empty()) else { return false };
        set_before(session, None);
        session.warn(messages::NOT_ON_DISK.to_owned(), Vec::new());
        let copy = session.platform.new_id();
        self.opening = Some(Opening::begin(session, before, copy, false));
        true
    }

    /// The document that is being opened, if these are answers to that request: one that was given up may be answered yet.
    fn opening_of(&mut self, copy: &str) -> Option<&mut Opening> {
        self.opening.as_mut().filter(|opening| opening.is_named(copy))
    }

    /// A checkpoint is complete.
    fn checked(&mut self, session: &mut Session, id: &str) {
        if !self.is_shown(id) {
            return;
        }
        (self.failure, self.has_crashed) = (None, false);
        if std::mem::take(&mut self.has_told) {
            session.toast(MessageKind::Info, messages::KEPT_AGAIN.to_owned(), Vec::new());
        }
        self.on_disk = Some(id.to_owned());
        set_before(session, None);
        if let Some(kept) = &mut self.kept {
            kept.writing.is_checked = true;
        }
    }

    /// The store's program ended. Another one takes its place, which has to open or begin the document again; if that ends
    /// too, it is tried again later. Returns whether the page begins with a new document because of it.
    fn crashed(&mut self, session: &mut Session, reason: String) -> bool {
        let is_first = !std::mem::replace(&mut self.has_crashed, true);
        if is_first && self.opening.as_mut().is_some_and(|opening| opening.read_again(session)) {
            return false;
        }
        self.store_is_new = true;
        let is_replaying = self.opening.as_ref().is_some_and(Opening::is_replaying);
        let begins = !is_replaying && self.not_opened(session, Some(messages::unreadable(&reason)));
        if is_first {
            session.editor.say(MessageKind::Info, messages::STORE_CRASHED.to_owned());
            if !is_replaying {
                self.begin_in_new_store(session);
            }
        } else {
            self.fail(session, Failure::Other(reason));
        }
        begins
    }

    /// Begins the document again in a store that has not opened it.
    fn begin_in_new_store(&mut self, session: &mut Session) {
        if self.kept.is_some() && std::mem::take(&mut self.store_is_new) {
            self.go_back(session);
        }
    }

    /// Nothing is kept until a later checkpoint succeeds.
    fn fail(&mut self, session: &Session, failure: Failure) {
        self.failure = Some(failure);
        self.retry_at = session.platform.now() + writing::RETRY_SECONDS;
        session.ctx.request_repaint_after_secs(writing::RETRY_SECONDS as f32);
        if let Some(kept) = &mut self.kept {
            kept.writing = Writing::default();
        }
    }

    /// Starts with a new document instead of the one that was asked for, and says why if something is lost. Returns whether one was.
    fn not_opened(&mut self, session: &mut Session, why: Option<String>) -> bool {
        let Some(opening) = self.opening.take() else { return false };
        opening.cancel(session);
        let begins = self.kept.is_none();
        self.go_back(session);
        if let Some(why) = why {
            session.warn(why, Vec::new());
        }
        begins
    }

    /// Goes on with opening or writing, for a few milliseconds. Called at the end of each frame.
    pub fn step(&mut self, session: &mut Session, view: &mut View, shown: &mut Shown) {
        if self.opening.is_some() {
            self.go_on_opening(session, view, shown);
        } else {
            self.write(session, view);
            if let Some(kept) = &self.kept {
                self.place.follow(session, &kept.id, kept.origin);
            }
        }
    }

    /// Carries out a request of the list.
    pub fn carry_out(&mut self, session: &mut Session, request: OfDocument) {
        let now_ms = session.platform.date_ms();
        match request {
            OfDocument::Refresh => session.platform.ask_store(&Request::List, &[]),
            OfDocument::Open(id) => self.open(session, id),
            OfDocument::Rename(id, name) if self.is_shown(&id) => {
                session.editor.rename_document(&name);
                self.ask_list_soon(session);
            }
            OfDocument::Rename(id, name) => session.platform.ask_store(&Request::Rename { id, name }, &[]),
            OfDocument::Duplicate(id, name) => {
                let copy = session.platform.new_id();
                session.platform.ask_store(&Request::Duplicate { id, copy, name }, &[]);
            }
            OfDocument::Delete(id, name) => {
                session.documents.deleted = Some(id.clone());
                session.platform.ask_store(&Request::Delete { id, now_ms }, &[]);
                session.toast(MessageKind::Info, messages::deleted(&name), Vec::new());
                session.toasts.offer(Remedy::RestoreDocument);
            }
            OfDocument::Restore => {
                if let Some(id) = session.documents.deleted.take() {
                    session.platform.ask_store(&Request::Restore(id), &[]);
                }
            }
        }
    }

    /// Whether the page shows this document.
    fn is_shown(&self, id: &str) -> bool {
        self.kept.as_ref().is_some_and(|kept| kept.id == id)
    }

    /// Asks for the list again after what it says about the shown document was written.
    fn ask_list_soon(&mut self, session: &mut Session) {
        let now = session.platform.now();
        if let Some(kept) = &mut self.kept {
            kept.describe(session, now);
        }
        session.platform.ask_store(&Request::List, &[]);
    }

    /// Opens a document instead of the current one.
    fn open(&mut self, session: &mut Session, id: Id) {
        if self.opening.is_some() || self.is_shown(&id) {
            return;
        }
        if let Some(kept) = self.kept.as_mut().filter(|_| self.failure.is_none()) {
            kept.finish(session);
        }
        let copy = session.platform.new_id();
        self.opening = Some(Opening::begin(session, id, copy, true));
    }
}

/// Remembers which document the next visit opens if the shown one doesn't come to the disk.
fn set_before(session: &mut Session, before: Option<&Id>) {
    let before = before.map_or("", String::as_str);
    session.platform.store_tab_setting(BEFORE_SETTING, before);
    session.platform.store_setting(BEFORE_SETTING, before);
}
