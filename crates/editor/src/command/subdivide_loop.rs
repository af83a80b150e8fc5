//! `subdivide-loop`: triangles to smoother triangles.

use super::subdivide::{self, BOUNDARY_NAMES, Boundary, MOST_LEVELS};
use super::whole::{self, EachMesh};
use super::{Action, Field, FieldKind, Operation, OperationKind, Spec};
use crate::error::Problem;
use halfedge::{Mesh, Progress};
use serde::{Deserialize, Serialize};

/// Subdivides triangles into triangles that approach a smooth surface (Loop 1987).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SubdivideLoop {
    /// How often.
    #[serde(default = "subdivide::one", with = "crate::json::whole")]
    pub levels: u32,
    /// What happens at the boundary.
    #[serde(default)]
    pub boundary: Boundary,
    /// The weights of a vertex's neighbours.
    #[serde(default)]
    pub weights: Weights,
}

/// The weights of a vertex's neighbours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Weights {
    /// Loop 1987, as OpenSubdiv, OpenMesh and CGAL have it.
    #[default]
    Loop,
    /// Warren's: 3/16 at valence 3, else 3/(8n).
    Warren,
}

impl Default for SubdivideLoop {
    fn default() -> Self {
        Self { levels: 1, boundary: Boundary::default(), weights: Weights::default() }
    }
}

impl Operation for SubdivideLoop {
    const SPEC: Spec = Spec {
        name: "subdivide-loop",
        label: "Subdivide (Loop)",
        description: "Cuts triangles into triangles that approach a smooth surface.",
        key: None,
        kind: OperationKind::WholeMesh,
        fields: &[
            Field::new("levels", FieldKind::Integer { min: 1, max: MOST_LEVELS }, "How often").or("1"),
            Field::new("boundary", FieldKind::Choice(BOUNDARY_NAMES), "Whether corners of the boundary stay")
                .or("\"edge-only\""),
            Field::new(
                "weights",
                FieldKind::Choice(&["loop", "warren"]),
                "How much a vertex's neighbours count: as in OpenSubdiv, or as in the CS184 course",
            )
            .or("\"loop\""),
        ],
    };

    fields_by_serde!();

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl EachMesh for SubdivideLoop {
    fn check(&self) -> Result<(), Problem> {
        whole::at_least_one(self.levels, "levels")
    }

    fn make(
        &self,
        mesh: &Mesh,
        _notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Mesh, Problem> {
        let options = surface::Loop {
            levels: self.levels,
            boundary: self.boundary.into(),
            weights: match self.weights {
                Weights::Loop => surface::LoopWeights::Loop,
                Weights::Warren => surface::LoopWeights::Warren,
            },
        };
        surface::subdivide_loop(mesh, &options, progress).map_err(subdivide::refused)
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        subdivide::faces_after(mesh.face_count(), self.levels)
    }
}
