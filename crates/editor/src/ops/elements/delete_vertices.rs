//! `delete-vertices`: delete vertices and their faces.

use crate::error::Problem;
use crate::ops::refs::{all, count};
use crate::ops::{
    Action, Family, Field, LocalEdit, Operation, SYMMETRY, Scope, Selected, Slot, Spec, VertexRef,
};
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Delete vertices with the faces around them, and other vertices that are left with no face.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct DeleteVertices {
    /// The vertices; the selected ones when left out.
    pub vertices: Option<Vec<VertexRef>>,
}

impl Operation for DeleteVertices {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "delete-vertices",
        "Delete vertices",
        "Delete vertices and the faces around them.",
    )
    .synonyms(&["erase", "remove vertices"])
    .family(Family::Delete)
    .fields(&[Field::many("vertices", Element::Vertex, Selected::All, "The vertices to delete"), SYMMETRY]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Vertices(&mut self.vertices)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for DeleteVertices {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_delete_vertices(mesh, &all(&self.vertices, "vertices", mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::delete_vertices(mesh, &all(&self.vertices, "vertices", mesh)?)?;
        Ok(())
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        count(&self.vertices, mesh.vertex_count())
    }
}
