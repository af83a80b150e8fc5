//! `flip-orientation`: pieces turned inside out.

use super::fields::{face_count, faces_or_all};
use super::{Action, FaceRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Turns whole connected pieces inside out.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct FlipOrientation {
    /// The faces of whole pieces; the selected ones if left out, or all where none is selected.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub faces: Option<Vec<FaceRef>>,
}

impl Operation for FlipOrientation {
    const SPEC: Spec = Spec {
        name: "flip-orientation",
        label: "Flip orientation",
        description: "Turns whole connected pieces inside out.",
        key: None,
        kind: OperationKind::Local,
        fields: &[Field::new("faces", FieldKind::Faces, "The faces of whole pieces")
            .or("the selected faces, or all")],
    };

    fields_by_serde!();

    fn resolve(mut self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        target.fill_faces_or_all(&mut self.faces)?;
        Ok(vec![self])
    }

    fn is_for_whole_meshes(&self) -> bool {
        self.faces.is_none()
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for FlipOrientation {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_flip_orientation(mesh, &faces_or_all(&self.faces, mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::flip_orientation(mesh, &faces_or_all(&self.faces, mesh)?)?;
        Ok(())
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        face_count(&self.faces, mesh)
    }
}
