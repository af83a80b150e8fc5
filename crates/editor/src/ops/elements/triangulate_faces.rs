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
use glam::DVec3;
use halfedge::edit::{Triangulated, Triangulation};
use halfedge::geometry::{BitSet, face_area_vector, mean_position};
use halfedge::{Element, FaceId, Mesh, Refusal, VertexId, edit};
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

impl TriangulateFaces {
    /// Cuts a face by the rule.
    fn cut(&self, mesh: &mut Mesh, face: FaceId) -> Result<Triangulated, Problem> {
        edit::triangulate_face(mesh, face, self.method.into()).map_err(|refusal| refused(face, &refusal))
    }

    /// Cuts a face by the rule, and its mirror image as in a mirror.
    fn cut_with_image(
        &self,
        mesh: &mut Mesh,
        mirror: &Mirror<'_>,
        face: FaceId,
        image: FaceId,
    ) -> Result<(), Problem> {
        for cut in self.cut(mesh, face)?.edges {
            let [a, b] = mesh.ends(cut).map(|v| mirror.images.vertex(v));
            if let (Some(a), Some(b)) = (a, b) {
                edit::connect_vertices(mesh, a, b).map_err(|refusal| refused(image, &refusal))?;
            }
        }
        Ok(())
    }

    /// Cuts a face that is its own mirror image: along the mirror's plane, or into a triangle across the plane and what
    /// remains on either side of it.
    fn cut_across(&self, mesh: &mut Mesh, mirror: &Mirror<'_>, face: FaceId) -> Result<(), Problem> {
        let corners: Vec<VertexId> = mesh.face_vertices(face).collect();
        if corners.len() == 3 {
            return Ok(());
        }
        let in_plane: Vec<VertexId> =
            corners.iter().copied().filter(|v| mirror.images.vertex(*v) == Some(*v)).collect();
        let connect = |mesh: &mut Mesh, a: VertexId, b: VertexId| {
            edit::connect_vertices(mesh, a, b).map_err(|refusal| refused(face, &refusal))
        };
        let halves = match *in_plane.as_slice() {
            [a, b] => {
                let cut = connect(mesh, a, b)?;
                [cut.face, cut.new_face]
            }
            [tip] => {
                // The side that crosses the plane.
                let crossing = mesh
                    .face_halfedges(face)
                    .find(|h| mirror.images.vertex(mesh.from(*h)) == Some(mesh.to(*h)))
                    .map(|h| [mesh.from(h), mesh.to(h)]);
                let Some([a, b]) = crossing.filter(|side| is_empty(mesh, face, [tip, side[0], side[1]]))
                else {
                    return Err(across(face));
                };
                let beside = |mesh: &Mesh, from: VertexId, to: VertexId| {
                    mesh.find_halfedge(from, to).and_then(|h| mesh.face_of(h.twin()))
                };
                connect(mesh, tip, a)?;
                connect(mesh, b, tip)?;
                match [beside(mesh, tip, a), beside(mesh, b, tip)] {
                    [Some(left), Some(right)] => [left, right],
                    _ => return Err(across(face)),
                }
            }
            _ => return Err(across(face)),
        };
        let [half, image] = halves;
        // The half on the positive side leads, whichever of the two has the smaller id.
        let place = |f: FaceId| place_across(mesh, f, mirror.images.axis());
        let [half, image] = if place(half) >= place(image) { [half, image] } else { [image, half] };
        self.cut_with_image(mesh, mirror, half, image)
    }
}

/// The coordinate of a face's middle along an axis.
fn place_across(mesh: &Mesh, face: FaceId, axis: usize) -> f64 {
    let middle = mean_position(mesh, mesh.face_vertices(face)).to_array();
    middle.get(axis).copied().unwrap_or_default()
}

/// Whether no corner of a face lies in a triangle between three of them.
fn is_empty(mesh: &Mesh, face: FaceId, triangle: [VertexId; 3]) -> bool {
    let normal = face_area_vector(mesh, face);
    let [a, b, c] = triangle;
    let is_left = |from: VertexId, to: VertexId, at: DVec3| {
        let [from, to] = [from, to].map(|v| mesh.position(v).as_dvec3());
        (to - from).cross(at - from).dot(normal) > 0.0
    };
    let others = mesh.face_vertices(face).filter(|v| !triangle.contains(v));
    !others
        .map(|v| mesh.position(v).as_dvec3())
        .any(|at| [[a, b], [b, c], [c, a]].into_iter().all(|[from, to]| is_left(from, to, at)))
}

/// Refuses a face that has no symmetric triangles.
fn across(face: FaceId) -> Problem {
    Problem::field(
        "faces",
        format!(
            "{face} lies across the mirror's plane, and no triangles between its corners are symmetric; poke it instead, or \
             turn symmetry off"
        ),
    )
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
        let place = |f: FaceId| place_across(mesh, f, axis);
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
            if let Some(image) = image {
                done.insert(image.index());
                self.cut_with_image(mesh, mirror, face, image)?;
            } else if mirror.images.face(mesh, face) == Some(face) {
                self.cut_across(mesh, mirror, face)?;
            } else {
                self.cut(mesh, face)?;
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

    fn cuts_faces(&self) -> bool {
        true
    }

    fn cost(&self, mesh: &Mesh) -> usize {
        corner_count(&self.faces, mesh)
    }
}

fn refused(face: FaceId, refusal: &Refusal) -> Problem {
    Problem::field("faces", format!("{face} can't be cut: {refusal}"))
}
