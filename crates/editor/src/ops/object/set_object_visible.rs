//! `set-object-visible`: show or hide an object.

use crate::error::Problem;
use crate::history::Change;
use crate::ops::{Action, DocumentEdit, Field, FieldKind, Operation, Place, Scope, Spec};
use serde::{Deserialize, Serialize};

/// Show or hide an object.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetObjectVisible {
    /// Whether the viewport draws it.
    pub visible: bool,
}

impl Operation for SetObjectVisible {
    const SPEC: Spec = Spec::new(
        Scope::Document,
        "set-object-visible",
        "Show or hide object",
        "Show an object in the viewport or hide it.",
    )
    .fields(&[Field::required("visible", FieldKind::Flag, "Whether it is shown")]);

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
