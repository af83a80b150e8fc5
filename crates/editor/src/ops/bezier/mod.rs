//! Operations on the control points of Bezier curves and surfaces.

mod control_points;
mod delete_point;
mod elevate_degree;
mod insert_point;
mod move_point;
mod split;
mod tessellate;

pub use delete_point::BezierDeletePoint;
pub use elevate_degree::BezierElevateDegree;
pub use insert_point::BezierInsertPoint;
pub use move_point::BezierMovePoint;
pub use split::BezierSplit;
pub use tessellate::BezierTessellate;
