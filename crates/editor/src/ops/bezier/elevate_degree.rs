//! `bezier-elevate-degree`: add a control point without changing the shape.

use super::control_points;
use crate::error::Problem;
use crate::history::Change;
use crate::ops::{Action, DocumentEdit, Operation, Place, Scope, Spec};
use serde::{Deserialize, Serialize};

/// Add a control point to a curve without changing its shape (Farin 5.1).
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct BezierElevateDegree {}

impl Operation for BezierElevateDegree {
    const SPEC: Spec = Spec::new(
        Scope::Bezier,
        "bezier-elevate-degree",
        "Elevate degree",
        "Add a control point to a Bezier curve without changing its shape.",
    );

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for BezierElevateDegree {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        let (object, curve) = control_points::curve(place)?;
        control_points::put_curve(object, curve.elevated())
    }
}
