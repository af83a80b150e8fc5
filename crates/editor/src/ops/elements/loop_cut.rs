//! `loop-cut`: cut along a ring of quads.

use crate::error::Problem;
use crate::ops::refs::one;
use crate::ops::{Action, DefaultValue, EdgeRef, Field, LocalEdit, Operation, Scope, Selected, Slot, Spec, Unit};
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Cut the ring of quads that crosses an edge.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct LoopCut {
    /// The edge; the selected one when left out.
    pub edge: Option<EdgeRef>,
    /// How many cuts.
    #[serde(with = "crate::script::json::whole")]
    pub cuts: u32,
    /// Where the middle of the cuts is along the edge's even half-edge, between 0 and 1.
    #[serde(with = "crate::script::json::finite")]
    pub t: f32,
}

impl Operation for LoopCut {
    const SPEC: Spec =
        Spec::new(Scope::Elements, "loop-cut", "Loop cut", "Cut the ring of quads that crosses an edge.")
            .synonyms(&["insert edge loop", "ring cut"])
            .fields(&[
                Field::one("edge", Element::Edge, Selected::Only, "An edge that the ring crosses"),
                Field::count("cuts", [1, 1000], "How many cuts").or(DefaultValue::Integer(1)),
                Field::number(
                    "t",
                    Unit::Fraction,
                    [0.0, 1.0],
                    "The position of the middle of the cuts along the edge",
                )
                .labelled("Position (0 to 1)")
                .or(DefaultValue::Number(0.5)),
            ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Edge(&mut self.edge)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for LoopCut {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_loop_cut(mesh, one(self.edge, "edge", mesh)?, self.cuts, self.t)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::loop_cut(mesh, one(self.edge, "edge", mesh)?, self.cuts, self.t)?;
        Ok(())
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        let ring = one(self.edge, "edge", mesh).map_or(0, |edge| edit::edge_ring(mesh, edge).0.len());
        ring.saturating_mul(self.cuts as usize)
    }
}
