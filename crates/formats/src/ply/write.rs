//! Writing a PLY, binary or text; positions read back bit for bit.

use crate::export::{ObjectRef, WriteError};
use crate::import::NamedBytes;
use crate::pieces::Pieces;
use crate::text::{push_integer, push_position};
use halfedge::Color;
use std::io::Write;

/// Writes a binary PLY, little-endian.
pub(crate) fn write(name: &str, objects: &[ObjectRef]) -> Result<Vec<NamedBytes>, WriteError> {
    let pieces = Pieces::new(objects);
    // Vertex numbers are signed in practice.
    if pieces.vertices > i32::MAX as u64 {
        return Err(WriteError::new("PLY numbers at most 2147483647 vertices: save as OBJ instead"));
    }
    let vertex_colors = pieces.vertex_colors();
    let face_colors = pieces.face_colors();
    let mut out = head("binary_little_endian", &pieces, vertex_colors.is_some(), face_colors.is_some());
    let is_far = pieces.is_far();
    for (v, (position, offset)) in pieces.positions().enumerate() {
        if is_far {
            let at = (position.as_dvec3() + offset).to_array();
            out.extend(at.into_iter().flat_map(f64::to_le_bytes));
        } else {
            out.extend(position.to_array().into_iter().flat_map(f32::to_le_bytes));
        }
        if let Some(color) = vertex_colors.as_ref().and_then(|colors| colors.get(v)) {
            out.extend_from_slice(&color.to_array().map(byte));
        }
    }
    for (f, (mesh, first, face)) in pieces.faces().enumerate() {
        let corners = mesh.face_degree(face);
        out.extend_from_slice(&(corners as u32).to_le_bytes());
        for v in mesh.face_vertices(face) {
            out.extend_from_slice(&((first + u64::from(v.raw())) as i32).to_le_bytes());
        }
        if let Some(Color(channels)) = face_colors.as_ref().and_then(|colors| colors.get(f)) {
            out.extend_from_slice(channels);
        }
    }
    Ok(vec![NamedBytes { name: format!("{name}.ply"), bytes: out }])
}

/// Writes a PLY as text.
pub(crate) fn write_text(name: &str, objects: &[ObjectRef]) -> Vec<NamedBytes> {
    let pieces = Pieces::new(objects);
    let vertex_colors = pieces.vertex_colors();
    let face_colors = pieces.face_colors();
    let mut out = head("ascii", &pieces, vertex_colors.is_some(), face_colors.is_some());
    for (v, (position, offset)) in pieces.positions().enumerate() {
        push_position(&mut out, position, offset);
        if let Some(color) = vertex_colors.as_ref().and_then(|colors| colors.get(v)) {
            push_channels(&mut out, color.to_array().map(byte));
        }
        out.push(b'\n');
    }
    for (f, (mesh, first, face)) in pieces.faces().enumerate() {
        push_integer(&mut out, mesh.face_degree(face) as u64);
        for v in mesh.face_vertices(face) {
            out.push(b' ');
            push_integer(&mut out, first + u64::from(v.raw()));
        }
        if let Some(&Color(channels)) = face_colors.as_ref().and_then(|colors| colors.get(f)) {
            push_channels(&mut out, channels);
        }
        out.push(b'\n');
    }
    vec![NamedBytes { name: format!("{name}.ply"), bytes: out }]
}

fn push_channels(out: &mut Vec<u8>, channels: [u8; 3]) {
    for channel in channels {
        out.push(b' ');
        push_integer(out, u64::from(channel));
    }
}

/// A channel from 0 to 1 as a byte.
fn byte(channel: f32) -> u8 {
    (channel * 255.0).round().clamp(0.0, 255.0) as u8
}

fn head(format: &str, pieces: &Pieces, vertex_colors: bool, face_colors: bool) -> Vec<u8> {
    const CHANNELS: &str = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    let channels = |on: bool| if on { CHANNELS } else { "" };
    let float = if pieces.is_far() { "double" } else { "float" };
    let mut out = Vec::new();
    // Writing to memory doesn't fail.
    let _ = write!(
        out,
        "ply\nformat {format} 1.0\ncomment Written by Meshwright\n\
         element vertex {}\nproperty {float} x\nproperty {float} y\nproperty {float} z\n{}\
         element face {}\nproperty list uint int vertex_indices\n{}end_header\n",
        pieces.vertices,
        channels(vertex_colors),
        pieces.faces,
        channels(face_colors)
    );
    out
}
