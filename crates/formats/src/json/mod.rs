//! The half-edge mesh itself as JSON: what other programs check our connectivity against; written only.

mod write;

use crate::format::loss::Part;
use crate::format::{Codec, FormatInfo};

pub(crate) static FORMAT: FormatInfo = FormatInfo {
    code: "json",
    name: "Half-edge JSON",
    save_label: "Save as half-edge JSON…",
    description: "The half-edges themselves with all their links, for scripts.",
    extensions: &["json"],
    is_written: true,
    lacks: &[
        Part::Objects,
        Part::FaceColors,
        Part::VertexColors,
        Part::TextureCoordinates,
        Part::Normals,
        Part::Groups,
        Part::Materials,
        Part::Smoothing,
        Part::Creases,
        Part::Attributes,
    ],
    ..FormatInfo::DEFAULT
};

pub(crate) const CODEC: Codec = Codec { read: None, write: Some(|model| Ok(write::write(model))) };
