//! Ongoing edits, with the time that they take.

use editor::{Command, CommandError, Outcome};

use super::Session;

/// Shows an ongoing edit in the document, and measures how long that takes.
pub(crate) fn update_edit(session: &mut Session, command: Command) -> Result<Outcome, CommandError> {
    let started = session.platform.now();
    let outcome = session.editor.update_edit(command);
    session.edit_seconds = session.platform.now() - started;
    outcome
}
