//! Sets of elements that follow from others: neighbours, connected pieces, loops, rings and paths.
//!
//! Sets hold the ids of elements of one kind. Results hold only elements that exist.

mod convert;
mod lines;
mod path;
mod spread;

pub use convert::{convert, expand};
pub use lines::{Line, directions, edge_loop, face_strip, lines, outline};
pub use path::shortest_path;
pub use spread::{grow, linked, shrink};
