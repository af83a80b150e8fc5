//! `merge-by-distance`: vertices at the same place made one.

use super::whole::EachMesh;
use super::{Action, Field, FieldKind, Operation, OperationKind, Spec};
use crate::error::Problem;
use crate::json::shortest;
use halfedge::{Mesh, Progress};
use serde::{Deserialize, Serialize};

/// Makes vertices that are close to each other one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MergeByDistance {
    /// How close, in mesh units; 0 for those at the same place.
    #[serde(with = "crate::json::finite")]
    pub distance: f32,
}

impl Operation for MergeByDistance {
    const SPEC: Spec = Spec {
        name: "merge-by-distance",
        label: "Merge by distance",
        description: "Makes vertices that are close to each other one.",
        key: None,
        kind: OperationKind::WholeMesh,
        fields: &[Field::new(
            "distance",
            FieldKind::Number { min: 0.0, max: f32::MAX },
            "How close, in mesh units; 0 for those at the same place",
        )],
    };

    fields_by_serde!();

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl EachMesh for MergeByDistance {
    fn make(
        &self,
        mesh: &Mesh,
        notes: &mut Vec<String>,
        progress: &mut Progress<'_>,
    ) -> Result<Mesh, Problem> {
        let merged = surface::merge_by_distance(mesh, shortest(self.distance), progress)?;
        notes.extend(merged.notes.iter().map(ToString::to_string));
        Ok(merged.mesh)
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        mesh.face_count().saturating_mul(2)
    }
}
