//! COLLADA 1.4 and 1.5 (`.dae`), after the Khronos "COLLADA Digital Asset Schema Release 1.4.1": meshes of
//! polygons with corner attributes and materials.
//!
//! Each instance of a geometry in the scene becomes one object, with its node's transforms applied, skinned
//! and morphed as the scene shows it, in metres with Y up. A fault in one element leaves the others alone;
//! the report names whatever is left out.

mod controller;
mod effect;
mod faces;
mod geometry;
mod image;
mod left_out;
mod material;

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

use crate::format::loss::Part;
use crate::format::{Certainty, Codec, FormatInfo};

pub(crate) static FORMAT: FormatInfo = FormatInfo {
    code: "dae",
    name: "COLLADA",
    save_label: "Save as COLLADA…",
    description: "XML with several objects, for other modellers.",
    extensions: &["dae"],
    detect: Some((Certainty::Signature, read::looks_like)),
    is_read: true,
    is_written: true,
    companions: read::companions,
    keeps_name: true,
    lacks: &[Part::Groups, Part::Smoothing, Part::Creases, Part::Attributes],
    keeps_property: write::keeps,
    // Meshes have one set of texture coordinates.
    keeps_placement: |texture| texture.uv_set == 0,
    ..FormatInfo::DEFAULT
};

pub(crate) const CODEC: Codec =
    Codec { read: Some(read::read), write: Some(|model| Ok(write::write(model))) };
