//! The list of the documents that the browser keeps.

use meshwright_worker::store::{Bytes, Id, Kept, Request};

use crate::session::Session;
use crate::shown::Shown;

/// Something to be done with a kept document.
#[derive(Clone, Debug)]
pub(crate) enum OfDocument {
    /// Bring the list up to date.
    Refresh,
    /// Show it instead of the current one, which stays in the list.
    Open(Id),
    Rename(Id, String),
    /// Copy it, under this name.
    Duplicate(Id, String),
    Delete(Id, String),
    /// Bring back the one that was deleted last.
    Restore,
}

/// Opens or closes the window with the list.
pub(crate) fn toggle_list(session: &mut Session, shown: &mut Shown) {
    shown.documents ^= true;
    if shown.documents {
        session.platform.ask_store(&Request::List, &[]);
    }
}

/// Takes the store's answer.
pub(super) fn listed(
    session: &mut Session,
    mut documents: Vec<Kept>,
    picture_bytes: &[usize],
    pictures: &Bytes,
) {
    let mut rest = pictures.as_slice();
    for (kept, len) in documents.iter_mut().zip(picture_bytes) {
        let (picture, after) = rest.split_at(rest.len().min(*len));
        kept.picture = picture.to_vec();
        rest = after;
    }
    session.documents.documents = Some(documents);
    session.documents.version += 1;
    session.ctx.request_repaint();
}
