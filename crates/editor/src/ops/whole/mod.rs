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

pub use merge_by_distance::*;
pub use remesh::*;
pub use simplify::*;
pub use smooth::*;
pub use subdivide_catmull_clark::*;
pub use subdivide_linear::*;
pub use subdivide_loop::*;
