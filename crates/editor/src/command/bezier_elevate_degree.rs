//! `bezier-elevate-degree`: the same curve with one control point more.

use super::{Action, DocumentEdit, Operation, OperationKind, Place, Spec, bezier};
use crate::error::Problem;
use crate::history::Change;
use serde::{Deserialize, Serialize};

/// Gives a curve one control point more without changing its shape (Farin 5.1).
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BezierElevateDegree {}

impl Operation for BezierElevateDegree {
    const SPEC: Spec = Spec {
        name: "bezier-elevate-degree",
        label: "Elevate degree",
        description: "Gives a Bezier curve one control point more without changing its shape.",
        key: None,
        kind: OperationKind::Bezier,
        fields: &[],
    };

    fields_by_serde!();

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for BezierElevateDegree {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        let (object, curve) = bezier::curve(place)?;
        bezier::put_curve(object, curve.elevated())
    }
}
