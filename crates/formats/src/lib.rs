//! Bytes to meshes and back, each import with a report.
//!
//! [`read`] makes a [`Model`] of files in memory; [`write`] makes files of a model; [`losses`] tells
//! beforehand what a format can't hold of it.
//!
//! Each format is a folder and a line in the table of `formats.rs`. Readers and writers see only what
//! lies below them: the model, its materials, soups and text. The dispatch above sees only the table.

#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable))]
#![cfg_attr(not(test), deny(clippy::indexing_slicing))]

mod bezier;
mod collada;
mod companions;
mod encoding;
mod error;
mod file;
mod format_info;
mod formats;
mod gltf;
mod hash;
mod holes;
mod images;
mod json;
mod labels;
mod loss;
mod losses;
mod material;
mod model;
mod number;
mod obj;
mod off;
mod origin;
mod paint;
mod pieces;
mod ply;
mod read;
mod reading;
mod repairs;
mod report;
mod scan;
mod soup;
mod srgb;
mod stl;
mod text;
mod weld;
mod write;

pub use companions::{companions, missing, single_file};
pub use error::{ReadError, WriteError};
pub use file::NamedBytes;
pub use formats::Format;
pub use losses::losses;
pub use material::{
    AlphaMode, Image, Material, Materials, MtlStatements, Rgb, Texture, TextureRole, UvTransform, Wrap,
};
pub use model::{Model, NamedMesh};
pub use number::shortest;
pub use read::{Import, read, read_with};
pub use repairs::{NonManifold, Repairs, rebuild};
pub use report::{ImportReport, ReportNote, Severity};
pub use surface::bezier::Bezier;
pub use write::write;
