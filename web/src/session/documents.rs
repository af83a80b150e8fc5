//! The documents that the browser keeps, as panels show them.

use meshwright_worker::store::{Id, Kept};

/// The documents that the browser keeps, as they were when they were last asked for.
#[derive(Default)]
pub(crate) struct DocumentList {
    /// The documents, the last changed first; none before the store has answered.
    pub documents: Option<Vec<Kept>>,
    /// A number that differs after each answer.
    pub version: u64,
    /// The document that the page shows.
    pub shown: Option<Id>,
    /// The document that was deleted last.
    pub deleted: Option<Id>,
}
