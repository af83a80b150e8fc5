//! Properties by which elements are selected.

use crate::measure;
use glam::DVec3;
use halfedge::geometry::{PolygonTriangulator, face_area_vector};
use halfedge::{Color, EdgeId, Element, FaceId, HalfedgeId, Mesh, VertexId, keys};
use std::cmp::Ordering;

/// How a number compares with a wanted one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Comparison {
    /// It is the same.
    Equal,
    /// It is another one.
    Different,
    /// It is smaller.
    Less,
    /// It is larger.
    More,
}

impl Comparison {
    fn holds(self, ordering: Option<Ordering>) -> bool {
        match self {
            Self::Equal => ordering == Some(Ordering::Equal),
            Self::Different => ordering.is_some_and(Ordering::is_ne),
            Self::Less => ordering == Some(Ordering::Less),
            Self::More => ordering == Some(Ordering::Greater),
        }
    }
}

/// A property of elements. Each applies to some kinds of elements and is false for others ([`Criterion::kinds`]).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Criterion {
    /// Everything.
    Any,
    /// On the boundary: boundary edges and half-edges, the vertices on them and the faces beside them.
    Boundary,
    /// Vertices in no face.
    Isolated,
    /// Faces, one of whose triangles is turned by more than these degrees against the face's normal.
    NonPlanar {
        /// The angle in degrees.
        degrees: f64,
    },
    /// Faces with this area or less and edges with this length or less.
    Degenerate {
        /// The area or length in mesh units.
        at_most: f64,
    },
    /// Faces by their corners, vertices by their edges.
    Count {
        /// How the number compares.
        is: Comparison,
        /// With what.
        than: usize,
    },
    /// Faces by area, edges by length.
    Size {
        /// How the size compares.
        is: Comparison,
        /// With what, in mesh units.
        than: f64,
    },
    /// Faces by area, edges by length: those that differ from a size by at most a fraction of it.
    Near {
        /// The size in mesh units.
        size: f64,
        /// The fraction.
        tolerance: f64,
    },
    /// Edges whose two faces meet at more than these degrees: 0 is flat.
    Sharp {
        /// The angle in degrees.
        degrees: f64,
    },
    /// Faces whose normal is at most these degrees away from a direction.
    Facing {
        /// The direction, of any length.
        direction: DVec3,
        /// The angle in degrees.
        degrees: f64,
    },
    /// Faces with a colour, each of whose channels differs by at most a fraction of its range.
    Colored {
        /// The colour.
        color: Color,
        /// The fraction.
        tolerance: f64,
    },
}

const EDGES: &[Element] = &[Element::Edge, Element::Halfedge];
const FACES: &[Element] = &[Element::Face];
const SIZED: &[Element] = &[Element::Face, Element::Edge, Element::Halfedge];
const COUNTED: &[Element] = &[Element::Face, Element::Vertex];
const VERTICES: &[Element] = &[Element::Vertex];

impl Criterion {
    /// The kinds of elements that can have the property. Half-edges have those of their edges.
    pub fn kinds(&self) -> &'static [Element] {
        match self {
            Self::Any | Self::Boundary => &Element::ALL,
            Self::Isolated => VERTICES,
            Self::NonPlanar { .. } | Self::Facing { .. } | Self::Colored { .. } => FACES,
            Self::Degenerate { .. } | Self::Size { .. } | Self::Near { .. } => SIZED,
            Self::Count { .. } => COUNTED,
            Self::Sharp { .. } => EDGES,
        }
    }

    /// Whether an existing element has the property. Costs O(valence), for a non-planar face O(corners^2) at most.
    pub fn holds(
        &self,
        mesh: &Mesh,
        kind: Element,
        id: usize,
        triangulator: &mut PolygonTriangulator,
    ) -> bool {
        match (*self, kind) {
            (Self::Any, _) => true,
            (Self::Boundary, Element::Vertex) => mesh.is_boundary_vertex(VertexId::new(id)),
            (Self::Boundary, Element::Edge) => mesh.is_boundary_edge(EdgeId::new(id)),
            (Self::Boundary, Element::Halfedge) => mesh.is_boundary_halfedge(HalfedgeId::new(id)),
            (Self::Boundary, Element::Face) => mesh.is_boundary_face(FaceId::new(id)),
            (Self::Isolated, Element::Vertex) => mesh.halfedge_from(VertexId::new(id)).is_none(),
            (Self::NonPlanar { degrees }, Element::Face) => {
                bend(mesh, FaceId::new(id), triangulator).is_some_and(|bend| bend > degrees)
            }
            (Self::Count { is, than }, Element::Face) => {
                is.holds(Some(mesh.face_degree(FaceId::new(id)).cmp(&than)))
            }
            (Self::Count { is, than }, Element::Vertex) => {
                is.holds(Some(mesh.valence(VertexId::new(id)).cmp(&than)))
            }
            (Self::Degenerate { at_most }, _) => size(mesh, kind, id).is_some_and(|size| size <= at_most),
            (Self::Size { is, than }, _) => {
                size(mesh, kind, id).is_some_and(|size| is.holds(size.partial_cmp(&than)))
            }
            (Self::Near { size: wanted, tolerance }, _) => {
                size(mesh, kind, id).is_some_and(|size| (size - wanted).abs() <= wanted * tolerance)
            }
            (Self::Sharp { degrees }, Element::Edge) => {
                dihedral_angle(mesh, EdgeId::new(id)).is_some_and(|angle| angle > degrees)
            }
            (Self::Sharp { .. }, Element::Halfedge) => self.holds(mesh, Element::Edge, id / 2, triangulator),
            (Self::Facing { direction, degrees }, Element::Face) => {
                let normal = face_area_vector(mesh, FaceId::new(id));
                angle(normal, direction).is_some_and(|angle| angle <= degrees)
            }
            (Self::Colored { color, tolerance }, Element::Face) => {
                let own = mesh.get(keys::FACE_COLOR, id);
                let differs = |(a, b): (u8, u8)| f64::from(a.abs_diff(b)) > tolerance * 255.0;
                !own.0.into_iter().zip(color.0).any(differs)
            }
            _ => false,
        }
    }
}

/// The area of a face or the length of an edge or half-edge, in mesh units; vertices have none.
pub fn size(mesh: &Mesh, kind: Element, id: usize) -> Option<f64> {
    match kind {
        Element::Vertex => None,
        Element::Edge => Some(measure::edge_length(mesh, EdgeId::new(id))),
        Element::Halfedge => Some(measure::edge_length(mesh, HalfedgeId::new(id).edge())),
        Element::Face => Some(measure::face_area(mesh, FaceId::new(id))),
    }
}

/// The angle at which the two faces of an edge meet, in degrees: 0 where they lie in one plane, 180 where one is folded
/// onto the other; none on the boundary and beside a face without area.
pub fn dihedral_angle(mesh: &Mesh, edge: EdgeId) -> Option<f64> {
    let [a, b] = edge.halfedges().map(|h| Some(face_area_vector(mesh, mesh.face_of(h)?)));
    angle(a?, b?)
}

/// The angle between two vectors in degrees; none if one of them is zero.
fn angle(a: DVec3, b: DVec3) -> Option<f64> {
    let (a, b) = (a.try_normalize()?, b.try_normalize()?);
    // Exact for small angles too, unlike the arc cosine.
    Some(a.cross(b).length().atan2(a.dot(b)).to_degrees())
}

/// The largest angle between a face's normal and that of a triangle that it is cut into, in degrees.
fn bend(mesh: &Mesh, face: FaceId, triangulator: &mut PolygonTriangulator) -> Option<f64> {
    if mesh.face_degree(face) == 3 {
        return None;
    }
    let normal = face_area_vector(mesh, face);
    let triangles = triangulator.triangulate_face(mesh, face).iter();
    let angles = triangles.filter_map(|corners| {
        let [a, b, c] = corners.map(|h| mesh.position(mesh.from(h)).as_dvec3());
        angle((b - a).cross(c - a), normal)
    });
    angles.max_by(f64::total_cmp)
}
