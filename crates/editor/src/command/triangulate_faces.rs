//! `triangulate-faces`: polygons cut into triangles.

use super::fields::find_all;
use super::{Action, FaceRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::{Element, Mesh, edit};
use serde::{Deserialize, Serialize};

/// Cuts polygons into triangles.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TriangulateFaces {
    /// The faces; the selected ones if left out, or all where none is selected.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub faces: Option<Vec<FaceRef>>,
    /// How.
    #[serde(default)]
    pub method: Method,
}

/// How a polygon is cut into triangles.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Method {
    /// A fan from the face's first corner.
    #[default]
    Fan,
}

impl Operation for TriangulateFaces {
    const SPEC: Spec = Spec {
        name: "triangulate-faces",
        label: "Triangulate",
        description: "Cuts polygons into triangles between their own corners.",
        key: None,
        kind: OperationKind::Local,
        fields: &[
            Field::new("faces", FieldKind::Faces, "The faces to cut").or("the selected faces, or all"),
            Field::new("method", FieldKind::Choice(&["fan"]), "A fan from the first corner").or("\"fan\""),
        ],
    };

    fields_by_serde!();

    fn resolve(mut self, target: &Target<'_>) -> Result<Vec<Self>, Problem> {
        if self.faces.is_none() && target.selection.kind() == Element::Face && !target.selection.is_empty() {
            self.faces = Some(target.selection.ids().map(FaceRef).collect());
        }
        Ok(vec![self])
    }

    fn is_for_whole_meshes(&self) -> bool {
        self.faces.is_none()
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for TriangulateFaces {
    fn edit(&self, mesh: &mut Mesh) -> Result<(), Problem> {
        let faces = match &self.faces {
            Some(list) => find_all(list, "faces", |face, field| face.find(mesh, field))?,
            None => mesh.faces().collect(),
        };
        for face in faces {
            edit::triangulate_face(mesh, face)
                .map_err(|refusal| Problem::field("faces", format!("{face} can't be cut: {refusal}")))?;
        }
        Ok(())
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        self.faces.as_ref().map_or(mesh.face_count(), Vec::len)
    }
}
