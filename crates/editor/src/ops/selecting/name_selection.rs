//! `name-selection`: save the selection under a name, and replace any of that name.

use super::naming::{change, name_of};
use crate::document::NamedSelection;
use crate::error::Problem;
use crate::history::Change;
use crate::ops::{Action, DocumentEdit, Field, FieldKind, Operation, Place, Scope, Spec};
use serde::{Deserialize, Serialize};

/// Save the selection under a name, and replace any of that name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct NameSelection {
    /// The name.
    pub name: String,
}

impl Operation for NameSelection {
    const SPEC: Spec = Spec::new(
        Scope::Selection,
        "name-selection",
        "Name selection",
        "Save the selection under a name, and replace any of that name.",
    )
    .synonyms(&["vertex group", "selection set", "save selection"])
    .fields(&[Field::required("name", FieldKind::Text, "The name")]);

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for NameSelection {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        let object = place.object()?;
        let name = name_of(&self.name, "name")?;
        let selection = place.selection().filter(|selection| !selection.is_empty());
        let Some(selection) = selection.cloned() else {
            return Err(Problem::new("nothing is selected").advise("Select something first."));
        };
        let mut named = object.named_selections().to_vec();
        let new = NamedSelection { name, selection };
        match named.iter_mut().find(|old| old.name == new.name) {
            Some(old) => *old = new,
            None => named.push(new),
        }
        Ok(change(object, named))
    }
}
