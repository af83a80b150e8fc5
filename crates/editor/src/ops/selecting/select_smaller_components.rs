//! `select-smaller-components`: select all pieces but the largest.

use super::select_elements::MODE;
use crate::error::Problem;
use crate::ops::{Action, Kind, Operation, Scope, SelectEdit, SelectMode, Spec, Target};
use serde::{Deserialize, Serialize};
use surface::selecting::Finding;

/// Select what belongs to any connected component but the one with the most faces.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelectSmallerComponents {
    /// The kind of elements; that of the selection when left out.
    pub kind: Option<Kind>,
    /// How what is found changes the selection.
    pub mode: SelectMode,
}

impl Operation for SelectSmallerComponents {
    const SPEC: Spec = Spec::new(
        Scope::Selection,
        "select-smaller-components",
        "Select all but the largest component",
        "Select what belongs to any connected component but the one with the most faces.",
    )
    .synonyms(&["small pieces", "loose parts", "debris", "floaters", "islands"])
    .fields(&[Kind::FIELD, MODE]);

    fn action(&self) -> Action<'_> {
        Action::Select(self)
    }
}

impl SelectEdit for SelectSmallerComponents {
    fn find(&self, target: &Target<'_>) -> Result<Finding, Problem> {
        Ok(Finding::smaller_components(target.kind(self.kind)))
    }

    fn mode(&self) -> SelectMode {
        self.mode
    }
}
