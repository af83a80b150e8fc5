//! Writing an STL, binary or text.

use crate::error::WriteError;
use crate::file::NamedBytes;
use crate::model::Model;
use crate::text::print::{push_floats, push_position};
use glam::{DVec3, Vec3};
use halfedge::geometry::PolygonTriangulator;

/// Writes a binary STL.
pub(crate) fn write(model: &Model) -> Result<Vec<NamedBytes>, WriteError> {
    let mut out = vec![0; 84];
    let title = b"Written by Meshwright";
    if let Some(place) = out.get_mut(..title.len()) {
        place.copy_from_slice(title);
    }
    let mut count = 0u64;
    for_each_triangle(model, |normal, corners, offset| {
        // There are 32 bits for a coordinate, however far away it is.
        let far = |corner: Vec3| (corner.as_dvec3() + offset).as_vec3();
        let corners = if offset == DVec3::ZERO { *corners } else { corners.map(far) };
        for point in [normal].iter().chain(&corners) {
            for c in point.to_array() {
                out.extend_from_slice(&c.to_le_bytes());
            }
        }
        out.extend_from_slice(&[0, 0]);
        count += 1;
    });
    let Ok(count) = u32::try_from(count) else {
        return Err(WriteError::new("STL numbers at most 4294967295 triangles: save as OBJ instead"));
    };
    if let Some(place) = out.get_mut(80..84) {
        place.copy_from_slice(&count.to_le_bytes());
    }
    Ok(vec![NamedBytes { name: format!("{}.stl", model.name), bytes: out }])
}

/// Writes an STL as text.
pub(crate) fn write_text(model: &Model) -> Vec<NamedBytes> {
    let title: String = model.name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    let mut out = format!("solid {title}\n").into_bytes();
    for_each_triangle(model, |normal, corners, offset| {
        out.extend_from_slice(b"facet normal");
        push_floats(&mut out, &normal.to_array());
        out.extend_from_slice(b"\nouter loop\n");
        for corner in corners {
            out.extend_from_slice(b"vertex");
            push_position(&mut out, *corner, offset);
            out.push(b'\n');
        }
        out.extend_from_slice(b"endloop\nendfacet\n");
    });
    out.extend_from_slice(format!("endsolid {title}\n").as_bytes());
    vec![NamedBytes { name: format!("{}.stl", model.name), bytes: out }]
}

/// All faces cut into triangles, with their unit normals; zero where a triangle has no area.
fn for_each_triangle(model: &Model, mut take: impl FnMut(Vec3, &[Vec3; 3], DVec3)) {
    let mut points = Vec::new();
    let mut triangulator = PolygonTriangulator::new();
    for (object, f) in model.objects.iter().flat_map(|object| object.mesh.faces().map(move |f| (object, f))) {
        points.clear();
        points.extend(object.mesh.face_vertices(f).map(|v| object.mesh.position(v)));
        for corners in triangulator.triangulate(&points) {
            let corner =
                |i: usize| corners.get(i).and_then(|&c| points.get(c as usize)).copied().unwrap_or_default();
            let [a, b, c] = [corner(0), corner(1), corner(2)];
            take((b - a).cross(c - a).normalize_or_zero(), &[a, b, c], model.offset);
        }
    }
}
