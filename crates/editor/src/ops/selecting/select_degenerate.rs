//! `select-degenerate`: select faces or edges of no size.

use super::select_elements::MODE;
use crate::error::Problem;
use crate::ops::{
    Action, DefaultValue, Field, Kind, Operation, Scope, SelectEdit, SelectMode, Spec, Target, Unit,
};
use halfedge::{Element, NumberRange};
use serde::{Deserialize, Serialize};
use surface::selecting::{Criterion, Finding};

/// Select faces without area, or edges without length.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelectDegenerate {
    /// Faces or edges; faces when left out, unless edges are selected.
    pub kind: Option<Kind>,
    /// The area or length that still counts as none.
    #[serde(with = "crate::script::json::finite")]
    pub at_most: f32,
    /// How what is found changes the selection.
    pub mode: SelectMode,
}

impl Operation for SelectDegenerate {
    const SPEC: Spec = Spec::new(
        Scope::Selection,
        "select-degenerate",
        "Select degenerate elements",
        "Select faces without area, or edges without length.",
    )
    .synonyms(&["zero area", "zero length", "slivers"])
    .fields(&[
        Kind::FIELD,
        Field::number(
            "at_most",
            Unit::Length,
            NumberRange::NOT_NEGATIVE,
            "The area or length that still counts as none",
        )
        .or(DefaultValue::Number(0.0)),
        MODE,
    ]);

    fn action(&self) -> Action<'_> {
        Action::Select(self)
    }
}

impl SelectEdit for SelectDegenerate {
    fn find(&self, target: &Target<'_>) -> Result<Finding, Problem> {
        let kind = match target.kind(self.kind) {
            Element::Vertex => Element::Face,
            kind => kind,
        };
        Ok(Finding::by(kind, Criterion::Degenerate { at_most: self.at_most.into() }))
    }

    fn mode(&self) -> SelectMode {
        self.mode
    }
}
