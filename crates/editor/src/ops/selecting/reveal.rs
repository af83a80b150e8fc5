//! `reveal`: show hidden faces again.

use crate::error::Problem;
use crate::history::Change;
use crate::ops::{Action, DocumentEdit, Operation, Place, Scope, Spec};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Show hidden faces again.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Reveal {}

impl Operation for Reveal {
    const SPEC: Spec = Spec::new(Scope::Selection, "reveal", "Reveal", "Show hidden faces again.")
        .synonyms(&["unhide", "show hidden", "show all"]);

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for Reveal {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        let object = place.object()?;
        if object.hidden().is_empty() {
            return Ok(Vec::new());
        }
        Ok(vec![Change::Hidden(object.id(), Arc::default())])
    }

    fn changes_nothing(&self, place: &Place<'_>) -> Option<&'static str> {
        place.object().is_ok_and(|object| object.hidden().is_empty()).then_some("Nothing is hidden.")
    }
}
