//! PLY, the Stanford polygon format: text and both binary byte orders.
//!
//! Read are positions, faces of any size, triangle strips, and colours of vertices and faces;
//! other properties are noted and left out. After G. Turk's description of the format (1994).

mod header;
mod read;
mod source;
mod write;

use crate::format::loss::{self, Part};
use crate::format::{Certainty, FormatInfo};

/// PLY, written binary (little-endian); reads both.
pub(crate) static BINARY: FormatInfo = FormatInfo {
    code: "ply",
    name: "PLY",
    save_label: "Save as PLY…",
    description: "Binary, with face and vertex colours.",
    detect: Some((Certainty::Signature, header::is_ply)),
    read: Some(|source, reading, progress| read::read(source.file, reading, progress).map(Into::into)),
    write: Some(write::write),
    losses: |model| loss::values_of_corners("PLY", model, false),
    ..COMMON
};

/// PLY written as text.
pub(crate) static TEXT: FormatInfo = FormatInfo {
    code: "ply-text",
    name: "PLY (text)",
    save_label: "Save as PLY (text)…",
    description: "PLY that can be read in a text editor, with colours.",
    write: Some(|model| Ok(write::write_text(model))),
    losses: |model| loss::values_of_corners("PLY (text)", model, false),
    ..COMMON
};

const COMMON: FormatInfo = FormatInfo {
    extensions: &["ply"],
    // Normals as far as the corners of a vertex agree.
    lacks: &[Part::Objects, Part::Groups, Part::Materials, Part::Smoothing, Part::Creases],
    ..FormatInfo::DEFAULT
};
