//! `bezier-move-point`: move a control point.

use super::control_points;
use crate::bezier::Bezier;
use crate::error::Problem;
use crate::history::Change;
use crate::ops::refs::given;
use crate::ops::{Action, DocumentEdit, Field, FieldKind, INDEX_RANGE, Operation, Place, Scope, Spec};
use serde::{Deserialize, Serialize};
use surface::bezier::{Curve, Patch, weld_distance};

/// Move a control point of a curve or a patch. Points of patches at the same position, as on a shared
/// border, move together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BezierMovePoint {
    /// For a curve: which control point, from 0.
    pub point: Option<u32>,
    /// For a surface: which patch, from 0.
    pub patch: Option<u32>,
    /// For a surface: which of the patch's rows, 0 to 3.
    pub row: Option<u32>,
    /// For a surface: which point of the row, 0 to 3.
    pub column: Option<u32>,
    /// The new position.
    #[serde(with = "crate::script::json::finite3")]
    pub position: [f32; 3],
}

impl Operation for BezierMovePoint {
    const SPEC: Spec = Spec::new(
        Scope::Bezier,
        "bezier-move-point",
        "Move control point",
        "Move a control point of a curve or surface; points of patches at the same position move together.",
    )
    .fields(&[
        Field::count("point", INDEX_RANGE, "Which control point of a curve").optional("none, for a surface"),
        Field::count("patch", INDEX_RANGE, "Which patch of a surface").optional("none, for a curve"),
        Field::count("row", INDEX_RANGE, "Which row of the patch, 0 to 3").optional("none, for a curve"),
        Field::count("column", INDEX_RANGE, "Which point of the row, 0 to 3").optional("none, for a curve"),
        Field::required("position", FieldKind::Vector, "The new position"),
    ]);

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for BezierMovePoint {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        match control_points::object(place)? {
            (object, Bezier::Curve(curve)) => control_points::put_curve(object, self.moved_curve(curve)?),
            (object, Bezier::Surface(patches)) => {
                control_points::put(object, Bezier::Surface(self.moved_surface(patches)?))
            }
        }
    }
}

impl BezierMovePoint {
    fn moved_curve(&self, curve: &Curve) -> Result<Curve, Problem> {
        for (value, field) in [(self.patch, "patch"), (self.row, "row"), (self.column, "column")] {
            if value.is_some() {
                return Err(Problem::of_field(field, "is for surfaces; a point of a curve has only `point`"));
            }
        }
        let at = control_points::check_point(given(self.point, "point")?, curve, "point")?;
        let mut curve = curve.clone();
        if let Some(point) = curve.points.get_mut(at) {
            *point = self.position.into();
        }
        Ok(curve)
    }

    fn moved_surface(&self, patches: &[Patch]) -> Result<Vec<Patch>, Problem> {
        if self.point.is_some() {
            return Err(Problem::of_field(
                "point",
                "is for curves; a surface's has `patch`, `row` and `column`",
            ));
        }
        let index = |value: Option<u32>, field: &str, count: usize| match given(value, field)? {
            at if (at as usize) < count => Ok(at as usize),
            at => Err(Problem::field(
                field,
                format!("there is no {field} {at}; the last one is {}", count.saturating_sub(1)),
            )),
        };
        let patch = index(self.patch, "patch", patches.len())?;
        let (row, column) = (index(self.row, "row", 4)?, index(self.column, "column", 4)?);
        let moved = patches.get(patch).and_then(|patch| patch.rows.get(row)?.get(column));
        let from = moved.copied().unwrap_or_default();
        let near = weld_distance(patches);
        let mut patches = patches.to_vec();
        for point in patches.iter_mut().flat_map(|patch| patch.rows.as_flattened_mut()) {
            if point.as_dvec3().distance(from.as_dvec3()) <= f64::from(near) {
                *point = self.position.into();
            }
        }
        Ok(patches)
    }
}
