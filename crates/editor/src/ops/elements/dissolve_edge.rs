//! `dissolve-edge`: remove an edge and merge its faces.

use crate::error::Problem;
use crate::ops::refs::one;
use crate::ops::{Action, EdgeRef, Family, Field, LocalEdit, Operation, Scope, Selected, Slot, Spec};
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Remove an edge and merge its two faces into one polygon.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DissolveEdge {
    /// The edge; each selected one in turn when left out.
    pub edge: Option<EdgeRef>,
}

impl Operation for DissolveEdge {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "dissolve-edge",
        "Dissolve edge",
        "Remove an edge and merge its two faces into one polygon.",
    )
    .family(Family::Delete)
    .fields(&[Field::one("edge", Element::Edge, Selected::Each, "The edge to dissolve")]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Edge(&mut self.edge)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for DissolveEdge {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_dissolve_edge(mesh, one(self.edge, "edge", mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::dissolve_edge(mesh, one(self.edge, "edge", mesh)?)?;
        Ok(())
    }

    fn is_moot(&self, mesh: &Mesh) -> bool {
        one(self.edge, "edge", mesh).is_err()
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        1
    }
}
