//! `collapse-face`: merge the corners of a face.

use crate::error::Problem;
use crate::ops::refs::one;
use crate::ops::{Action, FaceRef, Field, LocalEdit, Operation, SYMMETRY, Scope, Selected, Slot, Spec};
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Merge all corners of a face into one vertex at its centroid.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct CollapseFace {
    /// The face; each selected one in turn when left out.
    pub face: Option<FaceRef>,
}

impl Operation for CollapseFace {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "collapse-face",
        "Collapse face",
        "Merge all corners of a face into one vertex at its centre.",
    )
    .fields(&[Field::one("face", Element::Face, Selected::Each, "The face to collapse"), SYMMETRY]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Face(&mut self.face)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for CollapseFace {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_collapse_face(mesh, one(self.face, "face", mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::collapse_face(mesh, one(self.face, "face", mesh)?)?;
        Ok(())
    }

    fn is_moot(&self, mesh: &Mesh) -> bool {
        one(self.face, "face", mesh).is_err()
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        1
    }
}
