//! `inset-faces`: a ring inside the outline of faces.

use super::fields::{face_count, faces};
use super::live::{MODE_NAMES, Mode, not_negative, slide};
use super::{Action, FaceRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Puts a ring of quads inside the outline of faces.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct InsetFaces {
    /// The faces; the selected ones if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub faces: Option<Vec<FaceRef>>,
    /// How wide the ring is, in mesh units, 0 or more.
    #[serde(with = "crate::json::finite")]
    pub amount: f32,
    /// Whether faces that share an edge stay together.
    #[serde(default)]
    pub mode: Mode,
}

impl Operation for InsetFaces {
    const SPEC: Spec = Spec {
        name: "inset-faces",
        label: "Inset faces",
        description: "Puts a ring of quads inside the outline of faces.",
        key: None,
        kind: OperationKind::Local,
        fields: &[
            Field::new("faces", FieldKind::Faces, "The faces to inset").or("the selected faces"),
            Field::new(
                "amount",
                FieldKind::Number { min: 0.0, max: f32::MAX },
                "How wide the ring is, in mesh units",
            ),
            Field::new(
                "mode",
                FieldKind::Choice(MODE_NAMES),
                "Whether faces that share an edge stay together",
            )
            .or("\"region\""),
        ],
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

impl LocalEdit for InsetFaces {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        not_negative(self.amount, "amount")?;
        Ok(edit::can_inset_faces(mesh, &faces(&self.faces, mesh)?, self.mode.into())?)
    }

    fn edit(&self, mesh: &mut Mesh, notes: &mut Vec<String>) -> Result<(), Problem> {
        not_negative(self.amount, "amount")?;
        let live = edit::inset_faces(mesh, &faces(&self.faces, mesh)?, self.mode.into())?;
        slide(mesh, &live, self.amount, "amount", notes)
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        face_count(&self.faces, mesh)
    }
}
