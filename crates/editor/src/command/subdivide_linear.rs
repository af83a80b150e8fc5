//! `subdivide-linear`: any polygons to quads, without smoothing.

use super::subdivide::{self, MOST_LEVELS};
use super::{Action, Field, FieldKind, Input, Operation, OperationKind, Output, Spec, WholeMesh, whole};
use crate::error::Problem;
use halfedge::Progress;
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

impl WholeMesh for SubdivideLinear {
    fn check(&self) -> Result<(), Problem> {
        whole::at_least_one(self.levels, "levels")
    }

    fn compute(
        &self,
        inputs: &[Input],
        _notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Vec<Output>, Problem> {
        let options = surface::Linear { levels: self.levels };
        whole::each(inputs, progress, |mesh, progress| {
            surface::subdivide_linear(mesh, &options, progress).map_err(subdivide::refused)
        })
    }

    fn cost(&self, inputs: &[Input]) -> usize {
        subdivide::faces_after(inputs, self.levels)
    }
}
