//! `set-vertex-position`: puts one vertex somewhere.

use super::fields::one;
use super::{Action, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target, VertexRef};
use crate::error::Problem;
use halfedge::{Element, Mesh};
use serde::{Deserialize, Serialize};

/// Puts one vertex somewhere.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SetVertexPosition {
    /// The vertex; the selected one if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vertex: Option<VertexRef>,
    /// Where it goes, in mesh units.
    #[serde(with = "crate::json::finite3")]
    pub position: [f32; 3],
}

impl Operation for SetVertexPosition {
    const SPEC: Spec = Spec {
        name: "set-vertex-position",
        label: "Move vertex",
        description: "Puts a vertex at a position.",
        key: None,
        kind: OperationKind::Local,
        fields: &[
            Field::new("vertex", FieldKind::Vertex, "The vertex to move").or("the selected vertex"),
            Field::new("position", FieldKind::Vector, "Where it goes, in mesh units"),
        ],
    };

    fields_by_serde!();

    fn resolve(mut self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        if self.vertex.is_none() {
            self.vertex = Some(VertexRef(target.only(Element::Vertex, "vertex")?));
        }
        Ok(vec![self])
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for SetVertexPosition {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        one(self.vertex, "vertex")?.find(mesh, "vertex").map(drop)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let v = one(self.vertex, "vertex")?.find(mesh, "vertex")?;
        mesh.set_position(v, self.position.into());
        Ok(())
    }
}
