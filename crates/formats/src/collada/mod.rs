//! COLLADA 1.4 and 1.5 (`.dae`): meshes of polygons with their instances, materials' colours and
//! corner attributes. After the Khronos "COLLADA Digital Asset Schema Release 1.4.1".
//!
//! Each instance of a geometry in the scene is one object, its node's transforms applied, in
//! metres with Y up.

mod geometry;
mod material;
mod read;
mod source;
mod transform;
mod write;
mod xml;

pub(crate) use read::{looks_like, read};
pub(crate) use write::write;
