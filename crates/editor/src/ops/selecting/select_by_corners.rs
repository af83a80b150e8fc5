//! `select-by-corners`: select faces by the number of their corners.

use super::select_elements::MODE;
use crate::error::Problem;
use crate::ops::choice::choice;
use crate::ops::{Action, DefaultValue, Field, Operation, Scope, SelectEdit, SelectMode, Spec, Target};
use halfedge::{Element, NumberRange};
use serde::{Deserialize, Serialize};
use surface::selecting::{Comparison, Criterion, Finding};

/// Select faces by the number of their corners.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelectByCorners {
    /// The number of corners.
    pub corners: u32,
    /// How the face's number compares with it.
    pub compare: CompareCount,
    /// How what is found changes the selection.
    pub mode: SelectMode,
}

choice! {
    /// How a count compares with another.
    pub enum CompareCount {
        /// The same.
        Equal = "equal" "Exactly",
        /// Another one.
        Different = "different" "Any other",
        /// Fewer.
        Less = "less" "Fewer than",
        /// More.
        More = "more" "More than",
    }
}

impl From<CompareCount> for Comparison {
    fn from(compare: CompareCount) -> Self {
        match compare {
            CompareCount::Equal => Self::Equal,
            CompareCount::Different => Self::Different,
            CompareCount::Less => Self::Less,
            CompareCount::More => Self::More,
        }
    }
}

impl Operation for SelectByCorners {
    const SPEC: Spec = Spec::new(
        Scope::Selection,
        "select-by-corners",
        "Select by corners",
        "Select faces by the number of their corners.",
    )
    .synonyms(&["triangles", "quads", "n-gons", "faces by sides"])
    .fields(&[
        Field::count("corners", NumberRange::counts(3, u32::MAX), "The number of corners")
            .or(DefaultValue::Integer(4)),
        CompareCount::field("compare", "How the face's number compares with it"),
        MODE,
    ]);

    fn action(&self) -> Action<'_> {
        Action::Select(self)
    }
}

impl SelectEdit for SelectByCorners {
    fn find(&self, _: &Target<'_>) -> Result<Finding, Problem> {
        let criterion = Criterion::Count { is: self.compare.into(), than: self.corners as usize };
        Ok(Finding::by(Element::Face, criterion))
    }

    fn mode(&self) -> SelectMode {
        self.mode
    }
}
