//! Facts about a mesh, and what an operation would make of it.

use halfedge::Mesh;
use surface::measure;

/// Facts about one mesh that suggest values for fields and tell how large results are. Those that
/// take a walk over the mesh may be unknown.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Facts {
    /// The number of vertices.
    pub vertices: usize,
    /// The number of faces.
    pub faces: usize,
    /// The number of corners of all faces together.
    pub corners: Option<usize>,
    /// The number of Bezier patches, where the mesh shows a Bezier surface.
    pub patches: usize,
    /// The mean length of the edges, 0 where there is none.
    pub mean_edge: Option<f64>,
    /// The area of all faces.
    pub area: Option<f64>,
    /// The diagonal of the bounding box.
    pub diagonal: Option<f64>,
}

impl Facts {
    /// The facts that a mesh knows without a walk over it.
    pub fn counts(mesh: &Mesh) -> Self {
        Self { vertices: mesh.vertex_count(), faces: mesh.face_count(), ..Self::default() }
    }

    /// All facts. Costs O(mesh).
    pub fn of(mesh: &Mesh) -> Self {
        Self { corners: Some(corners(mesh)), ..Self::counts(mesh) }.with_measures(mesh)
    }

    /// Adds lengths and areas. Costs O(mesh).
    #[must_use]
    pub fn with_measures(self, mesh: &Mesh) -> Self {
        Self {
            mean_edge: Some(measure::mean_edge_length(mesh)),
            area: Some(measure::surface_area(mesh)),
            diagonal: Some(measure::bounding_box(mesh).map_or(0.0, |bounds| bounds.diagonal())),
            ..self
        }
    }

    /// The length of edges that remeshing takes by itself, where that is known.
    pub fn remeshed_edge(&self) -> Option<f64> {
        let mean = self.mean_edge?;
        let fitted = self.area.zip(self.triangles());
        Some(fitted.map_or(mean, |(area, triangles)| surface::Remesh::fitted_length(mean, area, triangles)))
    }

    /// How many triangles the faces can be cut into, where that is known.
    pub fn triangles(&self) -> Option<usize> {
        self.corners?.checked_sub(2 * self.faces)
    }
}

/// The number of corners of all faces together. Costs O(mesh).
pub(crate) fn corners(mesh: &Mesh) -> usize {
    mesh.halfedges().filter(|&h| !mesh.is_boundary_halfedge(h)).count()
}

/// An upper bound of the number of corners, which costs nothing: boundary half-edges count too.
pub(crate) fn corners_at_most(mesh: &Mesh) -> usize {
    mesh.halfedge_count()
}

/// How large the result of an operation is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Estimate {
    /// The number of elements.
    pub count: Amount,
    /// What is counted.
    pub counted: Counted,
    /// Of how many there are now, where that says more than the number alone.
    pub of: Option<usize>,
}

/// What an estimate counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Counted {
    /// Faces of the result.
    Faces,
    /// Faces of the result, all of them triangles.
    Triangles,
    /// Vertices of the result.
    Vertices,
    /// Vertices that move, in a result with the same elements.
    MovedVertices,
}

/// A number of elements as far as it is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Amount {
    /// Exactly this many.
    Exactly(usize),
    /// About this many.
    About(usize),
    /// Not known before the operation runs.
    Unknown,
}

impl Estimate {
    /// Exactly this many faces.
    pub(crate) fn faces(count: usize) -> Self {
        Self { count: Amount::Exactly(count), counted: Counted::Faces, of: None }
    }

    /// The same estimate with the count of a result that was tried out.
    #[must_use]
    pub fn exactly(self, result: &Mesh) -> Self {
        let count = match self.counted {
            Counted::Faces | Counted::Triangles => result.face_count(),
            Counted::Vertices | Counted::MovedVertices => result.vertex_count(),
        };
        Self { count: Amount::Exactly(count), ..self }
    }
}
