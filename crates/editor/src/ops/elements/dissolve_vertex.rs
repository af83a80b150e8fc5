//! `dissolve-vertex`: remove a vertex and merge its faces.

use crate::error::Problem;
use crate::ops::refs::one;
use crate::ops::{Action, Family, Field, LocalEdit, Operation, Scope, Selected, Slot, Spec, VertexRef};
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Remove a vertex and merge the faces around it into one polygon.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DissolveVertex {
    /// The vertex; each selected one in turn when left out.
    pub vertex: Option<VertexRef>,
}

impl Operation for DissolveVertex {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "dissolve-vertex",
        "Dissolve vertex",
        "Remove a vertex and merge the faces around it into one polygon.",
    )
    .synonyms(&["remove vertex"])
    .family(Family::Dissolve)
    .fields(&[Field::one("vertex", Element::Vertex, Selected::Each, "The vertex to dissolve")]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Vertex(&mut self.vertex)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for DissolveVertex {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_dissolve_vertex(mesh, one(self.vertex, "vertex", mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::dissolve_vertex(mesh, one(self.vertex, "vertex", mesh)?)?;
        Ok(())
    }

    fn is_moot(&self, mesh: &Mesh) -> bool {
        one(self.vertex, "vertex", mesh).is_err()
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        1
    }
}
