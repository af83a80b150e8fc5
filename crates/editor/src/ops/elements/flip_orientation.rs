//! `flip-orientation`: turn connected pieces inside out.

use crate::error::Problem;
use crate::ops::refs::{count, faces_or_every};
use crate::ops::{Action, FaceRef, Field, LocalEdit, Operation, SYMMETRY, Scope, Selected, Slot, Spec};
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Turn whole connected pieces inside out.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct FlipOrientation {
    /// The faces of whole pieces; the selected ones when left out, or all where none is selected.
    pub faces: Option<Vec<FaceRef>>,
}

impl Operation for FlipOrientation {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "flip-orientation",
        "Flip orientation",
        "Turn whole connected pieces inside out.",
    )
    .synonyms(&["flip normals", "reverse normals"])
    .fields(&[
        Field::many("faces", Element::Face, Selected::AllOrEvery, "The faces of whole connected pieces"),
        SYMMETRY,
    ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Faces(&mut self.faces)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for FlipOrientation {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_flip_orientation(mesh, &faces_or_every(&self.faces, mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::flip_orientation(mesh, &faces_or_every(&self.faces, mesh)?)?;
        Ok(())
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        count(&self.faces, mesh.face_count())
    }
}
