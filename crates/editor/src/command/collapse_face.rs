//! `collapse-face`: the corners of a face made one vertex.

use super::fields::one;
use super::{Action, FaceRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Makes all corners of a face one vertex at its centroid.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CollapseFace {
    /// The face; the selected ones, one after the other, if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub face: Option<FaceRef>,
}

impl Operation for CollapseFace {
    const SPEC: Spec = Spec {
        name: "collapse-face",
        label: "Collapse face",
        description: "Makes all corners of a face one vertex at its centre.",
        key: None,
        kind: OperationKind::Local,
        fields: &[Field::new("face", FieldKind::Face, "The face to collapse").or("the selected faces")],
    };

    fields_by_serde!();

    fn resolve(self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        target.each_face(self, "face", |op| &mut op.face)
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for CollapseFace {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_collapse_face(mesh, one(self.face, "face")?.find(mesh, "face")?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::collapse_face(mesh, one(self.face, "face")?.find(mesh, "face")?)?;
        Ok(())
    }

    fn is_moot(&self, mesh: &Mesh) -> bool {
        self.face.is_some_and(|face| face.find(mesh, "face").is_err())
    }
}
