//! `inset-faces`: add a ring of quads inside the outline of faces.

use super::sized::{Mode, set_size};
use crate::error::Problem;
use crate::ops::refs::{all, corner_count};
use crate::ops::{
    Action, Drag, FaceRef, Field, LocalEdit, Operation, SYMMETRY, Scope, Selected, Slot, Spec, Unit,
};
use halfedge::{Element, Mesh, NumberRange, edit};
use serde::{Deserialize, Serialize};

/// Add a ring of quads inside the outline of faces.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct InsetFaces {
    /// The faces; the selected ones when left out.
    pub faces: Option<Vec<FaceRef>>,
    /// The width of the ring, in mesh units, 0 or more.
    #[serde(with = "crate::script::json::finite")]
    pub amount: f32,
    /// Whether faces that share an edge stay together.
    pub mode: Mode,
}

impl Operation for InsetFaces {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "inset-faces",
        "Inset faces",
        "Add a ring of quads inside the outline of faces.",
    )
    .synonyms(&["offset faces"])
    .fields(&[
        Field::many("faces", Element::Face, Selected::All, "The faces to inset"),
        Field::number(
            "amount",
            Unit::Length,
            NumberRange::NOT_NEGATIVE,
            "The width of the ring, in mesh units",
        )
        .drag(Drag::Width),
        Mode::field("mode", "Whether faces that share an edge stay together"),
        SYMMETRY,
    ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Faces(&mut self.faces)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for InsetFaces {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_inset_faces(mesh, &all(&self.faces, "faces", mesh)?, self.mode.into())?)
    }

    fn edit(&self, mesh: &mut Mesh, notes: &mut Vec<String>) -> Result<(), Problem> {
        let live = edit::inset_faces(mesh, &all(&self.faces, "faces", mesh)?, self.mode.into())?;
        set_size(mesh, &live, self.amount, "amount", notes)
    }

    fn cuts_faces(&self) -> bool {
        true
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        corner_count(&self.faces, mesh)
    }
}
