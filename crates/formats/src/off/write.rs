//! Writing an OFF; positions read back to the bit.

use crate::file::NamedBytes;
use crate::model::Model;
use crate::soup::pieces::Pieces;
use crate::text::print::{push_floats, push_integer, push_position};

/// Writes the objects as one OFF, with texture coordinates (`ST`), colours (`C`) and normals (`N`) of vertices, in
/// Geomview's order.
pub(crate) fn write(model: &Model) -> Vec<NamedBytes> {
    let pieces = Pieces::new(model);
    let vertex_colors = pieces.vertex_colors();
    let face_colors = pieces.face_colors();
    let (normals, uvs) = (pieces.vertex_normals(), pieces.vertex_uvs());
    let prefix = |there: bool, prefix: &'static str| if there { prefix } else { "" };
    let mut out = format!(
        "{}{}{}OFF\n{} {} 0\n",
        prefix(uvs.is_some(), "ST"),
        prefix(vertex_colors.is_some(), "C"),
        prefix(normals.is_some(), "N"),
        pieces.vertices,
        pieces.faces
    )
    .into_bytes();
    for (v, (position, offset)) in pieces.positions().enumerate() {
        push_position(&mut out, position, offset);
        if let Some(normal) = normals.as_ref().and_then(|normals| normals.get(v)) {
            push_floats(&mut out, &normal.to_array());
        }
        if let Some(color) = vertex_colors.as_ref().and_then(|colors| colors.get(v)) {
            push_floats(&mut out, &color.extend(1.0).to_array());
        }
        if let Some(uv) = uvs.as_ref().and_then(|uvs| uvs.get(v)) {
            push_floats(&mut out, &uv.to_array());
        }
        out.push(b'\n');
    }
    for (f, (mesh, first, face)) in pieces.faces().enumerate() {
        push_integer(&mut out, mesh.face_degree(face) as u64);
        for v in mesh.face_vertices(face) {
            out.push(b' ');
            push_integer(&mut out, first + u64::from(v.raw()));
        }
        for &channel in
            face_colors.as_ref().and_then(|colors| colors.get(f)).iter().flat_map(|color| &color.0)
        {
            out.push(b' ');
            push_integer(&mut out, u64::from(channel));
        }
        out.push(b'\n');
    }
    vec![NamedBytes { name: format!("{}.off", model.name), bytes: out }]
}
