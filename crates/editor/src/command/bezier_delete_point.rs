//! `bezier-delete-point`: takes a control point out of a curve.

use super::{Action, DocumentEdit, Field, FieldKind, Operation, OperationKind, Place, Spec, bezier};
use crate::error::Problem;
use crate::history::Change;
use serde::{Deserialize, Serialize};

/// Takes a control point out of a curve, which changes its shape.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BezierDeletePoint {
    /// Which one, from 0.
    #[serde(with = "crate::json::whole")]
    pub index: u32,
}

impl Operation for BezierDeletePoint {
    const SPEC: Spec = Spec {
        name: "bezier-delete-point",
        label: "Delete control point",
        description: "Takes a control point out of a Bezier curve.",
        key: None,
        kind: OperationKind::Bezier,
        fields: &[Field::new("index", FieldKind::Integer { min: 0, max: u32::MAX }, "Which control point")],
    };

    fields_by_serde!();

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for BezierDeletePoint {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        let (object, curve) = bezier::curve(place)?;
        let at = bezier::check_point(self.index, curve, "index")?;
        if curve.points.len() == 1 {
            return Err(Problem::field(
                "index",
                "a curve keeps at least one control point; delete the object instead",
            ));
        }
        let mut curve = curve.clone();
        curve.points.remove(at);
        bezier::put_curve(object, curve)
    }
}
