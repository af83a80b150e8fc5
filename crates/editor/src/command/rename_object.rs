//! `rename-object`: gives an object another name.

use super::{Action, DocumentEdit, Field, FieldKind, Operation, OperationKind, Place, Spec};
use crate::error::Problem;
use crate::history::Change;
use serde::{Deserialize, Serialize};

/// Gives an object another name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RenameObject {
    /// The new name.
    pub name: String,
}

impl Operation for RenameObject {
    const SPEC: Spec = Spec {
        name: "rename-object",
        label: "Rename object",
        description: "Gives an object another name.",
        key: None,
        kind: OperationKind::Document,
        fields: &[Field::new("name", FieldKind::Text, "The new name")],
    };

    fields_by_serde!();

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
            return Err(Problem::field("name", "a name has at least one character, and none of control"));
        }
        let renamed = (name != object.name()).then(|| Change::Name(object.id(), name.to_owned()));
        Ok(renamed.into_iter().collect())
    }
}
