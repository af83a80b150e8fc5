//! `extrude-edges`: add quads beside boundary edges.

use super::sized::set_size;
use crate::error::Problem;
use crate::ops::refs::{ElementRef, all, count};
use crate::ops::{
    Action, edges_between_created, Drag, EdgeRef, Family, Field, FieldKind, LocalEdit, Operation, Scope, Selected, Slot, Spec,
};
use crate::outcome::ElementIds;
use crate::selection::Selection;
use halfedge::{EdgeId, Element, Mesh, edit};
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

    fn from_selection(mut ops: Vec<Self>, mesh: &Mesh) -> Vec<Self> {
        // Of a selection that reaches into the surface, the edges on the boundary are extruded.
        for edges in ops.iter_mut().filter_map(|op| op.edges.as_mut()) {
            let is_boundary = |edge: &EdgeRef| edge.find(mesh, "edges").is_ok_and(|e| mesh.is_boundary_edge(e));
            if edges.iter().any(is_boundary) {
                edges.retain(is_boundary);
            }
        }
        ops
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

    fn selects(&self, mesh: &Mesh, created: &ElementIds) -> Option<Selection> {
        // The far sides: the edges beside the quads have an old end.
        let far = edges_between_created(mesh, created);
        Some(Selection::of(Element::Edge, far.into_iter().map(EdgeId::raw)))
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        count(&self.edges, mesh.edge_count())
    }
}
