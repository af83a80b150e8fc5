//! `merge-vertices`: several vertices made one.

use super::fields::vertices;
use super::{Action, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target, VertexRef};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Makes several vertices one.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct MergeVertices {
    /// The vertices; those of the selected elements if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vertices: Option<Vec<VertexRef>>,
    /// Where the vertex goes; the mean of the vertices if left out.
    #[serde(default, skip_serializing_if = "Option::is_none", with = "crate::json::finite3_option")]
    pub position: Option<[f32; 3]>,
}

impl Operation for MergeVertices {
    const SPEC: Spec = Spec {
        name: "merge-vertices",
        label: "Merge vertices",
        description: "Makes several vertices one.",
        key: None,
        kind: OperationKind::Local,
        fields: &[
            Field::new("vertices", FieldKind::Vertices, "The vertices to merge").or("the selected vertices"),
            Field::new("position", FieldKind::Vector, "Where the vertex goes")
                .or("the centre of the vertices"),
        ],
    };

    fields_by_serde!();

    fn resolve(mut self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        if self.vertices.is_none() {
            self.vertices = Some(target.vertices("vertices")?.into_iter().map(VertexRef::from).collect());
        }
        Ok(vec![self])
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for MergeVertices {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_merge_vertices(mesh, &vertices(&self.vertices, mesh)?, self.position.map(Into::into))?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::merge_vertices(mesh, &vertices(&self.vertices, mesh)?, self.position.map(Into::into))?;
        Ok(())
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        self.vertices.as_ref().map_or(mesh.vertex_count(), Vec::len)
    }
}
