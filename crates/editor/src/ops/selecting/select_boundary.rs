//! `select-boundary`: select elements on the boundary.

use super::select_elements::MODE;
use crate::error::Problem;
use crate::ops::{Action, Kind, Operation, Scope, SelectEdit, SelectMode, Spec, Target};
use serde::{Deserialize, Serialize};
use surface::selecting::{Criterion, Finding};

/// Select boundary edges and half-edges, the vertices on them, or the faces beside them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelectBoundary {
    /// The kind of elements; that of the selection when left out.
    pub kind: Option<Kind>,
    /// How what is found changes the selection.
    pub mode: SelectMode,
}

impl Operation for SelectBoundary {
    const SPEC: Spec = Spec::new(
        Scope::Selection,
        "select-boundary",
        "Select boundary",
        "Select boundary edges and half-edges, the vertices on them, or the faces beside them.",
    )
    .synonyms(&["non-manifold", "open edges", "holes", "border"])
    .fields(&[Kind::FIELD, MODE]);

    fn action(&self) -> Action<'_> {
        Action::Select(self)
    }
}

impl SelectEdit for SelectBoundary {
    fn find(&self, target: &Target<'_>) -> Result<Finding, Problem> {
        Ok(Finding::by(target.kind(self.kind), Criterion::Boundary))
    }

    fn mode(&self) -> SelectMode {
        self.mode
    }
}
