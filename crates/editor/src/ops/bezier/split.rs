//! `bezier-split`: split a curve into two.

use super::control_points;
use crate::bezier::Bezier;
use crate::document::Object;
use crate::error::Problem;
use crate::history::Change;
use crate::ops::{Action, DefaultValue, DocumentEdit, Field, NamedMesh, Operation, Place, Scope, Spec, Unit};
use halfedge::words::thousands;
use halfedge::{Mesh, NumberRange};
use serde::{Deserialize, Serialize};
use std::sync::Arc;

/// Split a curve into two of the same degree, which together have its shape: the object keeps the
/// part up to `t`, the rest becomes an object after it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BezierSplit {
    /// Where: above 0 and below 1.
    #[serde(with = "crate::script::json::finite")]
    pub t: f32,
}

/// Curves with more control points are not split: the work grows with the square of their number.
const MAX_SPLIT_POINTS: usize = 20_000;

impl Operation for BezierSplit {
    const SPEC: Spec = Spec::new(
        Scope::Bezier,
        "bezier-split",
        "Split curve",
        "Split a Bezier curve into two of the same degree.",
    )
    .fields(&[Field::number(
        "t",
        Unit::Fraction,
        NumberRange::between(0.0, 1.0),
        "The parameter at which to split",
    )
    .labelled("Position (0 to 1)")
    .or(DefaultValue::Number(0.5))]);

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for BezierSplit {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        let (object, curve) = control_points::curve(place)?;
        let count = curve.points.len();
        if count > MAX_SPLIT_POINTS {
            return Err(Problem::new(format!(
                "the curve has {} control points; splitting takes too long for more than {}",
                thousands(count),
                thousands(MAX_SPLIT_POINTS)
            )));
        }
        let at = place.index()?;
        let (first, rest) = curve.split(self.t);
        let name = format!("{} 2", object.name());
        let bezier = Some(Arc::new(Bezier::Curve(rest)));
        let made = Object::new(place.next_object, NamedMesh { bezier, ..NamedMesh::new(name, Mesh::new()) });
        let mut changes = control_points::put_curve(object, first)?;
        changes.push(Change::Insert(at + 1, Box::new(made)));
        if place.document.active > at {
            changes.push(Change::Active(place.document.active + 1));
        }
        Ok(changes)
    }
}
