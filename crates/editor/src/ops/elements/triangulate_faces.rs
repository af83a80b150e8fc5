//! `triangulate-faces`: cut polygons into triangles.

use crate::error::Problem;
use crate::ops::choice::choice;
use crate::ops::refs::{corner_count, faces_or_every};
use crate::ops::with_pieces;
use crate::ops::{
    Action, FaceRef, Field, LocalEdit, Mirror, Operation, SYMMETRY, Scope, Selected, Slot, Spec,
};
use crate::outcome::ElementIds;
use crate::selection::Selection;
use halfedge::edit::Triangulation;
use halfedge::geometry::{BitSet, mean_position};
use halfedge::{Element, FaceId, Mesh, Refusal, edit};
use serde::{Deserialize, Serialize};

/// Cut polygons into triangles between their own corners.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct TriangulateFaces {
    /// The faces; the selected ones when left out, or all where none is selected.
    pub faces: Option<Vec<FaceRef>>,
    /// How.
    pub method: Method,
}

choice! {
    /// How a polygon is cut into triangles.
    pub enum Method {
        /// A fan from the face's first corner where that is right, else ears.
        Auto = "auto" "Automatic",
        /// A fan from the face's first corner.
        Fan = "fan" "Fan",
        /// By cutting off ears: right on concave faces too.
        Ear = "ear" "Ears",
    }
}

impl From<Method> for Triangulation {
    fn from(method: Method) -> Self {
        match method {
            Method::Auto => Self::Auto,
            Method::Fan => Self::Fan,
            Method::Ear => Self::Ears,
        }
    }
}

impl Operation for TriangulateFaces {
    const SPEC: Spec = Spec::new(
        Scope::Elements,
        "triangulate-faces",
        "Triangulate",
        "Cut polygons into triangles between their own corners.",
    )
    .synonyms(&["triangulate"])
    .fields(&[
        Field::many("faces", Element::Face, Selected::AllOrEvery, "The faces to cut"),
        Method::field(
            "method",
            "A fan from the first corner if that is correct, else ears; or always one of the two",
        ),
        SYMMETRY,
    ]);

    fn elements(&mut self) -> Vec<Slot<'_>> {
        vec![Slot::Faces(&mut self.faces)]
    }

    fn action(&self) -> Action<'_> {
        Action::Local(self)
    }
}

impl LocalEdit for TriangulateFaces {
    fn can(&self, mesh: &Mesh) -> Result<(), Problem> {
        faces_or_every(&self.faces, mesh)?.into_iter().try_for_each(|face| {
            edit::can_triangulate_face(mesh, face, self.method.into())
                .map_err(|refusal| refused(face, &refusal))
        })
    }

    fn edit(&self, mesh: &mut Mesh, _notes: &mut Vec<String>) -> Result<(), Problem> {
        faces_or_every(&self.faces, mesh)?.into_iter().try_for_each(|face| {
            edit::triangulate_face(mesh, face, self.method.into())
                .map(drop)
                .map_err(|refusal| refused(face, &refusal))
        })
    }

    fn edit_mirrored(
        &self,
        mesh: &mut Mesh,
        mirror: &Mirror<'_>,
        _notes: &mut Vec<String>,
    ) -> Result<(), Problem> {
        let axis = mirror.images.axis();
        let faces = faces_or_every(&self.faces, mesh)?;
        let middle = |f: FaceId| mean_position(mesh, mesh.face_vertices(f)).to_array();
        let place = |f: FaceId| middle(f).get(axis).copied().unwrap_or_default();
        // The face on the positive side is cut by the rule, the one at its mirror image as in a mirror.
        let pairs: Vec<(FaceId, Option<FaceId>)> = faces
            .into_iter()
            .map(|face| (face, mirror.images.face(mesh, face).filter(|image| *image != face)))
            .filter(|(face, image)| image.is_none_or(|image| place(*face) >= place(image)))
            .collect();
        let mut done: BitSet = BitSet::new();
        for (face, image) in pairs {
            if done.contains(face.index()) {
                continue;
            }
            let made = edit::triangulate_face(mesh, face, self.method.into());
            let made = made.map_err(|refusal| refused(face, &refusal))?;
            let Some(image) = image else { continue };
            done.insert(image.index());
            for cut in made.edges {
                let [a, b] = mesh.ends(cut).map(|v| mirror.images.vertex(v));
                if let (Some(a), Some(b)) = (a, b) {
                    edit::connect_vertices(mesh, a, b).map_err(|refusal| refused(image, &refusal))?;
                }
            }
        }
        Ok(())
    }

    fn changes_nothing(&self, mesh: &Mesh) -> Option<&'static str> {
        let is_triangle = |f: FaceId| mesh.face_halfedges(f).take(4).count() == 3;
        match &self.faces {
            None if mesh.face_count() == 0 => Some("The mesh has no face."),
            None => mesh.faces().all(is_triangle).then_some("All faces are triangles already."),
            Some(faces) => faces
                .iter()
                .filter_map(|face| mesh.face(face.0))
                .all(is_triangle)
                .then_some("The selected faces are triangles already."),
        }
    }

    fn selects(&self, mesh: &Mesh, created: &ElementIds) -> Option<Selection> {
        Some(with_pieces(mesh, self.faces.as_ref()?, created))
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        corner_count(&self.faces, mesh)
    }
}

fn refused(face: FaceId, refusal: &Refusal) -> Problem {
    Problem::field("faces", format!("{face} can't be cut: {refusal}"))
}
