//! `select-by-area`: select faces by area.

use super::select_elements::MODE;
use crate::error::Problem;
use crate::ops::choice::choice;
use crate::ops::{Action, Field, Operation, Scope, SelectEdit, SelectMode, Spec, Target, Unit};
use halfedge::{Element, NumberRange};
use serde::{Deserialize, Serialize};
use surface::selecting::{Comparison, Criterion, Finding};

/// Select faces by area.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelectByArea {
    /// How the area compares.
    pub compare: CompareSize,
    /// With what, in square mesh units.
    #[serde(with = "crate::script::json::finite")]
    pub area: f32,
    /// How what is found changes the selection.
    pub mode: SelectMode,
}

choice! {
    /// How a size compares with another.
    pub enum CompareSize {
        /// Smaller.
        Less = "less" "Less than",
        /// Larger.
        More = "more" "More than",
    }
}

impl From<CompareSize> for Comparison {
    fn from(compare: CompareSize) -> Self {
        match compare {
            CompareSize::Less => Self::Less,
            CompareSize::More => Self::More,
        }
    }
}

impl Operation for SelectByArea {
    const SPEC: Spec = Spec::new(
        Scope::Selection,
        "select-by-area",
        "Select by area",
        "Select faces that are smaller or larger than an area.",
    )
    .synonyms(&["small faces", "large faces"])
    .fields(&[
        CompareSize::field("compare", "How the area compares"),
        Field::number("area", Unit::Area, NumberRange::NOT_NEGATIVE, "With what"),
        MODE,
    ]);

    fn action(&self) -> Action<'_> {
        Action::Select(self)
    }
}

impl SelectEdit for SelectByArea {
    fn find(&self, _: &Target<'_>) -> Result<Finding, Problem> {
        let criterion = Criterion::Size { is: self.compare.into(), than: self.area.into() };
        Ok(Finding::by(Element::Face, criterion))
    }

    fn mode(&self) -> SelectMode {
        self.mode
    }
}
