//! `set-face-color`: paint faces.

use crate::error::Problem;
use crate::ops::refs::{all, count};
use crate::ops::{
    Action, FaceRef, Field, FieldKind, LocalEdit, Operation, SYMMETRY, Scope, Selected, Slot, Spec,
};
use halfedge::edit::Refusal;
use halfedge::{Color, Element, FaceId, Mesh, keys};
use serde::{Deserialize, Serialize};

/// Paint faces with a colour.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct SetFaceColor {
    /// The faces; the selected ones when left out.
    pub faces: Option<Vec<FaceRef>>,
    /// The colour, as `#rrggbb`.
    pub color: String,
}

/// Painting a face is this much less work than linking one.
const FACES_PAINTED_PER_FACE_LINKED: usize = 16;

impl Operation for SetFaceColor {
    const SPEC: Spec =
        Spec::new(Scope::Elements, "set-face-color", "Paint faces", "Paint faces with a colour.")
            .synonyms(&["paint", "colour faces"])
            .fields(&[
                Field::many("faces", Element::Face, Selected::All, "The faces to paint"),
                Field::required("color", FieldKind::Color, "The colour as #rrggbb").labelled("Colour"),
                SYMMETRY,
            ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Faces(&mut self.faces)]
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
        let faces = all(&self.faces, "faces", mesh)?;
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
        count(&self.faces, 0) / FACES_PAINTED_PER_FACE_LINKED
    }
}
