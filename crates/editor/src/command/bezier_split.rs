//! `bezier-split`: one curve as two.

use super::{Action, DocumentEdit, Field, FieldKind, Operation, OperationKind, Place, Spec, bezier};
use crate::bezier::Bezier;
use crate::document::Object;
use crate::error::Problem;
use crate::history::Change;
use halfedge::Mesh;
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Splits a curve into two of the same degree, which together have its shape: the object keeps the
/// part up to `t`, the rest becomes an object after it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BezierSplit {
    /// Where: above 0 and below 1.
    #[serde(default = "half", with = "crate::json::finite")]
    pub t: f32,
}

/// A curve of more control points is not split: the work grows with the square of their number, and
/// would hold everything up.
const MOST_POINTS: usize = 20_000;

fn half() -> f32 {
    0.5
}

impl Operation for BezierSplit {
    const SPEC: Spec = Spec {
        name: "bezier-split",
        label: "Split curve",
        description: "Splits a Bezier curve into two of the same degree.",
        key: None,
        kind: OperationKind::Bezier,
        fields: &[
            Field::new("t", FieldKind::Number { min: 0.0, max: 1.0 }, "Where along the curve").or("0.5")
        ],
    };

    fields_by_serde!();

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for BezierSplit {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        let (object, curve) = bezier::curve(place)?;
        if self.t <= 0.0 || self.t >= 1.0 {
            return Err(Problem::field(
                "t",
                format!("{} is out of range; it must be above 0 and below 1", self.t),
            ));
        }
        let count = curve.points.len();
        if count > MOST_POINTS {
            return Err(Problem::new(format!(
                "the curve has {count} control points; splitting takes too long for more than {MOST_POINTS}"
            )));
        }
        let at = place.index()?;
        let (first, rest) = curve.split(self.t);
        let name = format!("{} 2", object.name());
        let mut made = Object::new(place.next_object, name, Arc::new(Mesh::new()));
        made.bezier = Some(Arc::new(Bezier::Curve(rest)));
        let mut changes = bezier::put_curve(object, first)?;
        changes.push(Change::Insert(at + 1, Box::new(made)));
        if place.document.active > at {
            changes.push(Change::Active(place.document.active + 1));
        }
        Ok(changes)
    }
}
