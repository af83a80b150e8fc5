//! `rename-object`: give an object another name.

use crate::error::Problem;
use crate::history::Change;
use crate::ops::{Action, DocumentEdit, Field, FieldKind, Operation, Place, Scope, Spec};
use serde::{Deserialize, Serialize};

/// Give an object another name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RenameObject {
    /// The new name.
    pub name: String,
}

impl Operation for RenameObject {
    const SPEC: Spec =
        Spec::new(Scope::Document, "rename-object", "Rename object", "Give an object another name.")
            .fields(&[Field::required("name", FieldKind::Text, "The new name")]);

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for RenameObject {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        let object = place.object()?;
        let name = self.name.trim();
        // Files name objects on a line of their own.
        if name.is_empty() || name.chars().any(char::is_control) {
            return Err(Problem::field(
                "name",
                "a name needs at least one character, and no control characters",
            ));
        }
        let renamed = (name != object.name()).then(|| Change::Name(object.id(), name.to_owned()));
        Ok(renamed.into_iter().collect())
    }
}
