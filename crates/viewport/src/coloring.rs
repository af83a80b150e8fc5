//! The colours of faces: which of a mesh's colours its corners show.

use glam::Vec3;
use halfedge::{Color, Element, FaceId, Mesh, VertexId, keys};
use std::collections::HashMap;

/// What gives faces their colours.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum ColorBy {
    /// Painted faces show their paint, the others the colours of their vertices where the mesh has them, or else
    /// their material's.
    #[default]
    Paint,
    /// Every face shows its own colour.
    Face,
    /// Every face shows the colours of its vertices.
    Vertex,
    /// All faces are as if unpainted.
    Uniform,
}

impl ColorBy {
    /// All, in the order of menus.
    pub const ALL: [Self; 4] = [Self::Paint, Self::Face, Self::Vertex, Self::Uniform];

    /// The name in scripts.
    pub fn name(self) -> &'static str {
        match self {
            Self::Paint => "paint",
            Self::Face => "face",
            Self::Vertex => "vertex",
            Self::Uniform => "uniform",
        }
    }
}

/// The colours of the document's materials by name. A face in its material's colour isn't painted.
pub type MaterialColors = HashMap<String, Color>;

/// The colours of a mesh's corners.
#[derive(Clone, Debug, Default)]
pub struct Coloring {
    by: ColorBy,
    /// The colour of each label of the mesh's materials; none for a material that the document doesn't have.
    materials: Vec<Option<Color>>,
}

impl Coloring {
    /// How a mesh is coloured. Costs O(material labels).
    pub fn new(mesh: &Mesh, by: ColorBy, materials: &MaterialColors) -> Self {
        let labels = mesh.column(Element::Face, keys::FACE_MATERIAL.name).map_or(&[][..], |c| &c.labels);
        Self { by, materials: labels.iter().map(|label| materials.get(label).copied()).collect() }
    }

    /// What gives the colours.
    pub fn by(&self) -> ColorBy {
        self.by
    }

    /// Whether a face's colour was chosen for it, rather than for its material.
    fn is_painted(&self, mesh: &Mesh, face: FaceId, color: Color) -> bool {
        let material = mesh.get(keys::FACE_MATERIAL, face.index()) as usize;
        let unpainted = self.materials.get(material).copied().flatten().unwrap_or(Color::UNPAINTED);
        color != unpainted
    }

    /// The colours of one face.
    pub(crate) fn face<'m>(&self, mesh: &'m Mesh, columns: &Columns<'m>, face: FaceId) -> FaceColors<'m> {
        let own = columns.faces.and_then(|colors| colors.get(face.index()).copied());
        let own = own.unwrap_or(Color::UNPAINTED);
        match self.by {
            ColorBy::Uniform => FaceColors { face: Color::UNPAINTED, vertices: None },
            ColorBy::Face => FaceColors { face: own, vertices: None },
            ColorBy::Vertex => FaceColors { face: Color::UNPAINTED, vertices: columns.vertices },
            ColorBy::Paint => {
                let vertices = columns.vertices.filter(|_| !self.is_painted(mesh, face, own));
                FaceColors { face: own, vertices }
            }
        }
    }
}

/// The columns of a mesh that colours come from, looked up once.
#[derive(Clone, Copy)]
pub(crate) struct Columns<'m> {
    faces: Option<&'m [Color]>,
    vertices: Option<&'m [Vec3]>,
}

impl<'m> Columns<'m> {
    pub fn new(mesh: &'m Mesh) -> Self {
        Self { faces: mesh.attribute(keys::FACE_COLOR), vertices: mesh.attribute(keys::VERTEX_COLOR) }
    }
}

/// The colours of one face's corners.
pub(crate) struct FaceColors<'m> {
    face: Color,
    vertices: Option<&'m [Vec3]>,
}

impl FaceColors<'_> {
    /// The colour of the corner at a vertex: the vertex's own if it counts and isn't missing, else the face's.
    pub fn at(&self, vertex: VertexId) -> [u8; 3] {
        let own = self.vertices.and_then(|colors| colors.get(vertex.index())).filter(|color| !color.is_nan());
        own.map_or(self.face.0, |color| color.to_array().map(|c| (c.clamp(0.0, 1.0) * 255.0).round() as u8))
    }
}
