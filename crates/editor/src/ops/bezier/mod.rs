//! Operations on the control points of Bezier curves and surfaces.

mod control_points;
mod delete_point;
mod elevate_degree;
mod insert_point;
mod move_point;
mod split;
mod tessellate;

pub use delete_point::*;
pub use elevate_degree::*;
pub use insert_point::*;
pub use move_point::*;
pub use split::*;
pub use tessellate::*;
