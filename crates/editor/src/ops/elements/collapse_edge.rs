//! `collapse-edge`: merge the ends of an edge.

use crate::error::Problem;
use crate::ops::refs::{given, one};
use crate::ops::{
    Action, DefaultValue, EdgeRef, Field, LocalEdit, Operation, Reflection, SYMMETRY, Scope, Selected, Slot,
    Spec, Unit,
};
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Merge the two ends of an edge into one vertex.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct CollapseEdge {
    /// The edge; each selected one in turn when left out.
    pub edge: Option<EdgeRef>,
    /// Where the vertex is along the edge's even half-edge, from 0 to 1.
    #[serde(with = "crate::script::json::finite")]
    pub t: f32,
}

impl Operation for CollapseEdge {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "collapse-edge",
        "Collapse edge",
        "Merge the two ends of an edge into one vertex.",
    )
    .fields(&[
        Field::one("edge", Element::Edge, Selected::Each, "The edge to collapse"),
        Field::number(
            "t",
            Unit::Fraction,
            edit::COLLAPSE_T_RANGE,
            "The position of the vertex along the edge",
        )
        .labelled("Position (0 to 1)")
        .or(DefaultValue::Number(0.5)),
        SYMMETRY,
    ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Edge(&mut self.edge)]
    }

    fn reflect(&mut self, reflection: Reflection) {
        self.t = reflection.along(self.t);
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for CollapseEdge {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        let (edge, t) = given(self.edge, "edge")?.find_along(self.t, mesh, "edge")?;
        Ok(edit::can_collapse_edge(mesh, edge, t)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let (edge, t) = given(self.edge, "edge")?.find_along(self.t, mesh, "edge")?;
        edit::collapse_edge(mesh, edge, t)?;
        Ok(())
    }

    fn is_moot(&self, mesh: &Mesh) -> bool {
        one(self.edge, "edge", mesh).is_err()
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        1
    }
}
