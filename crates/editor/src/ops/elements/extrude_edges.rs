//! `extrude-edges`: add quads beside boundary edges.

use super::sized::set_size;
use crate::error::Problem;
use crate::ops::refs::{all, count};
use crate::ops::{
    Action, Drag, EdgeRef, Family, Field, FieldKind, LocalEdit, Operation, Scope, Selected, Slot, Spec,
};
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Add a quad beside each of some boundary edges.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ExtrudeEdges {
    /// The boundary edges; the selected ones when left out.
    pub edges: Option<Vec<EdgeRef>>,
    /// From the edges to the far sides of the quads, in mesh units.
    #[serde(with = "crate::script::json::finite3")]
    pub offset: [f32; 3],
}

impl Operation for ExtrudeEdges {
    const SPEC: Spec =
        Spec::new(Scope::Elements, "extrude-edges", "Extrude edges", "Add a quad beside each boundary edge.")
            .family(Family::Extrude)
            .fields(&[
                Field::many("edges", Element::Edge, Selected::All, "The boundary edges to extrude"),
                Field::required(
                    "offset",
                    FieldKind::Vector,
                    "From the edges to the far sides, in mesh units",
                )
                .drag(Drag::Offset),
            ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Edges(&mut self.edges)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for ExtrudeEdges {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_extrude_edges(mesh, &all(&self.edges, "edges", mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, notes: &mut Vec<String>) -> Result<(), Problem> {
        let live = edit::extrude_edges(mesh, &all(&self.edges, "edges", mesh)?, self.offset.into())?;
        set_size(mesh, &live, 1.0, "offset", notes)
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        count(&self.edges, mesh.edge_count())
    }
}
