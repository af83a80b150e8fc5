//! `fill-hole`: close a boundary loop with a polygon.

use crate::error::Problem;
use crate::ops::refs::one;
use crate::ops::{Action, Field, HalfedgeRef, LocalEdit, Operation, SYMMETRY, Scope, Selected, Slot, Spec};
use halfedge::edit::Refusal;
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Close a boundary loop with one polygon.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FillHole {
    /// A half-edge of the loop; those of the selected half-edges or edges when left out.
    pub halfedge: Option<HalfedgeRef>,
}

impl Operation for FillHole {
    const SPEC: Spec =
        Spec::new(Scope::Elements, "fill-hole", "Fill hole", "Close a boundary loop with one polygon.")
            .synonyms(&["cap", "make face", "close hole"])
            .fields(&[
                Field::one("halfedge", Element::Halfedge, Selected::Each, "A half-edge of the boundary loop"),
                SYMMETRY,
            ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Halfedge(&mut self.halfedge)]
    }

    fn from_selection(mut ops: Vec<Self>, mesh: &Mesh) -> Result<Vec<Self>, Problem> {
        // Of a selection that reaches into the surface, the holes beside it are filled.
        let is_boundary =
            |op: &Self| one(op.halfedge, "halfedge", mesh).is_ok_and(|h| mesh.is_boundary_halfedge(h));
        if ops.iter().any(is_boundary) {
            ops.retain(is_boundary);
        } else if ops.len() > 1 {
            return Err(Problem::new("no selected edge is on a boundary"));
        }
        Ok(ops)
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for FillHole {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        let side = one(self.halfedge, "halfedge", mesh)?;
        Ok(edit::can_fill_hole(mesh, side).map_err(|refusal| of_edge(refusal, mesh))?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let side = one(self.halfedge, "halfedge", mesh)?;
        edit::fill_hole(mesh, side).map_err(|refusal| of_edge(refusal, mesh))?;
        Ok(())
    }

    fn is_moot(&self, mesh: &Mesh) -> bool {
        // Another half-edge of the same loop came first.
        one(self.halfedge, "halfedge", mesh).is_ok_and(|h| !mesh.is_boundary_halfedge(h))
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        1
    }
}

/// Speaks of the edge where neither of its sides is on the boundary: it may be what was selected.
fn of_edge(refusal: Refusal, mesh: &Mesh) -> Refusal {
    match refusal {
        Refusal::NotABoundaryHalfedge(h) if !mesh.is_boundary_edge(h.edge()) => {
            Refusal::NotOnBoundary(h.edge())
        }
        other => other,
    }
}
