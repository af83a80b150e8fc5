//! `delete-faces`: delete faces.

use crate::error::Problem;
use crate::ops::refs::{all, count};
use crate::ops::{
    Action, FaceRef, Family, Field, LocalEdit, Operation, SYMMETRY, Scope, Selected, Slot, Spec,
};
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Delete faces, and vertices that are left with no face.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct DeleteFaces {
    /// The faces; the selected ones when left out.
    pub faces: Option<Vec<FaceRef>>,
}

impl Operation for DeleteFaces {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "delete-faces",
        "Delete faces",
        "Delete faces, and vertices that are left with no face.",
    )
    .synonyms(&["erase", "remove faces"])
    .family(Family::Delete)
    .fields(&[Field::many("faces", Element::Face, Selected::All, "The faces to delete"), SYMMETRY]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Faces(&mut self.faces)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for DeleteFaces {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_delete_faces(mesh, &all(&self.faces, "faces", mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::delete_faces(mesh, &all(&self.faces, "faces", mesh)?)?;
        Ok(())
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        count(&self.faces, mesh.face_count())
    }
}
