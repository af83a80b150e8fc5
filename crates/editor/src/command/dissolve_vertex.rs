//! `dissolve-vertex`: the faces around a vertex made one.

use super::fields::one;
use super::{Action, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target, VertexRef};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Makes the faces around a vertex one polygon.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DissolveVertex {
    /// The vertex; the selected ones, one after the other, if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vertex: Option<VertexRef>,
}

impl Operation for DissolveVertex {
    const SPEC: Spec = Spec {
        name: "dissolve-vertex",
        label: "Dissolve vertex",
        description: "Makes the faces around a vertex one polygon.",
        key: None,
        kind: OperationKind::Local,
        fields: &[
            Field::new("vertex", FieldKind::Vertex, "The vertex to dissolve").or("the selected vertices")
        ],
    };

    fields_by_serde!();

    fn resolve(self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        target.each_vertex(self, "vertex", |op| &mut op.vertex)
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for DissolveVertex {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_dissolve_vertex(mesh, one(self.vertex, "vertex")?.find(mesh, "vertex")?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::dissolve_vertex(mesh, one(self.vertex, "vertex")?.find(mesh, "vertex")?)?;
        Ok(())
    }

    fn is_moot(&self, mesh: &Mesh) -> bool {
        self.vertex.is_some_and(|vertex| vertex.find(mesh, "vertex").is_err())
    }
}
