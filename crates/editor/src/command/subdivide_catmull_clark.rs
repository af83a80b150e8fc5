//! `subdivide-catmull-clark`: any polygons to smooth quads.

use super::subdivide::{self, BOUNDARY_NAMES, Boundary, MOST_LEVELS};
use super::whole::{self, EachMesh};
use super::{Action, Field, FieldKind, Operation, OperationKind, Spec};
use crate::error::Problem;
use halfedge::{Mesh, Progress};
use serde::{Deserialize, Serialize};

/// Subdivides any polygons into quads that approach a smooth surface (Catmull & Clark 1978).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SubdivideCatmullClark {
    /// How often.
    #[serde(default = "subdivide::one", with = "crate::json::whole")]
    pub levels: u32,
    /// What happens at the boundary.
    #[serde(default)]
    pub boundary: Boundary,
    /// Where old vertices go.
    #[serde(default)]
    pub vertex_rule: VertexRule,
}

/// Where old vertices go.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum VertexRule {
    /// As Catmull and Clark, and OpenSubdiv.
    #[default]
    Standard,
    /// As MayaLite: from edge points after smoothing instead of before.
    SmoothedMidpoints,
}

impl Default for SubdivideCatmullClark {
    fn default() -> Self {
        Self { levels: 1, boundary: Boundary::default(), vertex_rule: VertexRule::default() }
    }
}

impl Operation for SubdivideCatmullClark {
    const SPEC: Spec = Spec {
        name: "subdivide-catmull-clark",
        label: "Subdivide (Catmull-Clark)",
        description: "Cuts any polygons into quads that approach a smooth surface.",
        key: None,
        kind: OperationKind::WholeMesh,
        fields: &[
            Field::new("levels", FieldKind::Integer { min: 1, max: MOST_LEVELS }, "How often").or("1"),
            Field::new("boundary", FieldKind::Choice(BOUNDARY_NAMES), "Whether corners of the boundary stay")
                .or("\"edge-only\""),
            Field::new(
                "vertex_rule",
                FieldKind::Choice(&["standard", "smoothed-midpoints"]),
                "Where old vertices go: as in OpenSubdiv, or as in MayaLite",
            )
            .or("\"standard\""),
        ],
    };

    fields_by_serde!();

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl EachMesh for SubdivideCatmullClark {
    fn check(&self) -> Result<(), Problem> {
        whole::at_least_one(self.levels, "levels")
    }

    fn make(
        &self,
        mesh: &Mesh,
        _notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Mesh, Problem> {
        let options = surface::CatmullClark {
            levels: self.levels,
            boundary: self.boundary.into(),
            vertex_rule: match self.vertex_rule {
                VertexRule::Standard => surface::VertexRule::Standard,
                VertexRule::SmoothedMidpoints => surface::VertexRule::SmoothedMidpoints,
            },
        };
        surface::subdivide_catmull_clark(mesh, &options, progress).map_err(subdivide::refused)
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        subdivide::faces_after(mesh.face_count(), self.levels)
    }
}
