//! `delete-object`: delete an object.

use crate::error::Problem;
use crate::history::Change;
use crate::ops::{Action, DocumentEdit, Operation, Place, Scope, Spec};
use serde::{Deserialize, Serialize};

/// Delete the command's object, or the active one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct DeleteObject {}

impl Operation for DeleteObject {
    const SPEC: Spec = Spec::new(Scope::Document, "delete-object", "Delete object", "Delete an object.");

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for DeleteObject {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        let at = place.index()?;
        let left = place.document.objects.len().saturating_sub(1);
        if left == 0 {
            return Err(Problem::field("object", "a document keeps at least one object"));
        }
        // The active object stays active; where it is the deleted one, the next one becomes active.
        let active = place.document.active;
        let after = if active > at { active - 1 } else { active.min(left - 1) };
        Ok(vec![Change::Remove(at), Change::Active(after)])
    }
}
