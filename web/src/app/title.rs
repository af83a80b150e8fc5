//! The title of the page, which browsers show on its tab.

use editor::Editor;

use crate::session::Session;

/// Before the name of a document with changes that are in no file yet.
const UNSAVED_MARK: &str = "• ";

/// Sets the title if it is no longer right.
pub(super) fn follow(session: &mut Session, shown: &mut String) {
    let title = title(&session.editor);
    if *shown != title {
        session.platform.set_title(&title);
        *shown = title;
    }
}

fn title(editor: &Editor) -> String {
    let mark = if editor.is_dirty() { UNSAVED_MARK } else { "" };
    format!("{mark}{} – Meshwright", editor.document().name())
}
