//! `select-isolated`: select vertices in no face.

use super::select_elements::MODE;
use crate::error::Problem;
use crate::ops::{Action, Operation, Scope, SelectEdit, SelectMode, Spec, Target};
use halfedge::Element;
use serde::{Deserialize, Serialize};
use surface::selecting::{Criterion, Finding};

/// Select vertices in no face.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelectIsolated {
    /// How what is found changes the selection.
    pub mode: SelectMode,
}

impl Operation for SelectIsolated {
    const SPEC: Spec = Spec::new(
        Scope::Selection,
        "select-isolated",
        "Select isolated vertices",
        "Select vertices in no face.",
    )
    .synonyms(&["loose", "non-manifold"])
    .fields(&[MODE]);

    fn action(&self) -> Action<'_> {
        Action::Select(self)
    }
}

impl SelectEdit for SelectIsolated {
    fn find(&self, _: &Target<'_>) -> Result<Finding, Problem> {
        Ok(Finding::by(Element::Vertex, Criterion::Isolated))
    }

    fn mode(&self) -> SelectMode {
        self.mode
    }
}
