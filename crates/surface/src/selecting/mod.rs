//! Sets of elements by their properties, or that follow from others: neighbours, connected pieces, loops, rings and
//! paths.
//!
//! Sets hold the ids of elements of one kind. Results hold only elements that exist.

mod convert;
mod criterion;
mod finding;
mod lines;
mod path;
mod related;
mod smaller;

pub use convert::{convert, expand, grow, linked, outline, shrink};
pub use criterion::{Comparison, Criterion, dihedral_angle, size};
pub use finding::Finding;
pub use lines::{Line, directions, edge_loop, face_strip, lines};
pub use path::shortest_path;
pub use related::{is_hidden, vertices};
