//! OFF, Geomview's object file format, in text and binary: polygons, with colours of vertices (`COFF`) and
//! faces, normals (`NOFF`) and texture coordinates (`STOFF`) of vertices. After "OFF files" in the Geomview
//! manual, and what MeshLab, CGAL and pmp-library write.

mod binary;
mod contents;
mod keyword;
mod read;
mod text;
mod write;

use crate::format::loss::{self, Part};
use crate::format::{Certainty, Codec, FormatInfo};

pub(crate) static FORMAT: FormatInfo = FormatInfo {
    code: "off",
    name: "OFF",
    save_label: "Save as OFF…",
    description: "Plain text of geometry programs, with colours.",
    extensions: &["off", "coff"],
    detect: Some((Certainty::Signature, keyword::is_off)),
    is_text: |bytes| !keyword::is_binary(bytes),
    is_read: true,
    is_written: true,
    // Normals and texture coordinates as far as the corners of a vertex agree.
    lacks: &[Part::Objects, Part::Groups, Part::Materials, Part::Smoothing, Part::Creases, Part::Attributes],
    losses: |model| loss::values_of_corners("OFF", model, true),
    ..FormatInfo::DEFAULT
};

pub(crate) const CODEC: Codec = Codec {
    read: Some(|source, reading, progress| read::read(source.file, reading, progress).map(Into::into)),
    write: Some(|model| Ok(write::write(model))),
};
