//! Wavefront OBJ and MTL.
//!
//! The format is that of "Appendix B1, Object Files" of the Advanced Visualizer manual, polygons only: curves,
//! surfaces, lines and points are named in the import report and left out.
//!
//! A file is one object. The names of its `o` and `g` statements form the label of each face's group:
//! `g wheel` gives "wheel", `o car` gives "o car", and both give "o car; g wheel". Such a label is written as the
//! same statements.

mod cursor;
mod detect;
mod face;
mod libraries;
pub(crate) mod mtl;
mod names;
pub use names::name_of_group;
mod read;
mod runs;
mod statements;
mod troubles;
mod vertex;
mod write;

use crate::format::loss::Part;
use crate::format::{Certainty, Codec, FormatInfo};

/// Wavefront OBJ, with materials in an MTL beside it. Names of objects become groups, which keep objects
/// apart.
pub(crate) static FORMAT: FormatInfo = FormatInfo {
    code: "obj",
    name: "OBJ",
    save_label: "Save as OBJ…",
    description: "Text that every program reads, with a material file for colours.",
    extensions: &["obj"],
    detect: Some((Certainty::Statement, detect::is_obj)),
    is_text: |_| true,
    is_read: true,
    is_written: true,
    companion_extensions: &[(
        "mtl",
        "holds only materials: open it together with the OBJ model it belongs to",
    )],
    companions: libraries::companions,
    lacks: &[Part::Creases, Part::Attributes],
    keeps_property: mtl::keeps,
    keeps_placement: mtl::keeps_placement,
    ..FormatInfo::DEFAULT
};

pub(crate) const CODEC: Codec =
    Codec { read: Some(read::read), write: Some(|model| Ok(write::write(model))) };
