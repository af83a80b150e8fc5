//! `delete-faces`: faces taken away.

use super::fields::{face_count, faces};
use super::{Action, FaceRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Takes faces away, and vertices left with no face.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct DeleteFaces {
    /// The faces; the selected ones if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub faces: Option<Vec<FaceRef>>,
}

impl Operation for DeleteFaces {
    const SPEC: Spec = Spec {
        name: "delete-faces",
        label: "Delete faces",
        description: "Takes faces away, and vertices left with no face.",
        key: None,
        kind: OperationKind::Local,
        fields: &[Field::new("faces", FieldKind::Faces, "The faces to delete").or("the selected faces")],
    };

    fields_by_serde!();

    fn resolve(mut self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        target.fill_faces(&mut self.faces, "faces")?;
        Ok(vec![self])
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for DeleteFaces {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_delete_faces(mesh, &faces(&self.faces, mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::delete_faces(mesh, &faces(&self.faces, mesh)?)?;
        Ok(())
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        face_count(&self.faces, mesh)
    }
}
