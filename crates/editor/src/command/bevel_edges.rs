//! `bevel-edges`: edges made strips of faces.

use super::fields::edges;
use super::live::{not_negative, slide};
use super::{Action, EdgeRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Makes each edge a strip of faces.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct BevelEdges {
    /// The edges; the selected ones if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edges: Option<Vec<EdgeRef>>,
    /// How far the strip goes on each side, in mesh units, 0 or more.
    #[serde(with = "crate::json::finite")]
    pub width: f32,
    /// How many faces there are across the strip.
    #[serde(default = "super::subdivide::one", with = "crate::json::whole")]
    pub segments: u32,
}

impl Operation for BevelEdges {
    const SPEC: Spec = Spec {
        name: "bevel-edges",
        label: "Bevel edges",
        description: "Makes each edge a strip of faces.",
        key: None,
        kind: OperationKind::Local,
        fields: &[
            Field::new("edges", FieldKind::Edges, "The edges to bevel").or("the selected edges"),
            Field::new(
                "width",
                FieldKind::Number { min: 0.0, max: f32::MAX },
                "How far it goes on each side, in mesh units",
            ),
            Field::new(
                "segments",
                FieldKind::Integer { min: 1, max: 256 },
                "How many faces there are across",
            )
            .or("1"),
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

impl LocalEdit for BevelEdges {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        not_negative(self.width, "width")?;
        Ok(edit::can_bevel_edges(mesh, &edges(&self.edges, mesh)?, self.segments)?)
    }

    fn edit(&self, mesh: &mut Mesh, notes: &mut Vec<String>) -> Result<(), Problem> {
        not_negative(self.width, "width")?;
        let live = edit::bevel_edges(mesh, &edges(&self.edges, mesh)?, self.segments)?;
        slide(mesh, &live, self.width, "width", notes)
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        let edges = self.edges.as_ref().map_or(mesh.edge_count(), Vec::len);
        edges.saturating_mul(self.segments as usize)
    }
}
