//! Local edits: each in a file of its own, as a pair of a check and the edit.
//!
//! `can_x(&mesh, …)` says whether the edit would leave a valid mesh, or why not; `x(&mut mesh, …)`
//! makes it, or refuses for the same reason and changes nothing. Each costs time in proportion to
//! the valences and face degrees around it, never to the mesh.

mod parts;
mod refusal;
mod split_edge;
mod triangulate;

pub use refusal::Refusal;
pub use split_edge::{Connect, EdgeSplit, can_split_edge, split_edge};
pub use triangulate::{Triangulated, can_triangulate_face, triangulate_face};
