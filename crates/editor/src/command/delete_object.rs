//! `delete-object`: takes an object out of the document.

use super::{Action, DocumentEdit, Operation, OperationKind, Place, Spec};
use crate::error::Problem;
use crate::history::Change;
use serde::{Deserialize, Serialize};

/// Takes the command's object, or the active one, out of the document.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DeleteObject {}

impl Operation for DeleteObject {
    const SPEC: Spec = Spec {
        name: "delete-object",
        label: "Delete object",
        description: "Takes an object out of the document.",
        key: None,
        kind: OperationKind::Document,
        fields: &[],
    };

    fields_by_serde!();

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
        // The active object stays active; where it is the one that goes, the next one takes over.
        let active = place.document.active;
        let after = if active > at { active - 1 } else { active.min(left - 1) };
        Ok(vec![Change::Remove(at), Change::Active(after)])
    }
}
