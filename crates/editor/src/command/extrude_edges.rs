//! `extrude-edges`: quads beside boundary edges.

use super::fields::edges;
use super::live::slide;
use super::{Action, EdgeRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Puts a quad beside each of some boundary edges.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ExtrudeEdges {
    /// The boundary edges; the selected ones if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edges: Option<Vec<EdgeRef>>,
    /// Where the far sides are from the edges, in mesh units.
    #[serde(with = "crate::json::finite3")]
    pub offset: [f32; 3],
}

impl Operation for ExtrudeEdges {
    const SPEC: Spec = Spec {
        name: "extrude-edges",
        label: "Extrude edges",
        description: "Puts a quad beside each of some boundary edges.",
        key: None,
        kind: OperationKind::Local,
        fields: &[
            Field::new("edges", FieldKind::Edges, "The boundary edges to extrude").or("the selected edges"),
            Field::new("offset", FieldKind::Vector, "Where the far sides are, in mesh units"),
        ],
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

impl LocalEdit for ExtrudeEdges {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_extrude_edges(mesh, &edges(&self.edges, mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, notes: &mut Vec<String>) -> Result<(), Problem> {
        let live = edit::extrude_edges(mesh, &edges(&self.edges, mesh)?, self.offset.into())?;
        slide(mesh, &live, 1.0, "offset", notes)
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        self.edges.as_ref().map_or(mesh.edge_count(), Vec::len)
    }
}
