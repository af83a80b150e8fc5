//! `select-named`: select the elements of a named selection.

use super::naming::find;
use super::select_elements::MODE;
use crate::error::Problem;
use crate::ops::{Action, Field, FieldKind, Operation, Scope, SelectEdit, SelectMode, Spec, Target};
use serde::{Deserialize, Serialize};
use surface::selecting::Finding;

/// Select the elements of a named selection.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelectNamed {
    /// The name.
    pub name: String,
    /// How they change the selection.
    pub mode: SelectMode,
}

impl Operation for SelectNamed {
    const SPEC: Spec = Spec::new(
        Scope::Selection,
        "select-named",
        "Select named selection",
        "Select the elements of a named selection.",
    )
    .fields(&[Field::required("name", FieldKind::Text, "The name"), MODE]);

    fn action(&self) -> Action<'_> {
        Action::Select(self)
    }
}

impl SelectEdit for SelectNamed {
    fn find(&self, target: &Target<'_>) -> Result<Finding, Problem> {
        let Some(object) = target.object else { return Err(Problem::new("the document has no object")) };
        let named = object.named_selections();
        let Some(named) = named.get(find(object, &self.name)?) else {
            return Err(Problem::internal("a name that is listed is gone"));
        };
        Ok(Finding::known(named.selection.kind(), named.selection.set().clone()))
    }

    fn mode(&self) -> SelectMode {
        self.mode
    }
}
