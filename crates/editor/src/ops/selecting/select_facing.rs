//! `select-facing`: select faces by the side that they face.

use super::select_elements::MODE;
use crate::error::Problem;
use crate::ops::{
    ANGLE_RANGE, Action, DefaultValue, Field, FieldKind, Operation, Scope, SelectEdit, SelectMode, Spec,
    Target, Unit,
};
use glam::Vec3;
use halfedge::geometry::face_area_vector;
use halfedge::{Element, FaceId};
use serde::{Deserialize, Serialize};
use surface::selecting::{Criterion, Finding};

/// Select faces whose normal is within an angle of a direction.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SelectFacing {
    /// The direction, of any length but 0; the normal of the face selected last when left out.
    #[serde(default, with = "crate::script::json::finite3_option")]
    pub direction: Option<[f32; 3]>,
    /// The largest angle between it and the normal, in degrees.
    #[serde(with = "crate::script::json::finite")]
    pub angle: f32,
    /// How what is found changes the selection.
    pub mode: SelectMode,
}

/// The suggested angle in degrees: faces that look more or less the same way.
pub const FACING_ANGLE_DEGREES: f32 = 30.0;

impl Operation for SelectFacing {
    const SPEC: Spec = Spec::new(
        Scope::Selection,
        "select-facing",
        "Select facing the same way",
        "Select faces that face the same way as the one selected last, or a direction.",
    )
    .synonyms(&["coplanar", "side", "similar normal"])
    .fields(&[
        Field::required("direction", FieldKind::Vector, "The direction")
            .optional("the normal of the face selected last"),
        Field::number(
            "angle",
            Unit::Degrees,
            ANGLE_RANGE,
            "The largest angle between it and a face's normal",
        )
        .or(DefaultValue::Number(FACING_ANGLE_DEGREES as f64)),
        MODE,
    ]);

    fn action(&self) -> Action<'_> {
        Action::Select(self)
    }
}

impl SelectEdit for SelectFacing {
    fn find(&self, target: &Target<'_>) -> Result<Finding, Problem> {
        let direction = match self.direction {
            Some(direction) => Vec3::from_array(direction).as_dvec3(),
            None => face_area_vector(target.mesh, FaceId::new(target.latest(Element::Face)? as usize)),
        };
        if direction.try_normalize().is_none() {
            return Err(match self.direction {
                Some(_) => Problem::of_field("direction", "has no length, so it points nowhere"),
                None => Problem::new("the face selected last has no area, so it faces no side"),
            });
        }
        let criterion = Criterion::Facing { direction, degrees: self.angle.into() };
        Ok(Finding::by(Element::Face, criterion))
    }

    fn mode(&self) -> SelectMode {
        self.mode
    }
}
