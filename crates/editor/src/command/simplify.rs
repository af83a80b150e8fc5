//! `simplify`: fewer triangles, the same shape.

use super::whole::EachMesh;
use super::{Action, Field, FieldKind, Operation, OperationKind, Spec};
use crate::error::Problem;
use crate::json::shortest;
use halfedge::{Mesh, Progress};
use serde::{Deserialize, Serialize};
use surface::SimplifyTarget;

/// Collapses edges in order of the error that makes (Garland & Heckbert 1997). One of `faces`,
/// `ratio` and `max_error` says how far to go.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Simplify {
    /// To this many triangles.
    #[serde(default, skip_serializing_if = "Option::is_none", with = "crate::json::whole_option")]
    pub faces: Option<u32>,
    /// To this share of the triangles, above 0 and up to 1.
    #[serde(default, skip_serializing_if = "Option::is_none", with = "crate::json::finite_option")]
    pub ratio: Option<f32>,
    /// As far as the surface stays within this distance of what it was, in mesh units.
    #[serde(default, skip_serializing_if = "Option::is_none", with = "crate::json::finite_option")]
    pub max_error: Option<f32>,
    /// Whether the boundary keeps its course.
    #[serde(default = "yes")]
    pub preserve_boundary: bool,
    /// Whether seams of texture coordinates and normals keep their course.
    #[serde(default = "yes")]
    pub preserve_seams: bool,
}

pub(super) fn yes() -> bool {
    true
}

impl Operation for Simplify {
    const SPEC: Spec = Spec {
        name: "simplify",
        label: "Simplify",
        description: "Makes fewer triangles of the same shape; polygons are cut into triangles first.",
        key: None,
        kind: OperationKind::WholeMesh,
        fields: &[
            Field::new("faces", FieldKind::Integer { min: 1, max: u32::MAX }, "To this many triangles")
                .or("not by count"),
            Field::new("ratio", FieldKind::Number { min: 0.0, max: 1.0 }, "To this share of the triangles"),
            Field::new(
                "max_error",
                FieldKind::Number { min: 0.0, max: f32::MAX },
                "As far as the surface stays this near to what it was, in mesh units",
            )
            .or("not by error"),
            Field::new("preserve_boundary", FieldKind::Flag, "Whether the boundary keeps its course")
                .or("true"),
            Field::new(
                "preserve_seams",
                FieldKind::Flag,
                "Whether seams of texture coordinates and normals keep their course",
            )
            .or("true"),
        ],
    };

    fields_by_serde!();

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
            (None, None, None) => Err(Problem::field(
                "ratio",
                "is missing: how far? Give one of `faces`, `ratio` and `max_error`",
            )),
            (Some(_), _, _) => {
                Err(Problem::field("faces", "goes without `ratio` and `max_error`: give one of them"))
            }
            (None, _, _) => Err(Problem::field("ratio", "goes without `max_error`: give one of them")),
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
            notes.push("Without “Preserve seams” (`preserve_seams`) it can become fewer".to_owned());
        }
        Ok(simplified.mesh)
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        // What there is to look at counts, not what is left; measuring distances takes longest.
        let each = if self.max_error.is_some() { 32 } else { 4 };
        mesh.face_count().saturating_mul(each)
    }
}
