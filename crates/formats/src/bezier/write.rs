//! Writing Bezier curves and surfaces; points read back bit for bit.

use crate::file::NamedBytes;
use crate::model::Model;
use crate::text::print::{push_integer, push_position};
use glam::{DVec3, Vec3};

/// Writes the patches of all surfaces as one surface; no file where there is none.
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
            line(&mut out, |out| row.iter().for_each(|&point| push_position(out, point, model.offset)));
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
        NamedBytes { name, bytes: curve(points, model.offset) }
    };
    curves.map(|curve| curve.points.as_slice()).enumerate().map(file).collect()
}

/// A curve in the plane z = 0 has two coordinates for each point.
fn curve(points: &[Vec3], offset: DVec3) -> Vec<u8> {
    let mut out = Vec::new();
    push_integer(&mut out, points.len() as u64);
    out.push(b'\n');
    let is_plane = offset.z == 0.0 && points.iter().all(|point| point.z.to_bits() == 0);
    for &point in points {
        line(&mut out, |out| {
            push_position(out, point, offset);
            if is_plane {
                // Without the last coordinate and the blank before it.
                let end = out.iter().rposition(|&byte| byte == b' ').unwrap_or(out.len());
                out.truncate(end);
            }
        });
    }
    out
}

/// Writes a line of numbers that each come with a blank before them, without the first blank.
fn line(out: &mut Vec<u8>, numbers: impl FnOnce(&mut Vec<u8>)) {
    let start = out.len();
    numbers(out);
    out.remove(start);
    out.push(b'\n');
}
