//! `rip-edges`: edges made boundary.

use super::fields::edges;
use super::{Action, EdgeRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Makes edges boundary: the faces on both sides come apart.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RipEdges {
    /// The edges; the selected ones if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edges: Option<Vec<EdgeRef>>,
}

impl Operation for RipEdges {
    const SPEC: Spec = Spec {
        name: "rip-edges",
        label: "Rip edges",
        description: "Makes edges boundary: the faces on both sides come apart.",
        key: None,
        kind: OperationKind::Local,
        fields: &[Field::new("edges", FieldKind::Edges, "The edges to rip").or("the selected edges")],
    };

    fields_by_serde!();

    fn resolve(mut self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        target.fill_edges(&mut self.edges, "edges")?;
        Ok(vec![self])
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for RipEdges {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_rip_edges(mesh, &edges(&self.edges, mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::rip_edges(mesh, &edges(&self.edges, mesh)?)?;
        Ok(())
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        self.edges.as_ref().map_or(mesh.edge_count(), Vec::len)
    }
}
