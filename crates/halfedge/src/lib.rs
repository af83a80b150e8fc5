//! The half-edge mesh: ids, connectivity, attributes, traversal, building, validation, undo, local edits and
//! shared geometry.
//!
//! # The half-edge interface that courses teach, and its names here
//!
//! Boundary half-edges are stored and form loops of their own, so that a vertex on the boundary too has as
//! many half-edges leaving it as it has edges.
//!
//! | taught | here |
//! |---|---|
//! | vertex: dimension | 3, always |
//! | vertex: k-th coordinate | [`Mesh::position`]`(v)[k]` |
//! | vertex: id | [`VertexId::raw`] |
//! | vertex: number of half-edges leaving it; degree | [`Mesh::valence`] |
//! | vertex: k-th half-edge leaving it, a boundary one first | [`Mesh::outgoing`]`(v).nth(k)` |
//! | vertex: the half-edge to vertex w, or none | [`Mesh::find_halfedge`] |
//! | vertex: one of its half-edges | [`Mesh::halfedge_from`] |
//! | half-edge: id | [`HalfedgeId::raw`] |
//! | half-edge: from-vertex, to-vertex (MayaLite's vertex) | [`Mesh::from`], [`Mesh::to`] |
//! | half-edge: cell | [`Mesh::face_of`] |
//! | half-edge: next and previous in the cell | [`Mesh::next`], [`Mesh::prev`] |
//! | half-edge: next around the edge; twin; sym | [`HalfedgeId::twin`] |
//! | half-edge: previous around the from-vertex | [`Mesh::prev_around_from`] |
//! | is it on the boundary | [`Mesh::is_boundary_halfedge`], [`Mesh::is_boundary_edge`], [`Mesh::is_boundary_vertex`], [`Mesh::is_boundary_face`] |
//! | edge: one of its half-edges | [`EdgeId::halfedge`] |
//! | cell: id | [`FaceId::raw`] |
//! | cell: one of its half-edges | [`Mesh::halfedge_of`] |
//! | cell: number of vertices; degree | [`Mesh::face_degree`] |
//! | mesh: element by id | [`Mesh::vertex`], [`Mesh::halfedge`], [`Mesh::edge`], [`Mesh::face`] |
//! | mesh: counts | [`Mesh::vertex_count`], [`Mesh::halfedge_count`], [`Mesh::edge_count`], [`Mesh::face_count`] |
//! | mesh: lists of ids | [`Mesh::vertices`], [`Mesh::halfedges`], [`Mesh::edges`], [`Mesh::faces`] |
//! | mesh: largest id of each kind (+ 1 is free) | [`Mesh::capacity`]` - 1`; of given ids [`GivenIds::max_vertex_id`], [`GivenIds::max_cell_id`] |
//! | mesh: boundary loops | [`Mesh::boundary_loops`], [`Mesh::loop_of`] |
//! | mesh: add vertices 0..n-1 to an empty mesh | [`GivenIds::add_vertices`] |
//! | mesh: add a vertex with an id | [`GivenIds::add_vertex`] |
//! | mesh: add a cell with an id from vertex ids | [`GivenIds::add_cell`]; by our ids [`Mesh::add_polygon`] |
//! | mesh: element by given id | [`GivenIds::vertex`], [`GivenIds::cell`] |
//! | mesh: set coordinates | [`Mesh::set_position`], [`GivenIds::set_position`] |
//! | Catmull-Clark as a new mesh, the old one untouched | `surface::subdivide_catmull_clark` |

#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable))]

pub mod edit;
pub mod geometry;
mod in_parts;
mod mesh;
mod number_range;
pub mod words;

pub use edit::Refusal;
pub use in_parts::{Budget, InParts};
pub use mesh::attribute::{self, Color, keys};
pub use mesh::{
    AddFaceError, Built, Connectivity, Defect, EdgeId, Element, FaceId, Gaps, GivenIds, HalfedgeId, Journal,
    Mesh, NONE, Note, NoteKind, PolygonSoup, RawMesh, Renumbering, Rule, TooLarge, Topology, TopologyCounter,
    Touched, VertexId,
};
pub use number_range::NumberRange;

/// Receives the progress of a long operation, from 0 to 1, and returns whether to continue. After `Break` the
/// operation stops and leaves its input unchanged.
pub type Progress<'a> = dyn FnMut(f32) -> std::ops::ControlFlow<()> + 'a;
