//! COLLADA 1.4 and 1.5 (`.dae`): meshes of polygons with their instances, materials' colours and
//! corner attributes. After the Khronos "COLLADA Digital Asset Schema Release 1.4.1".
//!
//! Each instance of a geometry in the scene is one object, its node's transforms applied, in
//! metres with Y up. A fault costs what has it and no more: what is left out is named in the report.

mod controller;
mod effect;
mod faces;
mod geometry;
mod image;
mod left_out;
mod material;
mod notes;
mod numbers;
mod primitive;
mod read;
mod scene;
mod skin;
mod source;
mod transform;
mod vocabulary;
mod write;
mod xml;

pub(crate) use read::{companions, looks_like, read};
pub(crate) use write::{keeps, write};
