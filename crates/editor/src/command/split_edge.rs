//! `split-edge`: a new vertex on an edge, and cuts from it.

use super::fields::{given_t, one};
use super::{Action, EdgeRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Puts a new vertex on an edge and cuts the faces beside it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SplitEdge {
    /// The edge; the selected ones, one after the other, if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub edge: Option<EdgeRef>,
    /// How far along the edge's even half-edge the vertex is, between 0 and 1.
    #[serde(default = "half", with = "crate::json::finite")]
    pub t: f32,
    /// Which faces beside the edge are cut.
    #[serde(default)]
    pub connect: Connect,
}

/// Which faces beside a split edge are cut from the new vertex.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Connect {
    /// None: both faces gain a corner.
    None,
    /// Triangles, to their opposite corner.
    #[default]
    Triangles,
    /// All, to the corner halfway round.
    All,
}

pub(super) fn half() -> f32 {
    0.5
}

impl Operation for SplitEdge {
    const SPEC: Spec = Spec {
        name: "split-edge",
        label: "Split edge",
        description: "Puts a new vertex on an edge and cuts the faces beside it.",
        key: Some("S"),
        kind: OperationKind::Local,
        fields: &[
            Field::new("edge", FieldKind::Edge, "The edge to split").or("the selected edges"),
            Field::new(
                "t",
                FieldKind::Number { min: 0.0, max: 1.0 },
                "How far along the edge, between its ends",
            )
            .or("0.5"),
            Field::new(
                "connect",
                FieldKind::Choice(&["none", "triangles", "all"]),
                "Which of the faces beside the edge are cut",
            )
            .or("\"triangles\""),
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

impl From<Connect> for edit::Connect {
    fn from(connect: Connect) -> Self {
        match connect {
            Connect::None => Self::None,
            Connect::Triangles => Self::Triangles,
            Connect::All => Self::All,
        }
    }
}

impl LocalEdit for SplitEdge {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        let (edge, t) = one(self.edge, "edge")?.find_along(self.t, mesh, "edge")?;
        Ok(edit::can_split_edge(mesh, edge, t, self.connect.into()).map_err(given_t(self.t))?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let (edge, t) = one(self.edge, "edge")?.find_along(self.t, mesh, "edge")?;
        edit::split_edge(mesh, edge, t, self.connect.into()).map_err(given_t(self.t))?;
        Ok(())
    }
}
