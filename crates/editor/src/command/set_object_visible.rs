//! `set-object-visible`: shows or hides an object.

use super::{Action, DocumentEdit, Field, FieldKind, Operation, OperationKind, Place, Spec};
use crate::error::Problem;
use crate::history::Change;
use serde::{Deserialize, Serialize};

/// Shows or hides an object.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SetObjectVisible {
    /// Whether the viewport draws it.
    pub visible: bool,
}

impl Operation for SetObjectVisible {
    const SPEC: Spec = Spec {
        name: "set-object-visible",
        label: "Show or hide object",
        description: "Shows an object in the viewport or hides it.",
        key: None,
        kind: OperationKind::Document,
        fields: &[Field::new("visible", FieldKind::Flag, "Whether it is shown")],
    };

    fields_by_serde!();

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for SetObjectVisible {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        let object = place.object()?;
        Ok(if object.visible() == self.visible {
            Vec::new()
        } else {
            vec![Change::Visible(object.id(), self.visible)]
        })
    }
}
