//! The half-edge mesh: ids, connectivity, attributes, traversal, building, validation, undo and
//! local edits.

pub mod attribute;
mod build;
mod compact;
pub mod edit;
mod id;
mod journal;
mod mesh;
mod repair;
mod soup;
mod traverse;
mod validate;

pub use attribute::{Color, keys};
pub use build::{Built, TooLarge};
pub use compact::Renumbering;
pub use edit::Refusal;
pub use id::{EdgeId, Element, FaceId, HalfedgeId, NONE, VertexId};
pub use journal::{Journal, Touched};
pub use mesh::{Mesh, RawMesh};
pub use repair::{Note, NoteKind};
pub use soup::PolygonSoup;
pub use validate::{Defect, Rule};

/// Told how much of a long operation is done (0 to 1), answers whether to go on. `Break` makes the
/// operation stop with its input untouched.
pub type Progress<'a> = dyn FnMut(f32) -> std::ops::ControlFlow<()> + 'a;
