//! The mesh as plain data: ids, columns, attributes, building, traversal, undo and validation.

mod add_face;
mod assembly;
pub mod attribute;
mod build;
mod columns;
mod compact;
mod connectivity;
mod elements;
mod id;
mod journal;
mod note;
mod repair;
mod soup;
mod topology;
mod traverse;
mod validate;
mod values;
mod writes;

pub use add_face::{AddFaceError, GivenIds};
pub use build::{Built, TooLarge};
pub use columns::{Gaps, Mesh, RawMesh};
pub use compact::Renumbering;
pub use connectivity::Connectivity;
pub use id::{EdgeId, Element, FaceId, HalfedgeId, NONE, VertexId};
pub use journal::{Journal, Touched};
pub use note::{Note, NoteKind};
pub use soup::PolygonSoup;
pub use topology::{Topology, TopologyCounter};
pub use validate::{Defect, Rule};
