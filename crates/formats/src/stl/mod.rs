//! STL, triangles for printers: text and binary.
//!
//! A file has no shared vertices: each triangle brings its own corners. On import, corners at
//! exactly the same position become one vertex.

mod read;
mod write;

use crate::format::loss::{self, Part};
use crate::format::{Certainty, FormatInfo};
use crate::model::Model;
use glam::{DVec3, Vec3};

/// STL, written binary; reads both.
pub(crate) static BINARY: FormatInfo = FormatInfo {
    code: "stl",
    name: "STL",
    save_label: "Save as STL…",
    description: "Binary triangles, for 3D printing.",
    detect: Some((Certainty::Layout, |bytes| read::is_text_stl(bytes) || read::is_binary(bytes))),
    read: Some(|source, reading, progress| read::read(source.file, reading, progress).map(Into::into)),
    write: Some(write::write),
    losses: |model| loss::merged_vertices("STL", model).into_iter().chain(rounding_loss(model)).collect(),
    ..COMMON
};

/// STL written as text.
pub(crate) static TEXT: FormatInfo = FormatInfo {
    code: "stl-text",
    name: "STL (text)",
    save_label: "Save as STL (text)…",
    description: "Triangles that can be read in a text editor.",
    write: Some(|model| Ok(write::write_text(model))),
    losses: |model| loss::merged_vertices("STL (text)", model).into_iter().collect(),
    ..COMMON
};

const COMMON: FormatInfo = FormatInfo { extensions: &["stl"], lacks: &Part::ALL, ..FormatInfo::DEFAULT };

/// The loss of digits of models far from the origin in 32 bits for a coordinate.
fn rounding_loss(model: &Model) -> Option<String> {
    let is_rounded = |position: &Vec3| {
        let exact = position.as_dvec3() + model.offset;
        exact.as_vec3().as_dvec3() != exact
    };
    let mut positions = model.objects.iter().flat_map(|object| object.mesh.positions());
    (model.offset != DVec3::ZERO && positions.any(is_rounded)).then(|| {
        "STL holds 32 bits for a coordinate: positions so far from the origin are rounded; STL (text) keeps them"
            .to_owned()
    })
}
