//! `rip-edges`: make edges boundary.

use crate::error::Problem;
use crate::ops::refs::{all, count};
use crate::ops::{Action, EdgeRef, Field, LocalEdit, Operation, SYMMETRY, Scope, Selected, Slot, Spec};
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Make edges boundary: the faces on either side come apart.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct RipEdges {
    /// The edges; the selected ones when left out.
    pub edges: Option<Vec<EdgeRef>>,
}

impl Operation for RipEdges {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "rip-edges",
        "Rip edges",
        "Make edges boundary: the faces on either side come apart.",
    )
    .synonyms(&["split edges", "detach", "tear"])
    .fields(&[Field::many("edges", Element::Edge, Selected::All, "The edges to rip"), SYMMETRY]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Edges(&mut self.edges)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for RipEdges {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_rip_edges(mesh, &all(&self.edges, "edges", mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::rip_edges(mesh, &all(&self.edges, "edges", mesh)?)?;
        Ok(())
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        count(&self.edges, mesh.edge_count())
    }
}
