//! `remesh`: triangles with sides of one length.

use super::whole::{self, EachMesh};
use super::{Action, Field, FieldKind, Operation, OperationKind, Spec};
use crate::error::Problem;
use crate::json::{finite, finite_option, shortest};
use halfedge::{Mesh, Progress};
use serde::{Deserialize, Serialize};
use surface::SurfaceError;

/// Remeshes a surface into triangles with sides of one length (Botsch & Kobbelt 2004).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Remesh {
    /// The length of edges, in mesh units; the mean of the mesh's if left out.
    #[serde(default, skip_serializing_if = "Option::is_none", with = "finite_option")]
    pub edge_length: Option<f32>,
    /// How many rounds.
    #[serde(default = "five", with = "crate::json::whole")]
    pub iterations: u32,
    /// Edges whose faces' normals differ by more than this are kept, in degrees.
    #[serde(default = "forty_five", with = "finite")]
    pub feature_angle: f32,
    /// Whether vertices are put back on the surface each round.
    #[serde(default = "super::simplify::yes")]
    pub project: bool,
}

fn five() -> u32 {
    5
}

fn forty_five() -> f32 {
    45.0
}

impl Default for Remesh {
    fn default() -> Self {
        Self { edge_length: None, iterations: five(), feature_angle: forty_five(), project: true }
    }
}

impl Operation for Remesh {
    const SPEC: Spec = Spec {
        name: "remesh",
        label: "Remesh",
        description: "Makes triangles with sides of one length; polygons are cut into triangles first.",
        key: None,
        kind: OperationKind::WholeMesh,
        fields: &[
            Field::new(
                "edge_length",
                FieldKind::Number { min: 1e-6, max: 1e6 },
                "The length of edges, in mesh units",
            )
            .or("the mean of the edges"),
            Field::new("iterations", FieldKind::Integer { min: 1, max: 100 }, "How many rounds").or("5"),
            Field::new(
                "feature_angle",
                FieldKind::Number { min: 0.0, max: 180.0 },
                "Edges that are sharper than this many degrees are kept",
            )
            .or("45"),
            Field::new("project", FieldKind::Flag, "Whether vertices are put back on the surface").or("true"),
        ],
    };

    fields_by_serde!();

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl EachMesh for Remesh {
    fn check(&self) -> Result<(), Problem> {
        whole::at_least_one(self.iterations, "iterations")
    }

    fn make(
        &self,
        mesh: &Mesh,
        _notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Mesh, Problem> {
        let options = surface::Remesh {
            edge_length: self.edge_length.map(shortest),
            iterations: self.iterations,
            feature_angle: shortest(self.feature_angle),
            project: self.project,
        };
        surface::remesh(mesh, &options, progress).map_err(|error| match error {
            SurfaceError::TooManyFaces { .. } => {
                Problem::field("edge_length", format!("{error}; use a larger length"))
            }
            other => other.into(),
        })
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        let expected =
            |length| surface::Remesh::expected(surface::measure::surface_area(mesh), shortest(length));
        let made = self.edge_length.map_or(0.0, expected);
        let triangles = mesh.face_count().saturating_add(made as usize);
        triangles.saturating_mul(4).saturating_mul(self.iterations as usize)
    }
}
