//! `flip-edge`: turn an edge within its two faces.

use crate::error::Problem;
use crate::ops::refs::one;
use crate::ops::{
    Action, EdgeRef, Field, LocalEdit, Operation, Reflection, SYMMETRY, Scope, Selected, Slot, Spec,
};
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Turn an edge one step counter-clockwise within the union of its two faces.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FlipEdge {
    /// The edge; each selected one in turn when left out.
    pub edge: Option<EdgeRef>,
    /// Turn it clockwise, as a mirror image does.
    #[serde(skip)]
    clockwise: bool,
}

impl Operation for FlipEdge {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "flip-edge",
        "Flip edge",
        "Turn an edge one step counter-clockwise within its two faces.",
    )
    .fields(&[Field::one("edge", Element::Edge, Selected::Each, "The edge to flip"), SYMMETRY]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Edge(&mut self.edge)]
    }

    fn reflect(&mut self, reflection: Reflection) {
        self.clockwise = !reflection.is_own;
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for FlipEdge {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        let can = if self.clockwise { edit::can_flip_edge_clockwise } else { edit::can_flip_edge };
        Ok(can(mesh, one(self.edge, "edge", mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let flip = if self.clockwise { edit::flip_edge_clockwise } else { edit::flip_edge };
        flip(mesh, one(self.edge, "edge", mesh)?)?;
        Ok(())
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        2
    }
}
