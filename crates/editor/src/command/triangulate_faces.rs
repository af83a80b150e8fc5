//! `triangulate-faces`: polygons cut into triangles.

use super::fields::{face_count, faces_or_all};
use super::{Action, FaceRef, Field, FieldKind, LocalEdit, Operation, OperationKind, Spec, Target};
use crate::error::Problem;
use halfedge::edit::Triangulation;
use halfedge::{FaceId, Mesh, Refusal, edit};
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
    /// By cutting off ears: right on concave faces too.
    Ear,
}

impl From<Method> for Triangulation {
    fn from(method: Method) -> Self {
        match method {
            Method::Fan => Self::Fan,
            Method::Ear => Self::Ears,
        }
    }
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
            Field::new(
                "method",
                FieldKind::Choice(&["fan", "ear"]),
                "A fan from the first corner, or ears, which are right on concave faces too",
            )
            .or("\"fan\""),
        ],
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

impl LocalEdit for TriangulateFaces {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        faces_or_all(&self.faces, mesh)?.into_iter().try_for_each(|face| {
            edit::can_triangulate_face(mesh, face, self.method.into()).map_err(|refusal| refused(face, &refusal))
        })
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        faces_or_all(&self.faces, mesh)?.into_iter().try_for_each(|face| {
            edit::triangulate_face(mesh, face, self.method.into()).map(drop).map_err(|refusal| refused(face, &refusal))
        })
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        face_count(&self.faces, mesh)
    }
}

fn refused(face: FaceId, refusal: &Refusal) -> Problem {
    Problem::field("faces", format!("{face} can't be cut: {refusal}"))
}
