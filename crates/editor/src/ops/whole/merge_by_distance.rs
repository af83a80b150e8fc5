//! `merge-by-distance`: merge vertices that are close to each other.

use super::each_mesh::EachMesh;
use crate::error::Problem;
use crate::ops::{Action, Amount, Counted, Estimate, Facts, Field, Operation, Scope, Spec, Suggestion, Unit};
use crate::script::json::shortest;
use halfedge::{Mesh, NumberRange, Progress};
use serde::{Deserialize, Serialize};

/// Merge vertices that are close to each other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MergeByDistance {
    /// The largest distance between merged vertices, in mesh units; 0 merges those at the same position.
    #[serde(with = "crate::script::json::finite")]
    pub distance: f32,
}

impl Operation for MergeByDistance {
    const SPEC: Spec = Spec::new(
        Scope::Meshes,
        "merge-by-distance",
        "Merge by distance",
        "Merge vertices that are close to each other.",
    )
    .synonyms(&["weld", "remove doubles"])
    .previewed()
    .fields(&[Field::number(
        "distance",
        Unit::Length,
        NumberRange::NOT_NEGATIVE,
        "The largest distance between merged vertices, in mesh units; 0 for those at the same position",
    )
    .suggest(Suggestion::OfDiagonal(1e-4))]);

    fn action(&self) -> Action<'_> {
        Action::WholeMesh(self)
    }
}

impl EachMesh for MergeByDistance {
    fn needs_faces(&self) -> bool {
        false
    }

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

    fn result(&self, facts: &Facts) -> Option<Estimate> {
        Some(Estimate { count: Amount::Unknown, counted: Counted::Vertices, of: Some(facts.vertices) })
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        // A point cloud has no faces, but points to merge.
        mesh.face_count().saturating_mul(2).max(mesh.vertex_count())
    }
}
