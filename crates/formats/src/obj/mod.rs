//! Wavefront OBJ and MTL.
//!
//! The format is that of "Appendix B1, Object Files" of the Advanced Visualizer manual, polygons
//! only: curves, surfaces, lines and points are noted and left aside.
//!
//! One file is one object. Its `o` and `g` names are kept together as the label of each face's
//! group: `g wheel` gives "wheel", `o car` gives "o car", both give "o car; g wheel". Writing such
//! a label gives the same lines again.

mod cursor;
pub(crate) mod mtl;
pub(crate) mod names;
mod read;
pub(crate) mod runs;
mod statements;
mod texture;
mod write;

pub(crate) use read::read;
pub(crate) use write::write;
