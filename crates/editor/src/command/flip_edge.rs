//! `flip-edge`: an edge turned within its two faces.

use super::fields::one;
use super::{Action, EdgeRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Turns an edge one step counter-clockwise within the two faces beside it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FlipEdge {
    /// The edge; the selected ones, one after the other, if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edge: Option<EdgeRef>,
}

impl Operation for FlipEdge {
    const SPEC: Spec = Spec {
        name: "flip-edge",
        label: "Flip edge",
        description: "Turns an edge one step counter-clockwise within the two faces beside it.",
        key: None,
        kind: OperationKind::Local,
        fields: &[Field::new("edge", FieldKind::Edge, "The edge to flip").or("the selected edges")],
    };

    fields_by_serde!();

    fn resolve(self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        target.each_edge(self, "edge", |op| &mut op.edge)
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for FlipEdge {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_flip_edge(mesh, one(self.edge, "edge")?.find(mesh, "edge")?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::flip_edge(mesh, one(self.edge, "edge")?.find(mesh, "edge")?)?;
        Ok(())
    }
}
