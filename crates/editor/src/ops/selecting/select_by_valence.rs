//! `select-by-valence`: select vertices by the number of their edges.

use super::select_elements::MODE;
use crate::error::Problem;
use crate::ops::{
    Action, CompareCount, DefaultValue, Field, Operation, Scope, SelectEdit, SelectMode, Spec, Target,
};
use halfedge::{Element, NumberRange};
use serde::{Deserialize, Serialize};
use surface::selecting::{Criterion, Finding};

/// Select vertices by the number of their edges.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelectByValence {
    /// The number of edges.
    pub valence: u32,
    /// How the vertex's number compares with it.
    pub compare: CompareCount,
    /// How what is found changes the selection.
    pub mode: SelectMode,
}

impl Operation for SelectByValence {
    const SPEC: Spec = Spec::new(
        Scope::Selection,
        "select-by-valence",
        "Select by valence",
        "Select vertices by the number of their edges.",
    )
    .synonyms(&["poles", "irregular vertices", "extraordinary vertices"])
    .fields(&[
        Field::count("valence", NumberRange::counts(0, u32::MAX), "The number of edges")
            .or(DefaultValue::Integer(4)),
        CompareCount::field("compare", "How the vertex's number compares with it"),
        MODE,
    ]);

    fn action(&self) -> Action<'_> {
        Action::Select(self)
    }
}

impl SelectEdit for SelectByValence {
    fn find(&self, _: &Target<'_>) -> Result<Finding, Problem> {
        let criterion = Criterion::Count { is: self.compare.into(), than: self.valence as usize };
        Ok(Finding::by(Element::Vertex, criterion))
    }

    fn mode(&self) -> SelectMode {
        self.mode
    }
}
