//! `dissolve-edge`: remove edges and merge their faces.

use crate::error::Problem;
use crate::ops::refs::{all, count, one};
use crate::ops::{
    Action, DefaultValue as Or, EdgeRef, Family, Field, FieldKind, LocalEdit, Operation, SYMMETRY, Scope,
    Selected, Slot, Spec,
};
use halfedge::{EdgeId, Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Remove edges and merge the faces beside them into one polygon.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct DissolveEdge {
    /// One edge.
    pub edge: Option<EdgeRef>,
    /// Several edges, dissolved together; the selected ones when both are left out.
    pub edges: Option<Vec<EdgeRef>>,
    /// Whether vertices that are left with two edges stay.
    pub keep_vertices: bool,
}

impl DissolveEdge {
    fn find(&self, mesh: &Mesh) -> Result<Vec<EdgeId>, Problem> {
        let mut edges = all(&self.edges, "edges", mesh)?;
        if self.edge.is_some() || self.edges.is_none() {
            edges.push(one(self.edge, "edge", mesh)?);
        }
        Ok(edges)
    }
}

impl Operation for DissolveEdge {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "dissolve-edge",
        "Dissolve edge",
        "Remove edges and merge the faces beside them into one polygon.",
    )
    .synonyms(&["remove edge"])
    .family(Family::Delete)
    .also(Family::Dissolve)
    .fields(&[
        Field::one("edge", Element::Edge, Selected::Each, "The edge to dissolve")
            .optional("those of `edges`"),
        Field::many("edges", Element::Edge, Selected::All, "The edges to dissolve together"),
        Field::required(
            "keep_vertices",
            FieldKind::Flag,
            "Whether vertices that are left with two edges stay",
        )
        .or(Or::Flag(false)),
        SYMMETRY,
    ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Edge(&mut self.edge), Slot::Edges(&mut self.edges)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for DissolveEdge {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_dissolve_edges(mesh, &self.find(mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::dissolve_edges(mesh, &self.find(mesh)?, self.keep_vertices)?;
        Ok(())
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        count(&self.edges, 1)
    }
}
