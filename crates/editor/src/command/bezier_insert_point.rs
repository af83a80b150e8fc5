//! `bezier-insert-point`: adds a control point to a curve.

use super::{Action, DocumentEdit, Field, FieldKind, Operation, OperationKind, Place, Spec, bezier};
use crate::error::Problem;
use crate::history::Change;
use serde::{Deserialize, Serialize};

/// Adds a control point to a curve, which changes its shape.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BezierInsertPoint {
    /// The index that it gets, from 0; after the last one if left out.
    #[serde(default, skip_serializing_if = "Option::is_none", with = "crate::json::whole_option")]
    pub index: Option<u32>,
    /// Where it is.
    #[serde(with = "crate::json::finite3")]
    pub position: [f32; 3],
}

impl Operation for BezierInsertPoint {
    const SPEC: Spec = Spec {
        name: "bezier-insert-point",
        label: "Add control point",
        description: "Adds a control point to a Bezier curve.",
        key: None,
        kind: OperationKind::Bezier,
        fields: &[
            Field::new("index", FieldKind::Integer { min: 0, max: u32::MAX }, "The index that it gets")
                .or("after the last"),
            Field::new("position", FieldKind::Vector, "Where it is"),
        ],
    };

    fields_by_serde!();

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for BezierInsertPoint {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        let (object, curve) = bezier::curve(place)?;
        let count = curve.points.len();
        let at = self.index.map_or(count, |index| index as usize);
        if at > count {
            return Err(Problem::field("index", format!("{at} would leave a gap; it may be 0 to {count}")));
        }
        let mut curve = curve.clone();
        curve.points.insert(at, self.position.into());
        bezier::put_curve(object, curve)
    }
}
