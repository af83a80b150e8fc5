//! `rename-named-selection`: give a named selection another name.

use super::naming::{change, find, name_of};
use crate::error::Problem;
use crate::history::Change;
use crate::ops::{Action, DocumentEdit, Field, FieldKind, Operation, Place, Scope, Spec};
use serde::{Deserialize, Serialize};

/// Rename a named selection.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RenameNamedSelection {
    /// The name.
    pub name: String,
    /// The new name.
    pub to: String,
}

impl Operation for RenameNamedSelection {
    const SPEC: Spec = Spec::new(
        Scope::Selection,
        "rename-named-selection",
        "Rename named selection",
        "Rename a named selection.",
    )
    .fields(&[
        Field::required("name", FieldKind::Text, "The name"),
        Field::required("to", FieldKind::Text, "The new name").labelled("New name"),
    ]);

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for RenameNamedSelection {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        let object = place.object()?;
        let (at, to) = (find(object, &self.name)?, name_of(&self.to, "to")?);
        let mut named = object.named_selections().to_vec();
        if named.iter().enumerate().any(|(other, old)| other != at && old.name == to) {
            return Err(Problem::field("to", format!("another selection is called “{to}”")));
        }
        if let Some(renamed) = named.get_mut(at) {
            renamed.name = to;
        }
        Ok(change(object, named))
    }
}
