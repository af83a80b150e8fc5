//! What a document holds, to compare.

use editor::formats::Model;
use editor::halfedge::geometry::BitSet;
use editor::{Editor, NamedSelection, Selection};
use std::sync::Arc;

/// What snapshots and projects keep of a document, but for the identities of objects: previews take some.
#[derive(Clone, Debug, PartialEq)]
pub struct Contents {
    pub model: Model,
    objects: Vec<(bool, Arc<BitSet>, Vec<NamedSelection>)>,
    active: usize,
    selection: Selection,
}

impl Contents {
    /// The contents of a document, under this name.
    pub fn named(editor: &Editor, name: &str) -> Self {
        let document = editor.document();
        let objects = document.objects().iter();
        Self {
            model: document.to_model(name),
            objects: objects
                .map(|o| (o.visible(), o.hidden().clone(), o.named_selections().to_vec()))
                .collect(),
            active: document.active_index(),
            selection: editor.selection().clone(),
        }
    }
}
