//! `extrude-faces`: faces moved outward, with walls.

use super::fields::{face_count, faces};
use super::live::{MODE_NAMES, Mode, slide};
use super::{Action, FaceRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Moves faces outward and puts walls where they were.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ExtrudeFaces {
    /// The faces; the selected ones if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub faces: Option<Vec<FaceRef>>,
    /// How far outward, in mesh units; negative goes inward.
    #[serde(with = "crate::json::finite")]
    pub distance: f32,
    /// Whether faces that share an edge stay together.
    #[serde(default)]
    pub mode: Mode,
}

impl Operation for ExtrudeFaces {
    const SPEC: Spec = Spec {
        name: "extrude-faces",
        label: "Extrude faces",
        description: "Moves faces outward and puts walls where they were.",
        key: None,
        kind: OperationKind::Local,
        fields: &[
            Field::new("faces", FieldKind::Faces, "The faces to extrude").or("the selected faces"),
            Field::new(
                "distance",
                FieldKind::Number { min: f32::MIN, max: f32::MAX },
                "How far outward, in mesh units",
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

impl LocalEdit for ExtrudeFaces {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_extrude_faces(mesh, &faces(&self.faces, mesh)?, self.mode.into())?)
    }

    fn edit(&self, mesh: &mut Mesh, notes: &mut Vec<String>) -> Result<(), Problem> {
        let live = edit::extrude_faces(mesh, &faces(&self.faces, mesh)?, self.mode.into())?;
        slide(mesh, &live, self.distance, "distance", notes)
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        face_count(&self.faces, mesh)
    }
}
