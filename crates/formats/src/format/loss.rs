//! Parts of a document that some formats can't hold, and losses that several formats share.

use crate::model::Model;
use crate::model::attributes::attributes;
use crate::soup::pieces::uniform;
use crate::soup::weld::Weld;
use glam::{Vec2, Vec3};
use halfedge::attribute::{AttributeType, Key};
use halfedge::geometry::MeshTriangulator;
use halfedge::words::counted;
use halfedge::{Color, Element, Mesh, NONE, keys};

/// A part of a document that some format can't hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Part {
    /// Several objects, each with its name.
    Objects,
    /// Faces with more than three corners.
    Polygons,
    /// Vertices that no face uses.
    IsolatedVertices,
    FaceColors,
    VertexColors,
    TextureCoordinates,
    Normals,
    Groups,
    Materials,
    Smoothing,
    Creases,
    /// Columns of numbers that have no meaning here, as a file brought them along.
    Attributes,
}

impl Part {
    /// All parts.
    pub(crate) const ALL: [Self; 12] = [
        Self::Objects,
        Self::Polygons,
        Self::IsolatedVertices,
        Self::FaceColors,
        Self::VertexColors,
        Self::TextureCoordinates,
        Self::Normals,
        Self::Groups,
        Self::Materials,
        Self::Smoothing,
        Self::Creases,
        Self::Attributes,
    ];

    /// How many elements of a mesh have it.
    pub(crate) fn count(self, mesh: &Mesh) -> usize {
        match self {
            Self::Objects => 1,
            Self::Polygons => mesh.faces().filter(|&f| mesh.face_halfedges(f).nth(3).is_some()).count(),
            Self::IsolatedVertices => mesh.vertices().filter(|&v| mesh.halfedge_from(v).is_none()).count(),
            Self::FaceColors => count(mesh, keys::FACE_COLOR, |color| color != Color::UNPAINTED),
            Self::VertexColors => count(mesh, keys::VERTEX_COLOR, |color| !color.is_nan()),
            Self::TextureCoordinates => count(mesh, keys::CORNER_UV, |uv| !uv.is_nan()),
            Self::Normals => count(mesh, keys::CORNER_NORMAL, |normal| !normal.is_nan()),
            Self::Groups => count(mesh, keys::FACE_GROUP, |group| group != NONE),
            Self::Materials => count(mesh, keys::FACE_MATERIAL, |material| material != NONE),
            Self::Smoothing => count(mesh, keys::FACE_SMOOTHING, |group| group != 0),
            Self::Creases => {
                count(mesh, keys::EDGE_CREASE, |sharp| sharp > 0.0)
                    + count(mesh, keys::VERTEX_CREASE, |sharp| sharp > 0.0)
            }
            Self::Attributes => Element::ALL.map(|element| attributes(mesh, element).count()).iter().sum(),
        }
    }

    /// The message about `count` elements that lose it.
    pub(crate) fn loss(self, format: &str, count: usize) -> String {
        let n = |one: &str, many: &str| counted(count, one, many);
        match self {
            Self::Objects => format!("{format} holds one mesh: {} become one", n("object", "objects")),
            Self::Polygons => {
                format!(
                    "{format} holds triangles only: {} cut into triangles",
                    n("polygon is", "polygons are")
                )
            }
            Self::IsolatedVertices => format!(
                "{format} holds no vertices without faces: {} left out",
                n("vertex is", "vertices are")
            ),
            Self::FaceColors => {
                format!("{format} holds no face colours: those of {} are lost", n("face", "faces"))
            }
            Self::VertexColors => {
                format!("{format} holds no vertex colours: those of {} are lost", n("vertex", "vertices"))
            }
            Self::TextureCoordinates => {
                format!("{format} holds no texture coordinates: those of {} are lost", n("corner", "corners"))
            }
            Self::Normals => {
                format!("{format} holds no corner normals: those of {} are lost", n("corner", "corners"))
            }
            Self::Groups => {
                format!("{format} holds no face groups: those of {} are lost", n("face", "faces"))
            }
            Self::Materials => {
                format!("{format} holds no material names: those of {} are lost", n("face", "faces"))
            }
            Self::Smoothing => {
                format!("{format} holds no smoothing groups: those of {} are lost", n("face", "faces"))
            }
            Self::Creases => format!("{format} holds no creases: {} lost", n("crease is", "creases are")),
            Self::Attributes => {
                format!(
                    "{format} holds no attributes of other programs: {} lost",
                    n("attribute is", "attributes are")
                )
            }
        }
    }
}

/// The number of existing elements whose value `counts`.
fn count<T: AttributeType>(mesh: &Mesh, key: Key<T>, counts: impl Fn(T) -> bool) -> usize {
    let Some(values) = mesh.attribute(key) else { return 0 };
    let has = |index: usize| values.get(index).is_some_and(|&value| counts(value));
    match key.element {
        Element::Vertex => mesh.vertices().filter(|v| has(v.index())).count(),
        Element::Edge => mesh.edges().filter(|e| has(e.index())).count(),
        Element::Face => mesh.faces().filter(|f| has(f.index())).count(),
        // Boundary half-edges are not corners of faces.
        Element::Halfedge => {
            mesh.halfedges().filter(|&h| !mesh.is_boundary_halfedge(h) && has(h.index())).count()
        }
    }
}

/// The loss in a format that holds triangles without vertex numbers: vertices at one place become one.
pub(crate) fn merged_vertices(format: &str, model: &Model) -> Option<String> {
    let mut places = Weld::new();
    let mut count = 0;
    for mesh in model.objects.iter().map(|object| &object.mesh) {
        for v in mesh.vertices().filter(|&v| mesh.halfedge_from(v).is_some()) {
            places.vertex(mesh.position(v));
            count += 1;
        }
    }
    let merged = count - places.positions.len();
    (merged > 0).then(|| {
        format!(
            "{format} holds triangles without shared vertices: {} at the same place as another will be one with it \
             when the file is opened",
            counted(merged, "vertex", "vertices")
        )
    })
}

/// The loss in a format of triangles where those of polygons can't form a mesh: two would join the same vertices.
pub(crate) fn conflicting_triangles(format: &str, model: &Model) -> Option<String> {
    let conflicts = model.objects.iter().map(|object| {
        let mut triangulator = MeshTriangulator::new(&object.mesh);
        object.mesh.faces().for_each(|f| {
            triangulator.triangulate_face(f);
        });
        triangulator.conflicts()
    });
    let count: usize = conflicts.sum();
    (count > 0).then(|| {
        format!(
            "{format} holds triangles only: those of {} overlap others along an edge, so some will be left out or separated \
             when the file is opened. Divide these polygons with new vertices first",
            counted(count, "polygon", "polygons")
        )
    })
}

/// The losses in a format with one normal per vertex, and one texture coordinate if `uvs`: values of
/// vertices whose corners differ.
pub(crate) fn values_of_corners(format: &str, model: &Model, uvs: bool) -> Vec<String> {
    let mut losses = Vec::new();
    let mut lose = |part: Part, what: &str, fits: &dyn Fn(&Mesh) -> bool| {
        let count: usize = model.objects.iter().map(|object| part.count(&object.mesh)).sum();
        if count > 0 && !model.objects.iter().all(|object| fits(&object.mesh)) {
            let corners = counted(count, "corner", "corners");
            losses.push(format!("{format} holds one {what} for each vertex: those of {corners} are lost"));
        }
    };
    let fits = |mesh: &Mesh| uniform(mesh, keys::CORNER_NORMAL, |n| n.is_nan(), Vec3::ZERO).is_some();
    lose(Part::Normals, "normal", &fits);
    if uvs {
        let fits = |mesh: &Mesh| uniform(mesh, keys::CORNER_UV, |uv| uv.is_nan(), Vec2::ZERO).is_some();
        lose(Part::TextureCoordinates, "texture coordinate", &fits);
    }
    losses
}
