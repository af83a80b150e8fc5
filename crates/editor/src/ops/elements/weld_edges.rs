//! `weld-edges`: join two boundary edges.

use crate::error::Problem;
use crate::ops::refs::two;
use crate::ops::{Action, EdgeRef, Field, LocalEdit, Operation, SYMMETRY, Scope, Slot, Spec};
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Join two boundary edges into one: the opposite of ripping.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct WeldEdges {
    /// Two boundary edges; the two selected ones when left out.
    pub edges: Option<[EdgeRef; 2]>,
}

impl Operation for WeldEdges {
    const SPEC: Spec =
        Spec::new(Scope::Elements, "weld-edges", "Weld edges", "Join two boundary edges into one.")
            .synonyms(&["stitch", "sew"])
            .fields(&[Field::two("edges", Element::Edge, "Two boundary edges"), SYMMETRY]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::TwoEdges(&mut self.edges)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for WeldEdges {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_weld_edges(mesh, two(self.edges, "edges", mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::weld_edges(mesh, two(self.edges, "edges", mesh)?)?;
        Ok(())
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        1
    }
}
