//! OFF, Geomview's object file format, in text: polygons, with colours of vertices (`COFF`) and
//! faces, normals (`NOFF`) and texture coordinates (`STOFF`) of vertices. After "OFF files" in the Geomview manual.

mod read;
mod write;

pub(crate) use read::{is_off, read};
pub(crate) use write::write;
