//! Writing Bezier curves and surfaces; points read back bit for bit.

use crate::file::NamedBytes;
use crate::model::Model;
use crate::text::print::{push_floats, push_integer};
use glam::Vec3;

/// Writes the patches of all surfaces as one surface; nothing where there is none.
pub(crate) fn write_surface(model: &Model) -> Vec<NamedBytes> {
    let beziers = model.objects.iter().filter_map(|object| object.bezier.as_ref());
    let patches: Vec<_> = beziers.flat_map(|bezier| bezier.patches()).collect();
    if patches.is_empty() {
        return Vec::new();
    }
    let mut out = Vec::new();
    push_integer(&mut out, patches.len() as u64);
    out.push(b'\n');
    for patch in patches {
        for row in patch.rows {
            line(&mut out, row.map(|point| point.to_array()).as_flattened());
        }
        out.push(b'\n');
    }
    vec![NamedBytes { name: format!("{}.bez", model.name), bytes: out }]
}

/// Writes each curve to a file of its own: the format holds one.
pub(crate) fn write_curves(model: &Model) -> Vec<NamedBytes> {
    let name = &model.name;
    let curves = model.objects.iter().filter_map(|object| object.bezier.as_ref()?.curve());
    let file = |(at, points): (usize, &[Vec3])| {
        let name = if at == 0 { format!("{name}.bzc") } else { format!("{name}-{}.bzc", at + 1) };
        NamedBytes { name, bytes: curve(points) }
    };
    curves.map(|curve| curve.points.as_slice()).enumerate().map(file).collect()
}

fn curve(points: &[Vec3]) -> Vec<u8> {
    let mut out = Vec::new();
    push_integer(&mut out, points.len() as u64);
    out.push(b'\n');
    let is_plane = points.iter().all(|point| point.z.to_bits() == 0);
    for point in points {
        let coordinates = point.to_array();
        line(&mut out, if is_plane { &coordinates[..2] } else { &coordinates });
    }
    out
}

fn line(out: &mut Vec<u8>, numbers: &[f32]) {
    let start = out.len();
    push_floats(out, numbers);
    // The blank that comes before each number.
    out.remove(start);
    out.push(b'\n');
}
