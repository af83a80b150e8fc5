//! `select-sharp-edges`: select edges at which faces meet at an angle.

use super::select_elements::MODE;
use crate::error::Problem;
use crate::ops::{
    ANGLE_RANGE, Action, DefaultValue, Field, Operation, Scope, SelectEdit, SelectMode, Spec, Target, Unit,
};
use halfedge::Element;
use serde::{Deserialize, Serialize};
use surface::selecting::{Criterion, Finding};

/// Select edges whose two faces meet at more than an angle.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelectSharpEdges {
    /// The angle in degrees.
    #[serde(with = "crate::script::json::finite")]
    pub angle: f32,
    /// How what is found changes the selection.
    pub mode: SelectMode,
}

impl Operation for SelectSharpEdges {
    const SPEC: Spec = Spec::new(
        Scope::Selection,
        "select-sharp-edges",
        "Select sharp edges",
        "Select edges whose two faces meet at more than an angle.",
    )
    .synonyms(&["hard edges", "creases", "dihedral angle"])
    .fields(&[
        Field::number("angle", Unit::Degrees, ANGLE_RANGE, "The angle: 0 is flat, 90 an edge of a cube")
            .or(DefaultValue::Number(30.0)),
        MODE,
    ]);

    fn action(&self) -> Action<'_> {
        Action::Select(self)
    }
}

impl SelectEdit for SelectSharpEdges {
    fn find(&self, _: &Target<'_>) -> Result<Finding, Problem> {
        Ok(Finding::by(Element::Edge, Criterion::Sharp { degrees: self.angle.into() }))
    }

    fn mode(&self) -> SelectMode {
        self.mode
    }
}
