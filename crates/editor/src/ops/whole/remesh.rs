//! `remesh`: make triangles with edges of one length.

use super::each_mesh::EachMesh;
use super::simplify::triangles_at_most;
use crate::error::Problem;
use crate::ops::{
    Action, Amount, Counted, DefaultValue, Estimate, Facts, Field, FieldKind, Operation, Scope, Spec,
    Suggestion, Unit,
};
use crate::script::json::{finite, finite_option, shortest};
use halfedge::{Mesh, NumberRange, Progress};
use serde::{Deserialize, Serialize};
use surface::{REMESH_FEATURE_ANGLE_RANGE, REMESH_ITERATIONS_RANGE, SurfaceError};

/// Remesh a surface into triangles with edges of one length (Botsch & Kobbelt 2004).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Remesh {
    /// The length of edges, in mesh units; when left out, the mean of the mesh's, or where that would make far more or
    /// far fewer triangles than the mesh has, one that doesn't.
    #[serde(default, with = "finite_option")]
    pub edge_length: Option<f32>,
    /// The number of iterations.
    pub iterations: u32,
    /// Edges whose faces' normals differ by more than this are kept, in degrees.
    #[serde(with = "finite")]
    pub feature_angle: f32,
    /// Whether vertices are projected back onto the surface each round.
    pub project: bool,
}

const ITERATIONS: u32 = 5;
const FEATURE_ANGLE_DEGREES: f32 = 45.0;
const PROJECT: bool = true;

/// Edges of up to this many times the mean length leave a number of triangles that follows from the
/// area; how much coarser a mesh can become depends on its features.
const MAX_COARSENING_ESTIMATED: f64 = 1.5;

/// Where the default length is less than this part of the mean, edges are much longer than triangles are wide.
const MIN_LENGTH_ESTIMATED: f64 = 0.5;

impl Default for Remesh {
    fn default() -> Self {
        Self {
            edge_length: None,
            iterations: ITERATIONS,
            feature_angle: FEATURE_ANGLE_DEGREES,
            project: PROJECT,
        }
    }
}

impl Operation for Remesh {
    const SPEC: Spec = Spec::new(
        Scope::Meshes,
        "remesh",
        "Remesh",
        "Make triangles with edges of one length; polygons are triangulated first.",
    )
    .synonyms(&["isotropic", "regular triangles"])
    .previewed()
    .fields(&[
        Field::number(
            "edge_length",
            Unit::Length,
            NumberRange::POSITIVE,
            "The length of edges, in mesh units",
        )
        .unset("about the mean length")
        .suggest(Suggestion::RemeshedEdge),
        Field::count("iterations", REMESH_ITERATIONS_RANGE, "The number of iterations")
            .or(DefaultValue::Integer(ITERATIONS)),
        Field::number(
            "feature_angle",
            Unit::Degrees,
            REMESH_FEATURE_ANGLE_RANGE,
            "Keep edges that are sharper than this many degrees",
        )
        .or(DefaultValue::Number(FEATURE_ANGLE_DEGREES as f64)),
        Field::required("project", FieldKind::Flag, "Project vertices back onto the surface")
            .labelled("Stay on surface")
            .or(DefaultValue::Flag(PROJECT)),
    ]);

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl EachMesh for Remesh {
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

    fn result(&self, facts: &Facts) -> Option<Estimate> {
        let (area, mean_edge) = (facts.area?, facts.mean_edge?);
        let by_itself = facts.remeshed_edge()?;
        let length = self.edge_length.map_or(by_itself, shortest);
        let expected = surface::Remesh::expected(area, length);
        // The area of slivers says little of how many triangles they become.
        let has_slivers = by_itself < MIN_LENGTH_ESTIMATED * mean_edge;
        let is_known = length <= MAX_COARSENING_ESTIMATED * mean_edge && !has_slivers && expected.is_finite();
        let count = if is_known { Amount::About(expected.round() as usize) } else { Amount::Unknown };
        Some(Estimate { count, counted: Counted::Triangles, of: None })
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        let length = self.edge_length.map_or_else(|| surface::Remesh::default_length(mesh), shortest);
        let made = surface::Remesh::most_triangles(mesh, length);
        // A number that is too large becomes the largest one.
        let triangles = triangles_at_most(mesh).saturating_add(made as usize);
        triangles.saturating_mul(4).saturating_mul(self.iterations as usize)
    }
}
