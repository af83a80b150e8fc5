//! `dissolve-edge`: the faces beside an edge made one.

use super::fields::one;
use super::{Action, EdgeRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Makes the two faces beside an edge one polygon.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DissolveEdge {
    /// The edge; the selected ones, one after the other, if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edge: Option<EdgeRef>,
}

impl Operation for DissolveEdge {
    const SPEC: Spec = Spec {
        name: "dissolve-edge",
        label: "Dissolve edge",
        description: "Makes the two faces beside an edge one polygon.",
        key: None,
        kind: OperationKind::Local,
        fields: &[Field::new("edge", FieldKind::Edge, "The edge to dissolve").or("the selected edges")],
    };

    fields_by_serde!();

    fn resolve(self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        target.each_edge(self, "edge", |op| &mut op.edge)
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for DissolveEdge {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_dissolve_edge(mesh, one(self.edge, "edge")?.find(mesh, "edge")?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::dissolve_edge(mesh, one(self.edge, "edge")?.find(mesh, "edge")?)?;
        Ok(())
    }

    fn is_moot(&self, mesh: &Mesh) -> bool {
        self.edge.is_some_and(|edge| edge.find(mesh, "edge").is_err())
    }
}
