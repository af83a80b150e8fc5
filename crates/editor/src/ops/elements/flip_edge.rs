//! `flip-edge`: turn an edge within its two faces.

use crate::error::Problem;
use crate::ops::refs::one;
use crate::ops::{Action, EdgeRef, Field, LocalEdit, Operation, Scope, Selected, Slot, Spec};
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Turn an edge one step counter-clockwise within the union of its two faces.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FlipEdge {
    /// The edge; each selected one in turn when left out.
    pub edge: Option<EdgeRef>,
}

impl Operation for FlipEdge {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "flip-edge",
        "Flip edge",
        "Turn an edge one step counter-clockwise within its two faces.",
    )
    .fields(&[Field::one("edge", Element::Edge, Selected::Each, "The edge to flip")]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Edge(&mut self.edge)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for FlipEdge {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_flip_edge(mesh, one(self.edge, "edge", mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::flip_edge(mesh, one(self.edge, "edge", mesh)?)?;
        Ok(())
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        2
    }
}
