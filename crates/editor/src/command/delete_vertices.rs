//! `delete-vertices`: vertices taken away with their faces.

use super::fields::vertices;
use super::{Action, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target, VertexRef};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Takes vertices away with the faces around them, and other vertices left with no face.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DeleteVertices {
    /// The vertices; the selected ones if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vertices: Option<Vec<VertexRef>>,
}

impl Operation for DeleteVertices {
    const SPEC: Spec = Spec {
        name: "delete-vertices",
        label: "Delete vertices",
        description: "Takes vertices away with the faces around them.",
        key: None,
        kind: OperationKind::Local,
        fields: &[
            Field::new("vertices", FieldKind::Vertices, "The vertices to delete").or("the selected vertices")
        ],
    };

    fields_by_serde!();

    fn resolve(mut self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        target.fill_vertices(&mut self.vertices, "vertices")?;
        Ok(vec![self])
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for DeleteVertices {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_delete_vertices(mesh, &vertices(&self.vertices, mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::delete_vertices(mesh, &vertices(&self.vertices, mesh)?)?;
        Ok(())
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        self.vertices.as_ref().map_or(mesh.vertex_count(), Vec::len)
    }
}
