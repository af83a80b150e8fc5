//! `loop-cut`: cuts along a ring of quads.

use super::fields::one;
use super::{Action, EdgeRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Cuts the ring of quads through an edge.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LoopCut {
    /// The edge; the selected one if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edge: Option<EdgeRef>,
    /// How many cuts.
    #[serde(default = "super::subdivide::one", with = "crate::json::whole")]
    pub cuts: u32,
    /// Where the middle of the cuts is along the edge's even half-edge, between 0 and 1.
    #[serde(default = "super::split_edge::half", with = "crate::json::finite")]
    pub t: f32,
}

impl Operation for LoopCut {
    const SPEC: Spec = Spec {
        name: "loop-cut",
        label: "Loop cut",
        description: "Cuts the ring of quads through an edge.",
        key: None,
        kind: OperationKind::Local,
        fields: &[
            Field::new("edge", FieldKind::Edge, "An edge that the ring goes through").or("the selected edge"),
            Field::new("cuts", FieldKind::Integer { min: 1, max: 1000 }, "How many cuts").or("1"),
            Field::new(
                "t",
                FieldKind::Number { min: 0.0, max: 1.0 },
                "Where the middle of the cuts is along the edge",
            )
            .or("0.5"),
        ],
    };

    fields_by_serde!();

    fn resolve(mut self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        if self.edge.is_none() {
            self.edge = Some(target.only_edge("edge")?.into());
        }
        Ok(vec![self])
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for LoopCut {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_loop_cut(mesh, one(self.edge, "edge")?.find(mesh, "edge")?, self.cuts, self.t)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::loop_cut(mesh, one(self.edge, "edge")?.find(mesh, "edge")?, self.cuts, self.t)?;
        Ok(())
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        let edge = self.edge.and_then(|edge| edge.find(mesh, "edge").ok());
        let ring = edge.map_or(0, |edge| edit::edge_ring(mesh, edge).0.len());
        ring.saturating_mul(self.cuts as usize)
    }
}
