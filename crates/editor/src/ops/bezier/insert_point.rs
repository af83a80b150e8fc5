//! `bezier-insert-point`: add a control point to a curve.

use super::control_points;
use crate::error::Problem;
use crate::history::Change;
use crate::ops::{Action, DocumentEdit, Field, FieldKind, INDEX_RANGE, Operation, Place, Scope, Spec};
use serde::{Deserialize, Serialize};

/// Add a control point to a curve, which changes its shape.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BezierInsertPoint {
    /// The index that it gets, from 0; after the last one when left out.
    pub index: Option<u32>,
    /// Where it is.
    #[serde(with = "crate::script::json::finite3")]
    pub position: [f32; 3],
}

impl Operation for BezierInsertPoint {
    const SPEC: Spec = Spec::new(
        Scope::Bezier,
        "bezier-insert-point",
        "Add control point",
        "Add a control point to a Bezier curve.",
    )
    .fields(&[
        Field::count("index", INDEX_RANGE, "The index that it gets").unset("after the last"),
        Field::required("position", FieldKind::Vector, "The position of the point"),
    ]);

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for BezierInsertPoint {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        let (object, curve) = control_points::curve(place)?;
        let count = curve.points.len();
        let at = self.index.map_or(count, |index| index as usize);
        if at > count {
            return Err(Problem::field("index", format!("{at} would leave a gap; it may be 0 to {count}")));
        }
        let mut curve = curve.clone();
        curve.points.insert(at, self.position.into());
        control_points::put_curve(object, curve)
    }
}
