//! `bevel-edges`: replace each edge by a strip of faces.

use super::sized::set_size;
use crate::error::Problem;
use crate::ops::refs::{all, count};
use crate::ops::{
    Action, DefaultValue, Drag, EdgeRef, Family, Field, LocalEdit, Operation, SYMMETRY, Scope, Selected,
    Slot, Spec, Unit,
};
use crate::outcome::ElementIds;
use crate::selection::Selection;
use halfedge::{Element, Mesh, NumberRange, edit};
use serde::{Deserialize, Serialize};

/// Replace each edge by a strip of faces.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct BevelEdges {
    /// The edges; the selected ones when left out.
    pub edges: Option<Vec<EdgeRef>>,
    /// How far the strip goes on each side, in mesh units, 0 or more.
    #[serde(with = "crate::script::json::finite")]
    pub width: f32,
    /// The number of faces across the strip.
    pub segments: u32,
}

impl Operation for BevelEdges {
    const SPEC: Spec =
        Spec::new(Scope::Elements, "bevel-edges", "Bevel edges", "Replace each edge by a strip of faces.")
            .synonyms(&["chamfer", "fillet", "round"])
            .family(Family::Bevel)
            .fields(&[
                Field::many("edges", Element::Edge, Selected::All, "The edges to bevel"),
                Field::number(
                    "width",
                    Unit::Length,
                    NumberRange::NOT_NEGATIVE,
                    "The width on each side of the edge, in mesh units",
                )
                .drag(Drag::Width),
                Field::count("segments", edit::BEVEL_SEGMENTS_RANGE, "The number of faces across the strip")
                    .or(DefaultValue::Integer(1)),
                SYMMETRY,
            ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Edges(&mut self.edges)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for BevelEdges {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_bevel_edges(mesh, &all(&self.edges, "edges", mesh)?, self.segments)?)
    }

    fn edit(&self, mesh: &mut Mesh, notes: &mut Vec<String>) -> Result<(), Problem> {
        let live = edit::bevel_edges(mesh, &all(&self.edges, "edges", mesh)?, self.segments)?;
        set_size(mesh, &live, self.width, "width", notes)
    }

    fn selects(&self, _mesh: &Mesh, created: &ElementIds) -> Option<Selection> {
        Some(Selection::of(Element::Face, created.faces.iter().copied()))
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        // The strips, and at each end a face with as many corners.
        let edges = count(&self.edges, mesh.edge_count());
        edges.saturating_mul(self.segments as usize).saturating_add(edges.saturating_mul(2))
    }
}
