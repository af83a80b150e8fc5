//! `bezier-move-point`: puts a control point somewhere.

use super::fields::one;
use super::{Action, DocumentEdit, Field, FieldKind, Operation, OperationKind, Place, Spec, bezier};
use crate::bezier::Bezier;
use crate::error::Problem;
use crate::history::Change;
use glam::Vec3;
use serde::{Deserialize, Serialize};
use surface::bezier::{Curve, Patch, weld_distance};

/// Puts a control point of a curve or a patch somewhere. Points of patches that lie at the same
/// place, as on a shared border, move together.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BezierMovePoint {
    /// For a curve: which control point, from 0.
    #[serde(default, skip_serializing_if = "Option::is_none", with = "crate::json::whole_option")]
    pub point: Option<u32>,
    /// For a surface: which patch, from 0.
    #[serde(default, skip_serializing_if = "Option::is_none", with = "crate::json::whole_option")]
    pub patch: Option<u32>,
    /// For a surface: which of the patch's rows, 0 to 3.
    #[serde(default, skip_serializing_if = "Option::is_none", with = "crate::json::whole_option")]
    pub row: Option<u32>,
    /// For a surface: which point of the row, 0 to 3.
    #[serde(default, skip_serializing_if = "Option::is_none", with = "crate::json::whole_option")]
    pub column: Option<u32>,
    /// Where it goes.
    #[serde(with = "crate::json::finite3")]
    pub position: [f32; 3],
}

const INDEX: FieldKind = FieldKind::Integer { min: 0, max: u32::MAX };
const OF_FOUR: FieldKind = FieldKind::Integer { min: 0, max: 3 };

impl Operation for BezierMovePoint {
    const SPEC: Spec = Spec {
        name: "bezier-move-point",
        label: "Move control point",
        description: "Puts a control point of a curve or surface somewhere; patch points at one place move together.",
        key: None,
        kind: OperationKind::Bezier,
        fields: &[
            Field::new("point", INDEX, "Which control point of a curve").or("none, for a surface"),
            Field::new("patch", INDEX, "Which patch of a surface").or("none, for a curve"),
            Field::new("row", OF_FOUR, "Which row of the patch").or("none, for a curve"),
            Field::new("column", OF_FOUR, "Which point of the row").or("none, for a curve"),
            Field::new("position", FieldKind::Vector, "Where it goes"),
        ],
    };

    fields_by_serde!();

    fn action(&self) -> Action<'_> {
        Action::Document(self)
    }
}

impl DocumentEdit for BezierMovePoint {
    fn changes(&self, place: &Place<'_>) -> Result<Vec<Change>, Problem> {
        match bezier::object(place)? {
            (object, Bezier::Curve(curve)) => bezier::put_curve(object, self.move_of_curve(curve)?),
            (object, Bezier::Surface(patches)) => {
                bezier::put(object, Bezier::Surface(self.move_of_surface(patches)?))
            }
        }
    }
}

impl BezierMovePoint {
    fn move_of_curve(&self, curve: &Curve) -> Result<Curve, Problem> {
        for (given, field) in [(self.patch, "patch"), (self.row, "row"), (self.column, "column")] {
            if given.is_some() {
                return Err(Problem::field(field, "is for surfaces; a point of a curve has only `point`"));
            }
        }
        let at = bezier::check_point(one(self.point, "point")?, curve, "point")?;
        let mut curve = curve.clone();
        if let Some(point) = curve.points.get_mut(at) {
            *point = self.position.into();
        }
        Ok(curve)
    }

    fn move_of_surface(&self, patches: &[Patch]) -> Result<Vec<Patch>, Problem> {
        if self.point.is_some() {
            return Err(Problem::field(
                "point",
                "is for curves; a surface's has `patch`, `row` and `column`",
            ));
        }
        let index = |given: Option<u32>, field: &str, count: usize| match one(given, field)? {
            at if (at as usize) < count => Ok(at as usize),
            at => Err(Problem::field(
                field,
                format!("there is no {field} {at}; the last one is {}", count.saturating_sub(1)),
            )),
        };
        let patch = index(self.patch, "patch", patches.len())?;
        let (row, column) = (index(self.row, "row", 4)?, index(self.column, "column", 4)?);
        let from = patches.get(patch).map_or(Vec3::ZERO, |patch| patch.rows[row][column]);
        let near = weld_distance(patches);
        let mut patches = patches.to_vec();
        for point in patches.iter_mut().flat_map(|patch| patch.rows.as_flattened_mut()) {
            if point.distance(from) <= near {
                *point = self.position.into();
            }
        }
        Ok(patches)
    }
}
