//! Geometry and sets that several parts share.

mod area_vector;
mod bit_set;
mod mean_position;
mod mean_value;
mod merge_points;
mod triangulate;
mod union_find;

pub use area_vector::{face_area_vector, linked_area_vector, polygon_area_vector};
pub use bit_set::BitSet;
pub use mean_position::mean_position;
pub(crate) use mean_value::mean_value_weights;
pub use merge_points::{MergedPoints, PointMerger, merge_points};
pub use triangulate::{MeshTriangulator, PolygonTriangulator};
pub use union_find::UnionFind;
