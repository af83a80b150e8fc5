//! `collapse-edge`: the ends of an edge made one vertex.

use super::fields::{given_t, one};
use super::{Action, EdgeRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Makes the two ends of an edge one vertex.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CollapseEdge {
    /// The edge; the selected ones, one after the other, if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edge: Option<EdgeRef>,
    /// How far along the edge's even half-edge the vertex is, from 0 to 1.
    #[serde(default = "super::split_edge::half", with = "crate::json::finite")]
    pub t: f32,
}

impl Operation for CollapseEdge {
    const SPEC: Spec = Spec {
        name: "collapse-edge",
        label: "Collapse edge",
        description: "Makes the two ends of an edge one vertex.",
        key: None,
        kind: OperationKind::Local,
        fields: &[
            Field::new("edge", FieldKind::Edge, "The edge to collapse").or("the selected edges"),
            Field::new("t", FieldKind::Number { min: 0.0, max: 1.0 }, "How far along the edge the vertex is")
                .or("0.5"),
        ],
    };

    fields_by_serde!();

    fn resolve(self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        target.each_edge(self, "edge", |op| &mut op.edge)
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for CollapseEdge {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        let (edge, t) = one(self.edge, "edge")?.find_along(self.t, mesh, "edge")?;
        Ok(edit::can_collapse_edge(mesh, edge, t).map_err(given_t(self.t))?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let (edge, t) = one(self.edge, "edge")?.find_along(self.t, mesh, "edge")?;
        edit::collapse_edge(mesh, edge, t).map_err(given_t(self.t))?;
        Ok(())
    }

    fn is_moot(&self, mesh: &Mesh) -> bool {
        self.edge.is_some_and(|edge| edge.find(mesh, "edge").is_err())
    }
}
