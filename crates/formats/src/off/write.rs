//! Writing an OFF; positions read back bit for bit.

use crate::export::ObjectRef;
use crate::import::NamedBytes;
use crate::pieces::Pieces;
use crate::text::{push_floats, push_integer, push_position};

/// Writes the objects as one OFF, or COFF where vertices have colours.
pub(crate) fn write(name: &str, objects: &[ObjectRef]) -> Vec<NamedBytes> {
    let pieces = Pieces::new(objects);
    let vertex_colors = pieces.vertex_colors();
    let face_colors = pieces.face_colors();
    let keyword = if vertex_colors.is_some() { "COFF" } else { "OFF" };
    let mut out = format!("{keyword}\n{} {} 0\n", pieces.vertices, pieces.faces).into_bytes();
    for (v, (position, offset)) in pieces.positions().enumerate() {
        push_position(&mut out, position, offset);
        if let Some(color) = vertex_colors.as_ref().and_then(|colors| colors.get(v)) {
            push_floats(&mut out, &color.extend(1.0).to_array());
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
    vec![NamedBytes { name: format!("{name}.off"), bytes: out }]
}
