//! PLY, the Stanford polygon format: text and both binary byte orders.
//!
//! Read are positions, faces of any size, triangle strips, colours of vertices and faces, normals, texture
//! coordinates and the images that MeshLab names; other numbers of vertices and faces are kept as columns of the
//! mesh and written again. What else there is is named. After G. Turk's description of the format (1994).

mod attributes;
mod columns;
mod faces;
mod header;
mod read;
mod rows;
mod source;
mod textures;
mod vertices;
mod write;

use crate::format::loss::{self, Part};
use crate::format::{Certainty, Codec, FormatInfo};
use crate::model::Model;
use crate::model::material::Property;
use crate::model::texture::{Texture, TextureRole};
use glam::Vec3;
use halfedge::words::counted;
use halfedge::{Mesh, keys};

/// PLY, written binary (little-endian); reads both.
pub(crate) static BINARY: FormatInfo = FormatInfo {
    code: "ply",
    name: "PLY",
    save_label: "Save as PLY…",
    description: "Binary, with face and vertex colours.",
    detect: Some((Certainty::Signature, header::is_ply)),
    corners: |head, _| header::corners(head),
    is_text: header::is_text_ply,
    is_read: true,
    losses: |model| losses("PLY", model),
    ..COMMON
};

pub(crate) const BINARY_CODEC: Codec = Codec { read: Some(read::read), write: Some(write::write) };

/// PLY written as text.
pub(crate) static TEXT: FormatInfo = FormatInfo {
    code: "ply-text",
    name: "PLY (text)",
    save_label: "Save as PLY (text)…",
    description: "PLY that can be read in a text editor, with colours.",
    losses: |model| losses("PLY (text)", model),
    ..COMMON
};

pub(crate) const TEXT_CODEC: Codec = Codec { read: None, write: Some(|model| Ok(write::write_text(model))) };

const COMMON: FormatInfo = FormatInfo {
    extensions: &["ply"],
    is_written: true,
    companions: read::companions,
    // Normals as far as the corners of a vertex agree.
    lacks: &[Part::Objects, Part::Groups, Part::Materials, Part::Smoothing, Part::Creases],
    keeps_property: |property| {
        matches!(property, Property::BaseColor | Property::Texture(TextureRole::BaseColor))
    },
    keeps_placement: |texture| *texture == Texture::new(texture.role, texture.image),
    ..FormatInfo::DEFAULT
};

fn losses(format: &str, model: &Model) -> Vec<String> {
    let mut losses = loss::values_of_corners(format, model, false);
    losses.extend(rounded_colors(format, model));
    losses.extend(texture_coordinates_of_some_corners(format, model));
    losses
}

fn rounded_colors(format: &str, model: &Model) -> Option<String> {
    let is_exact = |color: &Vec3| {
        color.is_nan()
            || color.to_array().iter().all(|&channel| f32::from(write::byte(channel)) / 255.0 == channel)
    };
    let colors =
        |mesh: &Mesh| mesh.vertices().map(|v| mesh.get(keys::VERTEX_COLOR, v.index())).collect::<Vec<_>>();
    let colors = model.objects.iter().flat_map(|object| colors(&object.mesh));
    let count = colors.filter(|color| !is_exact(color)).count();
    let vertices = counted(count, "vertex", "vertices");
    (count > 0)
        .then(|| format!("{format} holds 8 bits for a channel of a colour: those of {vertices} are rounded"))
}

fn texture_coordinates_of_some_corners(format: &str, model: &Model) -> Option<String> {
    let faces =
        model.objects.iter().flat_map(|object| object.mesh.faces().map(move |face| (&object.mesh, face)));
    let lost = faces.map(|(mesh, face)| {
        let corners = mesh.face_halfedges(face).filter(|h| !mesh.get(keys::CORNER_UV, h.index()).is_nan());
        let count = corners.count();
        if count < mesh.face_degree(face) { count } else { 0 }
    });
    let count: usize = lost.sum();
    let corners = counted(count, "corner", "corners");
    (count > 0).then(|| {
        format!(
            "{format} holds texture coordinates of all corners of a face or none: those of {corners} are lost"
        )
    })
}
