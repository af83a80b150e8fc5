//! Geometry that several parts share: each piece is written once.

mod area_vector;
mod triangulate;

pub use area_vector::{face_area_vector, linked_area_vector, polygon_area_vector};
pub use triangulate::PolygonTriangulator;
