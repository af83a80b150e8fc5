//! Writing Bezier curves and surfaces; points read back bit for bit.

use super::Controls;
use crate::export::ObjectRef;
use crate::import::NamedBytes;
use crate::text::{push_floats, push_integer};
use glam::Vec3;

/// Writes the patches of all objects that have some as one surface; nothing where none has.
pub(crate) fn write_surface(name: &str, objects: &[ObjectRef]) -> Vec<NamedBytes> {
    let patches: Vec<&[[Vec3; 4]; 4]> = objects
        .iter()
        .filter_map(|object| match object.controls {
            Some(Controls::Surface(patches)) => Some(patches),
            _ => None,
        })
        .flatten()
        .collect();
    if patches.is_empty() {
        return Vec::new();
    }
    let mut out = Vec::new();
    push_integer(&mut out, patches.len() as u64);
    out.push(b'\n');
    for patch in patches {
        for row in patch {
            line(&mut out, row.map(|point| point.to_array()).as_flattened());
        }
        out.push(b'\n');
    }
    vec![NamedBytes { name: format!("{name}.bez"), bytes: out }]
}

/// Writes each curve to a file of its own: the format holds one.
pub(crate) fn write_curves(name: &str, objects: &[ObjectRef]) -> Vec<NamedBytes> {
    let curves = objects.iter().filter_map(|object| match object.controls {
        Some(Controls::Curve(points)) => Some(points),
        _ => None,
    });
    let file = |(at, points): (usize, &Vec<Vec3>)| {
        let name = if at == 0 { format!("{name}.bzc") } else { format!("{name}-{}.bzc", at + 1) };
        NamedBytes { name, bytes: curve(points) }
    };
    curves.enumerate().map(file).collect()
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
