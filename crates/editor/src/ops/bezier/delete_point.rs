//! `bezier-delete-point`: delete a control point of a curve.

use super::control_points;
use crate::error::Problem;
use crate::history::Change;
use crate::ops::{Action, DocumentEdit, Field, INDEX_RANGE, Operation, Place, Scope, Spec};
use serde::{Deserialize, Serialize};

/// Delete a control point of a curve, which changes its shape.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BezierDeletePoint {
    /// Which one, from 0.
    pub index: u32,
}

impl Operation for BezierDeletePoint {
    const SPEC: Spec = Spec::new(
        Scope::Bezier,
        "bezier-delete-point",
        "Delete control point",
        "Delete a control point of a Bezier curve.",
    )
    .fields(&[Field::count("index", INDEX_RANGE, "Which control point")]);

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for BezierDeletePoint {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        let (object, curve) = control_points::curve(place)?;
        let at = control_points::check_point(self.index, curve, "index")?;
        if curve.points.len() == 1 {
            return Err(Problem::field(
                "index",
                "a curve keeps at least one control point; delete the object instead",
            ));
        }
        let mut curve = curve.clone();
        curve.points.remove(at);
        control_points::put_curve(object, curve)
    }
}
