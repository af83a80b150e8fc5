//! `activate-object`: choose the object that lists, selection and commands are about.

use crate::error::Problem;
use crate::history::Change;
use crate::ops::{Action, DocumentEdit, Operation, Place, Scope, Spec};
use serde::{Deserialize, Serialize};

/// Make the command's object the active one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ActivateObject {}

impl Operation for ActivateObject {
    const SPEC: Spec = Spec::new(
        Scope::Document,
        "activate-object",
        "Activate object",
        "Make an object active: lists, selection and commands refer to it.",
    );

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for ActivateObject {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        let at = place
            .object
            .ok_or_else(|| Problem::of_field("object", "is missing; give the place of one in the list"))?;
        let at = place.check(at, "object")?;
        Ok(if at == place.document.active { Vec::new() } else { vec![Change::Active(at)] })
    }
}
