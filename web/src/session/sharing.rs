//! Links: making one to the document, and showing a document that came by one.

use editor::project::{LINK_MARK, Link};
use editor::{JobId, MessageKind, Origin};
use formats::NamedBytes;

use super::Session;

/// What is known about links.
#[derive(Default)]
pub(crate) struct Sharing {
    /// The link to the document, or why there is none, and the state that it was made of.
    made: Option<(State, Made)>,
    making: Option<(State, JobId)>,
    /// The job that opens a link.
    opening: Option<JobId>,
    /// The state of a document that came by a link, until it is changed.
    shown: Option<(u64, Origin)>,
}

/// What a link depends on: the revision of the document and its name.
type State = (u64, String);

/// What came of making a link.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Made {
    Link(Link),
    /// The document is too large for any link.
    TooLarge,
    /// Making it failed, in words.
    Failed(String),
}

fn state(session: &Session) -> State {
    (session.editor.revision(), session.editor.document().name().to_owned())
}

/// The link to the document as it is; none while it is not made yet.
pub(crate) fn link(session: &Session) -> Option<&Made> {
    session.sharing.made.as_ref().filter(|(of, _)| *of == state(session)).map(|(_, made)| made)
}

/// Whether the document came by a link and was not changed since.
pub(crate) fn is_shared(session: &Session) -> bool {
    session.sharing.shown.as_ref().is_some_and(|(revision, _)| *revision == session.editor.revision())
}

/// Starts to make a link, unless it is known or being made.
pub(crate) fn make(session: &mut Session) {
    let now = state(session);
    let is_running = |id: JobId| session.jobs.iter().any(|job| job.id == id);
    let is_making = session.sharing.making.as_ref().is_some_and(|(of, id)| *of == now && is_running(*id));
    if is_making || link(session).is_some() || session.editor.is_editing() {
        return;
    }
    if let Some((_, id)) = session.sharing.making.take() {
        session.cancel_job(id);
    }
    match session.editor.begin_share() {
        Some(request) => {
            session.sharing.making = Some((now, request.id()));
            session.start(&request, "Make link".to_owned(), None);
        }
        None => session.sharing.made = Some((now, Made::TooLarge)),
    }
}

/// Keeps a link that was made, or why it was not; false if the job makes none.
pub(crate) fn made(session: &mut Session, id: JobId, made: Result<Link, String>) -> bool {
    let Some((of, _)) = session.sharing.making.take_if(|(_, making)| *making == id) else { return false };
    let made = match made {
        Ok(link) if link.fragment.is_empty() => Made::TooLarge,
        Ok(link) => Made::Link(link),
        Err(reason) => Made::Failed(reason),
    };
    session.sharing.made = Some((of, made));
    true
}

/// Whether the fragment of an address is a link.
pub(crate) fn is_link(fragment: &str) -> bool {
    fragment.starts_with(LINK_MARK)
}

/// Opens what the page's address names: a link's document, or files.
pub(crate) fn open_address(session: &mut Session) {
    let fragment = session.platform.fragment();
    if is_link(&fragment) {
        open(session, &fragment);
    } else {
        session.fetch_wanted();
    }
}

/// Opens the document of a link. Other fragments mean nothing.
pub(crate) fn open(session: &mut Session, fragment: &str) {
    if !is_link(fragment) {
        return;
    }
    let request = session.editor.begin_import(vec![NamedBytes::new("link", fragment)]);
    session.sharing.opening = Some(request.id());
    session.start(&request, "Open the shared document".to_owned(), None);
}

/// Marks the document as shared, if the job that opened it opened a link; returns whether it did.
pub(crate) fn opened(session: &mut Session, id: JobId) -> bool {
    let is_link = session.sharing.opening.take_if(|opening| *opening == id).is_some();
    if is_link {
        session.sharing.shown = Some((session.editor.revision(), session.editor.document().origin()));
    }
    is_link
}

/// Forgets a link that could not be opened: a reload brings back what this tab shows.
pub(crate) fn failed(session: &mut Session, id: JobId) {
    if session.sharing.opening.take_if(|opening| *opening == id).is_some() {
        session.platform.clear_fragment();
    }
}

/// Makes a shared document the user's own with the first change.
pub(crate) fn follow(session: &mut Session) {
    let (revision, origin) = (session.editor.revision(), session.editor.document().origin());
    let Some((shared, of)) = session.sharing.shown.take_if(|(shared, _)| *shared != revision) else { return };
    // The address would bring back the document without the change.
    session.platform.clear_fragment();
    // Otherwise it was undone, or another document took its place.
    if revision > shared && origin == of {
        let name = format!("{} (copy)", session.editor.document().name());
        session.editor.rename_document(&name);
        let text = format!("This is your own copy now: {name}.");
        session.toast(MessageKind::Info, text, Vec::new());
    }
}
