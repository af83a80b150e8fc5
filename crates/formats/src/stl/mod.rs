//! STL, triangles for printers: text and binary.
//!
//! A file has no shared vertices: each triangle brings its own corners. On import, corners at
//! exactly the same position become one vertex. A text file may have several solids with names, a binary one
//! colours of triangles.

mod binary;
mod color;
mod read;
mod text;
mod triangles;
mod write;

use crate::format::loss::{self, Part};
use crate::format::{Certainty, Codec, FormatInfo};
use crate::model::Model;
use glam::{DVec3, Vec3};
use halfedge::keys;
use halfedge::words::counted;

/// STL, written binary; reads both.
pub(crate) static BINARY: FormatInfo = FormatInfo {
    code: "stl",
    name: "STL",
    save_label: "Save as STL…",
    description: "Binary triangles, for 3D printing.",
    detect: Some((Certainty::Layout, read::is_stl)),
    is_text: text::is_text_stl,
    corners: binary::corners,
    is_read: true,
    lacks: &[
        Part::Objects,
        Part::Polygons,
        Part::IsolatedVertices,
        Part::VertexColors,
        Part::TextureCoordinates,
        Part::Normals,
        Part::Groups,
        Part::Materials,
        Part::Smoothing,
        Part::Creases,
        Part::Attributes,
    ],
    losses: |model| {
        let triangles = loss::conflicting_triangles("STL", model).into_iter();
        triangles
            .chain(loss::merged_vertices("STL", model))
            .chain(rounded_positions(model))
            .chain(rounded_colors(model))
            .collect()
    },
    ..COMMON
};

/// STL written as text. Names of objects and groups become names of solids.
pub(crate) static TEXT: FormatInfo = FormatInfo {
    code: "stl-text",
    name: "STL (text)",
    save_label: "Save as STL (text)…",
    description: "Triangles that can be read in a text editor.",
    lacks: &[
        Part::Polygons,
        Part::IsolatedVertices,
        Part::FaceColors,
        Part::VertexColors,
        Part::TextureCoordinates,
        Part::Normals,
        Part::Materials,
        Part::Smoothing,
        Part::Creases,
        Part::Attributes,
    ],
    losses: |model| {
        let triangles = loss::conflicting_triangles("STL (text)", model).into_iter();
        triangles.chain(loss::merged_vertices("STL (text)", model)).collect()
    },
    ..COMMON
};

const COMMON: FormatInfo = FormatInfo { extensions: &["stl"], is_written: true, ..FormatInfo::DEFAULT };

pub(crate) const BINARY_CODEC: Codec = Codec {
    read: Some(|source, reading, progress| read::read(source.file, reading, progress).map(Into::into)),
    write: Some(write::write),
};

pub(crate) const TEXT_CODEC: Codec = Codec { read: None, write: Some(|model| Ok(write::write_text(model))) };

/// The loss of digits of models far from the origin in 32 bits for a coordinate.
fn rounded_positions(model: &Model) -> Option<String> {
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

fn rounded_colors(model: &Model) -> Option<String> {
    let faces = model.objects.iter().flat_map(|object| object.mesh.faces().map(move |face| (object, face)));
    let is_rounded =
        faces.filter(|(object, face)| !color::is_exact(object.mesh.get(keys::FACE_COLOR, face.index())));
    let count = is_rounded.count();
    (count > 0).then(|| {
        format!(
            "STL holds 5 bits for a channel of a colour: those of {} are rounded",
            counted(count, "face", "faces")
        )
    })
}
