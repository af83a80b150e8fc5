//! Newer versions of the page: offered, never forced.

use editor::MessageKind;

use super::Session;
use super::toasts::Remedy;
use crate::input::actions::Action;

/// Offers to reload the page with a newer version, until the user closes the message; afterwards the Help menu does.
pub(crate) fn offer(session: &mut Session) {
    if std::mem::replace(&mut session.update_is_ready, true) {
        return;
    }
    let text = "A new version of Meshwright is ready. Your document is kept when the page reloads.";
    session.toast(MessageKind::Info, text.to_owned(), Vec::new());
    session.toasts.offer(Remedy::Act(Action::Update));
    session.toasts.stay();
}
