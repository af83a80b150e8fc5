//! `select-non-planar`: select polygons that are not flat.

use super::select_elements::MODE;
use crate::error::Problem;
use crate::ops::{
    ANGLE_RANGE, Action, DefaultValue, Field, Operation, Scope, SelectEdit, SelectMode, Spec, Target, Unit,
};
use halfedge::Element;
use serde::{Deserialize, Serialize};
use surface::selecting::{Criterion, Finding};

/// Select polygons with a triangle that is turned by more than an angle against the mean plane.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelectNonPlanar {
    /// The angle in degrees.
    #[serde(with = "crate::script::json::finite")]
    pub angle: f32,
    /// How what is found changes the selection.
    pub mode: SelectMode,
}

impl Operation for SelectNonPlanar {
    const SPEC: Spec = Spec::new(
        Scope::Selection,
        "select-non-planar",
        "Select non-planar faces",
        "Select polygons with a triangle that is turned by more than an angle against the mean plane.",
    )
    .synonyms(&["warped", "bent", "not flat"])
    .fields(&[
        Field::number("angle", Unit::Degrees, ANGLE_RANGE, "The angle that still counts as flat")
            .or(DefaultValue::Number(1.0)),
        MODE,
    ]);

    fn action(&self) -> Action<'_> {
        Action::Select(self)
    }
}

impl SelectEdit for SelectNonPlanar {
    fn find(&self, _: &Target<'_>) -> Result<Finding, Problem> {
        Ok(Finding::by(Element::Face, Criterion::NonPlanar { degrees: self.angle.into() }))
    }

    fn mode(&self) -> SelectMode {
        self.mode
    }
}
