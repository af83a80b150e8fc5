//! `slide-edges`: move lines of edges along their neighbours.

use super::sized::{nothing_moved, slide_amount};
use crate::error::Problem;
use crate::ops::refs::{all, count};
use crate::ops::{
    Action, EdgeRef, Family, Field, LocalEdit, Mirroring, Operation, Reflection, SYMMETRY, Scope, Selected,
    Slot, Spec,
};
use halfedge::{EdgeId, Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Slide lines of edges over the surface, along the edges beside them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SlideEdges {
    /// The edges, which form lines without branches; the selected ones when left out. The first says which side is left: that
    /// of the way from the vertex named first to the other, or of its even half-edge, seen from outside.
    pub edges: Option<Vec<EdgeRef>>,
    /// How far they go: 1 is to the neighbours on the left, -1 to those on the right.
    #[serde(with = "crate::script::json::finite")]
    pub amount: f32,
}

impl Operation for SlideEdges {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "slide-edges",
        "Slide edges",
        "Move lines of edges over the surface, along the edges beside them.",
    )
    .synonyms(&["edge slide", "slide edge tool"])
    .family(Family::Slide)
    .fields(&[
        Field::many(
            "edges",
            Element::Edge,
            Selected::All,
            "The edges, in lines that don't branch; left is that of the first edge's direction",
        ),
        slide_amount("How far: 1 is to the neighbours on the left, -1 to those on the right"),
        SYMMETRY,
    ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Edges(&mut self.edges)]
    }

    const MIRRORING: Mirroring = Mirroring::Moves;

    fn reflect(&mut self, reflection: Reflection) {
        // The image of the left side is the right side of the image.
        if !reflection.reversed {
            self.amount = -self.amount;
        }
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl SlideEdges {
    /// The edges, and the amount to the left of the first one's even half-edge.
    fn given(&self, mesh: &Mesh) -> Result<(Vec<EdgeId>, f32), Problem> {
        let edges = all(&self.edges, "edges", mesh)?;
        let first = self.edges.as_deref().and_then(<[_]>::first);
        let reversed = match (first, edges.first()) {
            (Some(EdgeRef::Ends([from, _])), Some(edge)) => mesh.from(edge.halfedge()).raw() != *from,
            _ => false,
        };
        Ok((edges, if reversed { -self.amount } else { self.amount }))
    }
}

impl LocalEdit for SlideEdges {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        let (edges, amount) = self.given(mesh)?;
        Ok(edit::can_slide_edges(mesh, &edges, amount)?)
    }

    fn edit(&self, mesh: &mut Mesh, notes: &mut Vec<String>) -> Result<(), Problem> {
        let (edges, amount) = self.given(mesh)?;
        let moved = edit::slide_edges(mesh, &edges, amount)?;
        notes.extend(nothing_moved(moved, amount, "there are no faces on that side"));
        Ok(())
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        count(&self.edges, mesh.edge_count())
    }
}
