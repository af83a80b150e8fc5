//! `select-by-length`: select edges by length.

use super::select_elements::MODE;
use crate::error::Problem;
use crate::ops::{
    Action, CompareSize, Field, Operation, Scope, SelectEdit, SelectMode, Spec, Suggestion, Target, Unit,
};
use halfedge::{Element, NumberRange};
use serde::{Deserialize, Serialize};
use surface::selecting::{Criterion, Finding};

/// Select edges by length.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelectByLength {
    /// How the length compares.
    pub compare: CompareSize,
    /// With what, in mesh units.
    #[serde(with = "crate::script::json::finite")]
    pub length: f32,
    /// How what is found changes the selection.
    pub mode: SelectMode,
}

impl Operation for SelectByLength {
    const SPEC: Spec = Spec::new(
        Scope::Selection,
        "select-by-length",
        "Select by length",
        "Select edges that are smaller or larger than a length.",
    )
    .synonyms(&["short edges", "long edges"])
    .fields(&[
        CompareSize::field("compare", "How the length compares"),
        Field::number("length", Unit::Length, NumberRange::NOT_NEGATIVE, "With what")
            .suggest(Suggestion::MeanEdge),
        MODE,
    ]);

    fn action(&self) -> Action<'_> {
        Action::Select(self)
    }
}

impl SelectEdit for SelectByLength {
    fn find(&self, _: &Target<'_>) -> Result<Finding, Problem> {
        let criterion = Criterion::Size { is: self.compare.into(), than: self.length.into() };
        Ok(Finding::by(Element::Edge, criterion))
    }

    fn mode(&self) -> SelectMode {
        self.mode
    }
}
