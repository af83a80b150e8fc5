//! `set-face-color`: paints faces.

use super::fields::faces;
use super::{Action, FaceRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::edit::Refusal;
use halfedge::{Color, Element, FaceId, Mesh, keys};
use serde::{Deserialize, Serialize};

/// Paints faces.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SetFaceColor {
    /// The faces; the selected ones if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub faces: Option<Vec<FaceRef>>,
    /// The colour, as `#rrggbb`.
    pub color: String,
}

impl Operation for SetFaceColor {
    const SPEC: Spec = Spec {
        name: "set-face-color",
        label: "Paint faces",
        description: "Gives faces a colour.",
        key: None,
        kind: OperationKind::Local,
        fields: &[
            Field::new("faces", FieldKind::Faces, "The faces to paint").or("the selected faces"),
            Field::new("color", FieldKind::Color, "The colour as #rrggbb"),
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

impl SetFaceColor {
    fn found(&self, mesh: &Mesh) -> Result<(Vec<FaceId>, Color), Problem> {
        let color = Color::from_hex(&self.color).ok_or_else(|| {
            Problem::field("color", format!("{:?} is not a colour; write it as #rrggbb", self.color))
        })?;
        let faces = faces(&self.faces, mesh)?;
        if faces.is_empty() { Err(Refusal::NothingGiven(Element::Face).into()) } else { Ok((faces, color)) }
    }
}

impl LocalEdit for SetFaceColor {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        self.found(mesh).map(drop)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        let (faces, color) = self.found(mesh)?;
        for face in faces {
            mesh.set(keys::FACE_COLOR, face.index(), color);
        }
        Ok(())
    }

    fn cost(&self, _mesh: &Mesh) -> usize {
        self.faces.as_ref().map_or(0, Vec::len) / 16
    }
}
