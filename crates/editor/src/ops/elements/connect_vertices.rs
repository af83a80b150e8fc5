//! `connect-vertices`: cut a face between two corners.

use crate::error::Problem;
use crate::ops::refs::two;
use crate::ops::{Action, Field, LocalEdit, Operation, SYMMETRY, Scope, Slot, Spec, VertexRef};
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Cut a face from one of its corners to another.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ConnectVertices {
    /// Two corners of one face; the two selected ones when left out.
    pub vertices: Option<[VertexRef; 2]>,
}

impl Operation for ConnectVertices {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "connect-vertices",
        "Connect vertices",
        "Cut a face from one of its corners to another.",
    )
    .synonyms(&["cut", "connect"])
    .fields(&[Field::two("vertices", Element::Vertex, "Two corners of one face"), SYMMETRY]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::TwoVertices(&mut self.vertices)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for ConnectVertices {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        let [a, b] = two(self.vertices, "vertices", mesh)?;
        Ok(edit::can_connect_vertices(mesh, a, b)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let [a, b] = two(self.vertices, "vertices", mesh)?;
        edit::connect_vertices(mesh, a, b)?;
        Ok(())
    }

    fn cuts_faces(&self) -> bool {
        true
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        2
    }
}
