//! `simplify`: keep the shape with fewer triangles.

use super::each_mesh::EachMesh;
use crate::error::Problem;
use crate::ops::facts::corners_at_most;
use crate::ops::{
    Action, Amount, Counted, DefaultValue, Estimate, Facts, Field, FieldKind, Operation, Scope, Spec,
    Suggestion, Unit,
};
use crate::script::json::shortest;
use halfedge::{Mesh, NumberRange, Progress};
use serde::{Deserialize, Serialize};
use surface::{SIMPLIFY_RATIO_RANGE, SimplifyTarget};

/// Collapse edges in order of the error that makes (Garland & Heckbert 1997). One of `faces`,
/// `ratio` and `max_error` says how far to go.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Simplify {
    /// The number of triangles to keep.
    pub faces: Option<u32>,
    /// The share of the triangles to keep, above 0 and up to 1.
    #[serde(default, with = "crate::script::json::finite_option")]
    pub ratio: Option<f32>,
    /// The largest distance from the original surface, in mesh units.
    #[serde(default, with = "crate::script::json::finite_option")]
    pub max_error: Option<f32>,
    /// Whether the boundary is preserved.
    pub preserve_boundary: bool,
    /// Whether seams of texture coordinates and normals are preserved.
    pub preserve_seams: bool,
}

const TITLE: &str = "Simplify to";
const PRESERVE: bool = true;

impl Simplify {
    /// Simplify to a share of the triangles, above 0 and up to 1.
    pub fn to_ratio(ratio: f32) -> Self {
        Self {
            faces: None,
            ratio: Some(ratio),
            max_error: None,
            preserve_boundary: PRESERVE,
            preserve_seams: PRESERVE,
        }
    }
}

impl Operation for Simplify {
    const SPEC: Spec = Spec::new(
        Scope::Meshes,
        "simplify",
        "Simplify",
        "Keep the shape with fewer triangles; polygons are triangulated first.",
    )
    .synonyms(&["decimate", "reduce polygons"])
    .previewed()
    .fields(&[
        Field::number(
            "ratio",
            Unit::ShareOfTriangles,
            SIMPLIFY_RATIO_RANGE,
            "The share of the triangles to keep",
        )
        .alternative(TITLE)
        .suggest(Suggestion::Number(0.5)),
        Field::required(
            "faces",
            FieldKind::Integer { unit: Unit::Triangles, range: NumberRange::counts(1, u32::MAX) },
            "The number of triangles to keep",
        )
        .alternative(TITLE)
        .labelled("Triangles")
        .suggest(Suggestion::OfTriangles(0.5)),
        // A thousandth of the mesh's size, which the eye can't see.
        Field::number(
            "max_error",
            Unit::Length,
            NumberRange::NOT_NEGATIVE,
            "The largest distance from the original surface, in mesh units",
        )
        .alternative(TITLE)
        .suggest(Suggestion::OfDiagonal(1e-3)),
        Field::required("preserve_boundary", FieldKind::Flag, "Keep the shape of the boundary")
            .or(DefaultValue::Flag(PRESERVE)),
        Field::required(
            "preserve_seams",
            FieldKind::Flag,
            "Keep the seams of texture coordinates and normals",
        )
        .or(DefaultValue::Flag(PRESERVE)),
    ]);

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl Simplify {
    fn target(&self) -> Result<SimplifyTarget, Problem> {
        match (self.faces, self.ratio, self.max_error) {
            (Some(faces), None, None) => Ok(SimplifyTarget::Faces(faces as usize)),
            (None, Some(ratio), None) => Ok(SimplifyTarget::Ratio(shortest(ratio))),
            (None, None, Some(error)) => Ok(SimplifyTarget::MaxError(shortest(error))),
            (None, None, None) => {
                Err(Problem::of_field("ratio", "is missing: give one of `faces`, `ratio` and `max_error`"))
            }
            (Some(_), _, _) => {
                Err(Problem::of_field("faces", "goes without `ratio` and `max_error`: give one of them"))
            }
            (None, _, _) => Err(Problem::of_field("ratio", "goes without `max_error`: give one of them")),
        }
    }
}

impl EachMesh for Simplify {
    fn check(&self) -> Result<(), Problem> {
        self.target().map(drop)
    }

    fn make(
        &self,
        mesh: &Mesh,
        notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Mesh, Problem> {
        let options = surface::Simplify {
            target: self.target()?,
            preserve_boundary: self.preserve_boundary,
            preserve_seams: self.preserve_seams,
        };
        let simplified = surface::simplify(mesh, &options, progress)?;
        notes.extend(simplified.shortfall());
        if simplified.has_seams {
            notes.push("Without “Preserve seams” fewer triangles are possible".to_owned());
        }
        Ok(simplified.mesh)
    }

    fn result(&self, facts: &Facts) -> Option<Estimate> {
        let all = facts.triangles()?;
        let count = match (self.ratio, self.faces) {
            (Some(ratio), _) => Amount::About((all as f64 * f64::from(ratio)).round() as usize),
            (None, Some(faces)) => Amount::About((faces as usize).min(all)),
            (None, None) => Amount::Unknown,
        };
        Some(Estimate { count, counted: Counted::Triangles, of: Some(all) })
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        // The triangles that are looked at count, not those that are left; measuring distances takes
        // longest.
        let work_per_triangle = if self.max_error.is_some() { 32 } else { 4 };
        triangles_at_most(mesh).saturating_mul(work_per_triangle)
    }
}

/// An upper bound of the number of triangles that the faces are cut into.
pub(super) fn triangles_at_most(mesh: &Mesh) -> usize {
    corners_at_most(mesh).saturating_sub(2 * mesh.face_count()).max(mesh.face_count())
}
