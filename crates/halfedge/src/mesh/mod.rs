//! The mesh as plain data: ids, columns, attributes, building, traversal, undo, validation.

mod add_face;
pub mod attribute;
mod build;
mod columns;
mod compact;
mod connectivity;
mod id;
mod journal;
mod repair;
mod soup;
mod topology;
mod traverse;
mod validate;

pub use add_face::{AddFaceError, GivenIds};
pub use build::{Built, TooLarge};
pub use columns::{Gaps, Mesh, RawMesh};
pub use compact::Renumbering;
pub use connectivity::Connectivity;
pub use id::{EdgeId, Element, FaceId, HalfedgeId, NONE, VertexId};
pub use journal::{Journal, Touched};
pub use repair::{Note, NoteKind};
pub use soup::PolygonSoup;
pub use topology::{Topology, TopologyCounter};
pub use validate::{Defect, Rule};
