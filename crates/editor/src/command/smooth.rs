//! `smooth`: vertices moved towards their neighbours.

use super::whole::{self, EachMesh};
use super::{Action, Field, FieldKind, Operation, OperationKind, Spec};
use crate::error::Problem;
use crate::json::shortest;
use halfedge::{Mesh, Progress};
use serde::{Deserialize, Serialize};

/// Moves every vertex towards the middle of its neighbours.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Smooth {
    /// How often.
    #[serde(default = "super::subdivide::one", with = "crate::json::whole")]
    pub iterations: u32,
    /// How far of the way each time, above 0 and up to 1.
    #[serde(default = "super::split_edge::half", with = "crate::json::finite")]
    pub strength: f32,
    /// How.
    #[serde(default)]
    pub method: SmoothMethod,
}

/// How vertices are moved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum SmoothMethod {
    /// Towards the middle of the neighbours; shrinks the mesh.
    #[default]
    Laplacian,
    /// There and a little more back (Taubin 1995); keeps the volume.
    Taubin,
}

impl Default for Smooth {
    fn default() -> Self {
        Self { iterations: 1, strength: 0.5, method: SmoothMethod::default() }
    }
}

impl Operation for Smooth {
    const SPEC: Spec = Spec {
        name: "smooth",
        label: "Smooth",
        description: "Moves every vertex towards the middle of its neighbours.",
        key: None,
        kind: OperationKind::WholeMesh,
        fields: &[
            Field::new("iterations", FieldKind::Integer { min: 1, max: 1000 }, "How often").or("1"),
            Field::new("strength", FieldKind::Number { min: 0.0, max: 1.0 }, "How far of the way each time")
                .or("0.5"),
            Field::new(
                "method",
                FieldKind::Choice(&["laplacian", "taubin"]),
                "Towards the neighbours, or there and back, which keeps the volume",
            )
            .or("\"laplacian\""),
        ],
    };

    fields_by_serde!();

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl EachMesh for Smooth {
    fn check(&self) -> Result<(), Problem> {
        whole::at_least_one(self.iterations, "iterations")
    }

    fn make(
        &self,
        mesh: &Mesh,
        _notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Mesh, Problem> {
        let options = surface::Smooth {
            iterations: self.iterations,
            strength: shortest(self.strength),
            method: match self.method {
                SmoothMethod::Laplacian => surface::SmoothMethod::Laplacian,
                SmoothMethod::Taubin => surface::SmoothMethod::Taubin,
            },
        };
        Ok(surface::smooth(mesh, &options, progress)?)
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        mesh.face_count().saturating_mul(self.iterations as usize)
    }
}
