//! The file that the shown document is saved to, remembered with the document so that a later visit saves there too.

use meshwright_worker::store::Id;

use super::Kept;
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
    pub fn follow(&mut self, session: &mut Session, kept: &Kept) {
        if self.document.as_ref() != Some(&kept.id) {
            *self = Self { document: Some(kept.id.clone()), file: None };
            session.platform.recall_file(&kept.id);
        }
        let file = session.in_place.file.as_ref().filter(|(origin, _)| *origin == kept.origin);
        let file = file.map(|(_, file)| file);
        // Until one is recalled, none is known, which is no reason to forget it.
        if self.file.as_ref() != file {
            session.platform.remember_file(&kept.id, file);
            self.file = file.cloned();
        }
    }
}
