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
mod error;
mod file;
mod format;
mod formats;
mod gltf;
mod json;
mod losses;
mod model;
mod notes;
mod obj;
mod off;
mod picture;
mod ply;
mod project;
mod read;
mod report;
mod room;
mod soup;
mod stl;
mod text;
mod write;

pub use companions::{companions, missing, single_file};
pub use error::{ReadError, WriteError};
pub use file::NamedBytes;
pub use formats::Format;
pub use losses::losses;
pub use model::images::is_image;
pub use model::material::{AlphaMode, Material, Materials, MtlStatements, Rgb};
pub use model::texture::{Image, Texture, TextureRole, UvTransform, Wrap};
pub use model::{Model, NamedMesh};
pub use obj::name_of_group;
pub use picture::{Picture, PictureError, PictureSource};
pub use project::MARK as PROJECT_MARK;
pub use read::{HEAD_BYTES, Import, read, read_with, read_within, refusal};
pub use report::{ImportReport, ReportNote, Severity, first_few};
pub use room::Room;
pub use soup::repairs::{NonManifold, Repairs, rebuild};
pub use surface::bezier::Bezier;
pub use text::json_fault::json_fault;
pub use text::number::shortest;
pub use write::write;
