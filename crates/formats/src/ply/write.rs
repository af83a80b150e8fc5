//! Writing a PLY, binary or text; positions read back bit for bit.

use super::attributes::Attribute;
use super::textures::Textures;
use crate::error::WriteError;
use crate::file::NamedBytes;
use crate::model::Model;
use crate::soup::pieces::Pieces;
use crate::text::print::{push_floats, push_integer, push_position};
use glam::Vec3;
use halfedge::{Color, Element, FaceId, Mesh, keys};
use std::io::Write;

/// The most that a `uchar`, which readers expect in front of lists, counts.
const MAX_BYTE_COUNT: usize = u8::MAX as usize;

/// What there is to write of the vertices and faces of all objects.
struct Parts<'a> {
    pieces: Pieces<'a>,
    vertex_colors: Option<Vec<Vec3>>,
    normals: Option<Vec<Vec3>>,
    face_colors: Option<Vec<Color>>,
    has_uvs: bool,
    /// Whether faces have more corners, or texture coordinates, than a `uchar` counts.
    has_large_faces: bool,
    has_many_uvs: bool,
    textures: Textures,
    vertex_attributes: Vec<Attribute>,
    face_attributes: Vec<Attribute>,
}

impl<'a> Parts<'a> {
    fn new(model: &'a Model) -> Self {
        let pieces = Pieces::new(model);
        let most_corners = pieces.faces().map(|(mesh, _, f)| mesh.face_degree(f)).max().unwrap_or(0);
        let has_uvs = pieces.has_uvs();
        Self {
            vertex_colors: pieces.vertex_colors(),
            normals: pieces.vertex_normals(),
            face_colors: pieces.face_colors(),
            has_uvs,
            has_large_faces: most_corners > MAX_BYTE_COUNT,
            has_many_uvs: has_uvs && 2 * most_corners > MAX_BYTE_COUNT,
            textures: Textures::of(model, &pieces),
            vertex_attributes: Attribute::all(&pieces, Element::Vertex),
            face_attributes: Attribute::all(&pieces, Element::Face),
            pieces,
        }
    }

    fn vertex_color(&self, v: usize) -> Option<[u8; 3]> {
        self.vertex_colors.as_ref()?.get(v).map(|color| color.to_array().map(byte))
    }

    fn normal(&self, v: usize) -> Option<[f32; 3]> {
        self.normals.as_ref()?.get(v).map(|normal| normal.to_array())
    }

    fn face_color(&self, f: usize) -> Option<[u8; 3]> {
        self.face_colors.as_ref()?.get(f).map(|color| color.0)
    }

    /// The texture coordinates of a face's corners; none unless all have one.
    fn uvs(&self, mesh: &Mesh, f: FaceId, uvs: &mut Vec<f32>) {
        uvs.clear();
        uvs.extend(mesh.face_halfedges(f).flat_map(|h| mesh.get(keys::CORNER_UV, h.index()).to_array()));
        if uvs.iter().any(|c| c.is_nan()) {
            uvs.clear();
        }
    }

    fn head(&self, format: &str) -> Vec<u8> {
        const CHANNELS: &str = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
        const NORMAL: &str = "property float nx\nproperty float ny\nproperty float nz\n";
        let on = |on: bool, text: &'static str| if on { text } else { "" };
        let properties =
            |attributes: &[Attribute]| attributes.iter().map(Attribute::property).collect::<String>();
        let count = |is_large: bool| if is_large { "int" } else { "uchar" };
        let uvs = format!("property list {} float texcoord\n", count(self.has_many_uvs));
        let float = if self.pieces.is_far() { "double" } else { "float" };
        let images =
            self.textures.names.iter().map(|name| format!("comment TextureFile {}\n", on_one_line(name)));
        let images: String = images.collect();
        let mut out = Vec::new();
        // Writing to memory doesn't fail.
        let _ = write!(
            out,
            "ply\nformat {format} 1.0\ncomment Written by Meshwright\n{images}\
             element vertex {}\nproperty {float} x\nproperty {float} y\nproperty {float} z\n{}{}{}\
             element face {}\nproperty list {} int vertex_indices\n{}{}{}{}end_header\n",
            self.pieces.vertices,
            on(self.normals.is_some(), NORMAL),
            on(self.vertex_colors.is_some(), CHANNELS),
            properties(&self.vertex_attributes),
            self.pieces.faces,
            count(self.has_large_faces),
            if self.has_uvs { &uvs } else { "" },
            on(self.textures.numbers.is_some(), "property int texnumber\n"),
            on(self.face_colors.is_some(), CHANNELS),
            properties(&self.face_attributes),
        );
        out
    }

    /// The file and the images that it names.
    fn files(self, name: &str, bytes: Vec<u8>) -> Vec<NamedBytes> {
        let mut files = vec![NamedBytes { name: format!("{name}.ply"), bytes }];
        files.extend(self.textures.files);
        files
    }
}

/// Writes a binary PLY, little-endian.
pub(super) fn write(model: &Model) -> Result<Vec<NamedBytes>, WriteError> {
    let parts = Parts::new(model);
    // Vertex numbers are signed in practice.
    if parts.pieces.vertices > i32::MAX as u64 {
        return Err(WriteError::new("PLY numbers at most 2147483647 vertices: save as OBJ instead"));
    }
    let mut out = parts.head("binary_little_endian");
    let is_far = parts.pieces.is_far();
    for (v, (position, offset)) in parts.pieces.positions().enumerate() {
        if is_far {
            let at = (position.as_dvec3() + offset).to_array();
            out.extend(at.into_iter().flat_map(f64::to_le_bytes));
        } else {
            out.extend(position.to_array().into_iter().flat_map(f32::to_le_bytes));
        }
        out.extend(parts.normal(v).into_iter().flatten().flat_map(f32::to_le_bytes));
        out.extend(parts.vertex_color(v).into_iter().flatten());
        parts.vertex_attributes.iter().for_each(|attribute| attribute.push_binary(v, &mut out));
    }
    let push_count = |out: &mut Vec<u8>, count: usize, is_large: bool| match is_large {
        true => out.extend_from_slice(&(count as i32).to_le_bytes()),
        false => out.push(count as u8),
    };
    let mut uvs = Vec::new();
    for (f, (mesh, first, face)) in parts.pieces.faces().enumerate() {
        push_count(&mut out, mesh.face_degree(face), parts.has_large_faces);
        for v in mesh.face_vertices(face) {
            out.extend_from_slice(&((first + u64::from(v.raw())) as i32).to_le_bytes());
        }
        if parts.has_uvs {
            parts.uvs(mesh, face, &mut uvs);
            push_count(&mut out, uvs.len(), parts.has_many_uvs);
            out.extend(uvs.iter().flat_map(|c| c.to_le_bytes()));
        }
        out.extend(parts.textures.number(f).into_iter().flat_map(i32::to_le_bytes));
        out.extend(parts.face_color(f).into_iter().flatten());
        parts.face_attributes.iter().for_each(|attribute| attribute.push_binary(f, &mut out));
    }
    Ok(parts.files(&model.name, out))
}

/// Writes a PLY as text.
pub(super) fn write_text(model: &Model) -> Vec<NamedBytes> {
    let parts = Parts::new(model);
    let mut out = parts.head("ascii");
    for (v, (position, offset)) in parts.pieces.positions().enumerate() {
        push_position(&mut out, position, offset);
        push_floats(&mut out, parts.normal(v).as_ref().map_or(&[], |normal| normal.as_slice()));
        push_channels(&mut out, parts.vertex_color(v));
        parts.vertex_attributes.iter().for_each(|attribute| attribute.push_text(v, &mut out));
        out.push(b'\n');
    }
    let mut uvs = Vec::new();
    for (f, (mesh, first, face)) in parts.pieces.faces().enumerate() {
        push_integer(&mut out, mesh.face_degree(face) as u64);
        for v in mesh.face_vertices(face) {
            out.push(b' ');
            push_integer(&mut out, first + u64::from(v.raw()));
        }
        if parts.has_uvs {
            parts.uvs(mesh, face, &mut uvs);
            out.push(b' ');
            push_integer(&mut out, uvs.len() as u64);
            push_floats(&mut out, &uvs);
        }
        if let Some(texture) = parts.textures.number(f) {
            out.extend_from_slice(format!(" {texture}").as_bytes());
        }
        push_channels(&mut out, parts.face_color(f));
        parts.face_attributes.iter().for_each(|attribute| attribute.push_text(f, &mut out));
        out.push(b'\n');
    }
    parts.files(&model.name, out)
}

fn push_channels(out: &mut Vec<u8>, channels: Option<[u8; 3]>) {
    for channel in channels.into_iter().flatten() {
        out.push(b' ');
        push_integer(out, u64::from(channel));
    }
}

/// A channel from 0 to 1 as a byte.
pub(super) fn byte(channel: f32) -> u8 {
    (channel * 255.0).round().clamp(0.0, 255.0) as u8
}

/// A name without what would end its line.
fn on_one_line(name: &str) -> String {
    name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}
