//! Bytes to meshes and back, each import with a report.
//!
//! [`read`] takes files in memory and gives a document's objects; [`write`] takes objects and gives
//! files; [`losses`] says beforehand what a format can't hold.

#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable))]
#![cfg_attr(not(test), deny(clippy::indexing_slicing))]

mod bezier;
mod collada;
mod companions;
mod detect;
mod encoding;
mod export;
mod format;
mod gltf;
mod hash;
mod holes;
mod import;
mod json;
mod losses;
mod material;
mod number;
mod obj;
mod off;
mod origin;
mod pieces;
mod ply;
mod repairs;
mod report;
mod scan;
mod soup;
mod srgb;
mod stl;
mod text;
mod weld;

pub use bezier::Controls;
pub use companions::{alone, companions, missing};
pub use export::{ObjectRef, WriteError, write};
pub use format::Format;
pub use import::{Import, ImportedObject, NamedBytes, ReadError, read, read_with};
pub use losses::losses;
pub use material::{
    AlphaMode, Image, Material, Materials, MtlStatements, Rgb, Texture, TextureRole, UvTransform, Wrap,
};
pub use number::shortest;
pub use repairs::{NonManifold, Repairs, rebuild};
pub use report::{ImportReport, ReportNote, Severity};
