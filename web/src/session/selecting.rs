//! Selecting in large meshes, some elements in each frame.

use editor::{MessageKind, Outcome};
use halfedge::Budget;

use super::jobs::{Answer, Reply};
use super::{CANCELLED, Session};

/// Looks for more elements to select, as many as the frame's budget has.
pub(crate) fn select_some(session: &mut Session, budget: &mut Budget) {
    session.editor.select_some(budget);
    if session.editor.is_selecting() {
        session.ctx.request_repaint();
    }
    let Some(outcome) = session.editor.take_selected() else { return };
    say_if_nothing_found(session, &outcome);
    if let Some(reply) = session.selecting.take() {
        reply(Ok(Answer::Outcome(outcome)));
    }
}

/// Completes what is being looked for.
pub(crate) fn finish_selecting(session: &mut Session) {
    select_some(session, &mut Budget::unlimited());
}

/// Stops looking for elements to select; returns whether it was going on.
pub(crate) fn cancel_selecting(session: &mut Session) -> bool {
    let was_selecting = session.editor.cancel_selecting();
    if was_selecting && let Some(reply) = session.selecting.take() {
        reply(Err(CANCELLED.to_owned()));
    }
    was_selecting
}

/// Begins to wait for a command that looks for elements.
pub(super) fn wait(session: &mut Session, reply: Option<Reply>) {
    // The editor has completed the one before.
    select_some(session, &mut Budget::new(0));
    session.selecting = reply;
}

/// Says that a command found nothing to select, which nothing else would show.
pub(super) fn say_if_nothing_found(session: &mut Session, outcome: &Outcome) {
    if session.editor.selection().is_empty() {
        session.toast(MessageKind::Info, outcome.message.clone(), Vec::new());
    }
}
