//! The file that the shown document is saved to, remembered with the document so that a later visit saves there too.

use editor::Origin;
use meshwright_worker::store::Id;

use crate::platform::PlacedFile;
use crate::session::Session;

/// What is remembered of the shown document.
#[derive(Default)]
pub(super) struct Place {
    document: Option<Id>,
    file: Option<PlacedFile>,
}

impl Place {
    /// Asks for the file of a document that the page has come to show, and remembers the file that it is saved to now.
    pub fn follow(&mut self, session: &mut Session, document: &Id, of: Origin) {
        if self.document.as_ref() != Some(document) {
            *self = Self { document: Some(document.clone()), file: None };
            session.platform.recall_file(document);
        }
        let file = session.in_place.file.as_ref().filter(|(origin, _)| *origin == of);
        let file = file.map(|(_, file)| file);
        // Until one is recalled, none is known, which is no reason to forget it.
        if self.file.as_ref() != file {
            session.platform.remember_file(document, file);
            self.file = file.cloned();
        }
    }
}
