//! The guide, which is read outside the editor.

use editor::MessageKind;

use super::Session;

/// Opens the guide, or says where it is.
pub(crate) fn open(session: &mut Session) {
    if !session.platform.open_guide() {
        let text =
            "The guide can't be opened from here. It is in the folder docs/guide of Meshwright's source.";
        session.toast(MessageKind::Info, text.to_owned(), Vec::new());
    }
}
