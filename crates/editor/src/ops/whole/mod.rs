//! Operations on whole meshes.

mod each_mesh;
mod merge_by_distance;
mod remesh;
mod simplify;
mod smooth;
mod subdivide;
mod subdivide_catmull_clark;
mod subdivide_linear;
mod subdivide_loop;

pub use merge_by_distance::MergeByDistance;
pub use remesh::Remesh;
pub use simplify::Simplify;
pub use smooth::{Smooth, SmoothMethod};
pub use subdivide::Boundary;
pub use subdivide_catmull_clark::{SubdivideCatmullClark, VertexRule};
pub use subdivide_linear::SubdivideLinear;
pub use subdivide_loop::{SubdivideLoop, Weights};
