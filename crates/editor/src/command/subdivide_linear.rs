//! `subdivide-linear`: any polygons to quads, without smoothing.

use super::subdivide::{self, MOST_LEVELS};
use super::whole::{self, EachMesh};
use super::{Action, Field, FieldKind, Operation, OperationKind, Spec};
use crate::error::Problem;
use halfedge::{Mesh, Progress};
use serde::{Deserialize, Serialize};

/// Cuts polygons into quads as Catmull-Clark does, leaving the surface where it is.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SubdivideLinear {
    /// How often.
    #[serde(default = "subdivide::one", with = "crate::json::whole")]
    pub levels: u32,
}

impl Default for SubdivideLinear {
    fn default() -> Self {
        Self { levels: 1 }
    }
}

impl Operation for SubdivideLinear {
    const SPEC: Spec = Spec {
        name: "subdivide-linear",
        label: "Subdivide (linear)",
        description: "Cuts polygons into quads without smoothing.",
        key: None,
        kind: OperationKind::WholeMesh,
        fields: &[Field::new("levels", FieldKind::Integer { min: 1, max: MOST_LEVELS }, "How often").or("1")],
    };

    fields_by_serde!();

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl EachMesh for SubdivideLinear {
    fn check(&self) -> Result<(), Problem> {
        whole::at_least_one(self.levels, "levels")
    }

    fn make(
        &self,
        mesh: &Mesh,
        _notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Mesh, Problem> {
        let options = surface::Linear { levels: self.levels };
        surface::subdivide_linear(mesh, &options, progress).map_err(subdivide::refused)
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        subdivide::faces_after(mesh.face_count(), self.levels)
    }
}
