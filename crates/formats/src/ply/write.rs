//! Writing a PLY, binary or text; positions read back bit for bit.

use crate::error::WriteError;
use crate::file::NamedBytes;
use crate::model::Model;
use crate::soup::pieces::Pieces;
use crate::text::print::{push_floats, push_integer, push_position};
use glam::Vec3;
use halfedge::{Color, FaceId, Mesh, keys};
use std::io::Write;

/// What there is to write of the vertices and faces of all objects.
struct Parts<'a> {
    pieces: Pieces<'a>,
    vertex_colors: Option<Vec<Vec3>>,
    normals: Option<Vec<Vec3>>,
    face_colors: Option<Vec<Color>>,
    uvs: bool,
    /// Whether a face has more texture coordinates than one byte counts; readers like the byte.
    long: bool,
}

impl<'a> Parts<'a> {
    fn new(model: &'a Model) -> Self {
        let pieces = Pieces::new(model);
        Self {
            vertex_colors: pieces.vertex_colors(),
            normals: pieces.vertex_normals(),
            face_colors: pieces.face_colors(),
            uvs: pieces.has_uvs(),
            long: pieces.has_uvs() && pieces.faces().any(|(mesh, _, f)| mesh.face_degree(f) > 127),
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
        let uvs = if self.long {
            "property list uint float texcoord\n"
        } else {
            "property list uchar float texcoord\n"
        };
        let float = if self.pieces.is_far() { "double" } else { "float" };
        let mut out = Vec::new();
        // Writing to memory doesn't fail.
        let _ = write!(
            out,
            "ply\nformat {format} 1.0\ncomment Written by Meshwright\n\
             element vertex {}\nproperty {float} x\nproperty {float} y\nproperty {float} z\n{}{}\
             element face {}\nproperty list uint int vertex_indices\n{}{}end_header\n",
            self.pieces.vertices,
            on(self.normals.is_some(), NORMAL),
            on(self.vertex_colors.is_some(), CHANNELS),
            self.pieces.faces,
            on(self.uvs, uvs),
            on(self.face_colors.is_some(), CHANNELS)
        );
        out
    }
}

/// Writes a binary PLY, little-endian.
pub(crate) fn write(model: &Model) -> Result<Vec<NamedBytes>, WriteError> {
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
    }
    let mut uvs = Vec::new();
    for (f, (mesh, first, face)) in parts.pieces.faces().enumerate() {
        out.extend_from_slice(&(mesh.face_degree(face) as u32).to_le_bytes());
        for v in mesh.face_vertices(face) {
            out.extend_from_slice(&((first + u64::from(v.raw())) as i32).to_le_bytes());
        }
        if parts.uvs {
            parts.uvs(mesh, face, &mut uvs);
            match parts.long {
                true => out.extend_from_slice(&(uvs.len() as u32).to_le_bytes()),
                false => out.push(uvs.len() as u8),
            }
            out.extend(uvs.iter().flat_map(|c| c.to_le_bytes()));
        }
        out.extend(parts.face_color(f).into_iter().flatten());
    }
    Ok(vec![NamedBytes { name: format!("{}.ply", model.name), bytes: out }])
}

/// Writes a PLY as text.
pub(crate) fn write_text(model: &Model) -> Vec<NamedBytes> {
    let parts = Parts::new(model);
    let mut out = parts.head("ascii");
    for (v, (position, offset)) in parts.pieces.positions().enumerate() {
        push_position(&mut out, position, offset);
        push_floats(&mut out, parts.normal(v).as_ref().map_or(&[], |normal| normal.as_slice()));
        push_channels(&mut out, parts.vertex_color(v));
        out.push(b'\n');
    }
    let mut uvs = Vec::new();
    for (f, (mesh, first, face)) in parts.pieces.faces().enumerate() {
        push_integer(&mut out, mesh.face_degree(face) as u64);
        for v in mesh.face_vertices(face) {
            out.push(b' ');
            push_integer(&mut out, first + u64::from(v.raw()));
        }
        if parts.uvs {
            parts.uvs(mesh, face, &mut uvs);
            out.push(b' ');
            push_integer(&mut out, uvs.len() as u64);
            push_floats(&mut out, &uvs);
        }
        push_channels(&mut out, parts.face_color(f));
        out.push(b'\n');
    }
    vec![NamedBytes { name: format!("{}.ply", model.name), bytes: out }]
}

fn push_channels(out: &mut Vec<u8>, channels: Option<[u8; 3]>) {
    for channel in channels.into_iter().flatten() {
        out.push(b' ');
        push_integer(out, u64::from(channel));
    }
}

/// A channel from 0 to 1 as a byte.
fn byte(channel: f32) -> u8 {
    (channel * 255.0).round().clamp(0.0, 255.0) as u8
}
