//! `poke-faces`: faces cut from their centres.

use super::fields::{face_count, faces};
use super::{Action, FaceRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::{Mesh, edit};
use serde::{Deserialize, Serialize};

/// Puts a vertex at the centroid of each face, joined to every corner.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PokeFaces {
    /// The faces; the selected ones if left out.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub faces: Option<Vec<FaceRef>>,
}

impl Operation for PokeFaces {
    const SPEC: Spec = Spec {
        name: "poke-faces",
        label: "Poke faces",
        description: "Puts a vertex at the centre of each face, joined to every corner.",
        key: None,
        kind: OperationKind::Local,
        fields: &[Field::new("faces", FieldKind::Faces, "The faces to poke").or("the selected faces")],
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

impl LocalEdit for PokeFaces {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        Ok(edit::can_poke_faces(mesh, &faces(&self.faces, mesh)?)?)
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        edit::poke_faces(mesh, &faces(&self.faces, mesh)?)?;
        Ok(())
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        face_count(&self.faces, mesh)
    }
}
