//! `fill-hole`: close a boundary loop with a polygon.

use crate::error::Problem;
use crate::ops::refs::one;
use crate::ops::{Action, Field, HalfedgeRef, LocalEdit, Operation, Scope, Selected, Slot, Spec};
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Close a boundary loop with one polygon.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FillHole {
    /// A half-edge of the loop; those of the selected half-edges or edges when left out.
    pub halfedge: Option<HalfedgeRef>,
}

impl Operation for FillHole {
    const SPEC: Spec =
        Spec::new(Scope::Elements, "fill-hole", "Fill hole", "Close a boundary loop with one polygon.")
            .synonyms(&["cap", "make face", "close hole"])
            .fields(&[Field::one(
                "halfedge",
                Element::Halfedge,
                Selected::Each,
                "A half-edge of the boundary loop",
            )]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Halfedge(&mut self.halfedge)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for FillHole {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_fill_hole(mesh, one(self.halfedge, "halfedge", mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::fill_hole(mesh, one(self.halfedge, "halfedge", mesh)?)?;
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
