//! `delete-named-selection`: delete a named selection; its elements stay.

use super::naming::{change, find};
use crate::error::Problem;
use crate::history::Change;
use crate::ops::{Action, DocumentEdit, Field, FieldKind, Operation, Place, Scope, Spec};
use serde::{Deserialize, Serialize};

/// Delete a named selection; its elements stay.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct DeleteNamedSelection {
    /// The name.
    pub name: String,
}

impl Operation for DeleteNamedSelection {
    const SPEC: Spec = Spec::new(
        Scope::Selection,
        "delete-named-selection",
        "Delete named selection",
        "Delete a named selection; its elements stay.",
    )
    .fields(&[Field::required("name", FieldKind::Text, "The name")]);

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for DeleteNamedSelection {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        let object = place.object()?;
        let at = find(object, &self.name)?;
        let mut named = object.named_selections().to_vec();
        named.remove(at);
        Ok(change(object, named))
    }
}
