//! Writing an STL, binary or text.

use super::binary::{HEADER_BYTES, TITLE};
use super::color;
use crate::error::WriteError;
use crate::file::NamedBytes;
use crate::model::{Model, NamedMesh};
use crate::text::print::{push_floats, push_position};
use glam::{DVec3, Vec3};
use halfedge::geometry::MeshTriangulator;
use halfedge::{Element, FaceId, keys};

/// Writes a binary STL, with colours of faces in VisCAM's convention.
pub(super) fn write(model: &Model) -> Result<Vec<NamedBytes>, WriteError> {
    let mut out = TITLE.as_bytes().to_vec();
    out.resize(HEADER_BYTES + 4, 0);
    let mut count = 0u64;
    for_each_triangle(model, |object, face, normal, corners| {
        // There are 32 bits for a coordinate, however far away it is.
        let far = |corner: Vec3| (corner.as_dvec3() + model.offset).as_vec3();
        let corners = if model.offset == DVec3::ZERO { *corners } else { corners.map(far) };
        for point in [normal].iter().chain(&corners) {
            for c in point.to_array() {
                out.extend_from_slice(&c.to_le_bytes());
            }
        }
        let color = object.mesh.get(keys::FACE_COLOR, face.index());
        out.extend_from_slice(&color::attribute(color).to_le_bytes());
        count += 1;
    });
    let Ok(count) = u32::try_from(count) else {
        return Err(WriteError::new("STL numbers at most 4294967295 triangles: save as OBJ instead"));
    };
    if let Some(place) = out.get_mut(HEADER_BYTES..HEADER_BYTES + 4) {
        place.copy_from_slice(&count.to_le_bytes());
    }
    Ok(vec![NamedBytes { name: format!("{}.stl", model.name), bytes: out }])
}

/// Writes an STL as text. Each group of faces that follow each other is a solid; faces without one are a solid
/// named after the file, or after the object where there are several.
pub(super) fn write_text(model: &Model) -> Vec<NamedBytes> {
    let mut out = Vec::new();
    let mut current: Option<String> = None;
    let mut last = None;
    for_each_triangle(model, |object, face, normal, corners| {
        let group = object.mesh.get(keys::FACE_GROUP, face.index());
        let place = Some((std::ptr::from_ref(object), group));
        if last != place {
            last = place;
            let name = solid_name(model, object, group);
            if current.as_ref() != Some(&name) {
                end_solid(&mut out, current.take());
                push_line(&mut out, "solid", &name);
                current = Some(name);
            }
        }
        out.extend_from_slice(b"facet normal");
        push_floats(&mut out, &normal.to_array());
        out.extend_from_slice(b"\nouter loop\n");
        for corner in corners {
            out.extend_from_slice(b"vertex");
            push_position(&mut out, *corner, model.offset);
            out.push(b'\n');
        }
        out.extend_from_slice(b"endloop\nendfacet\n");
    });
    if current.is_none() {
        push_line(&mut out, "solid", &clean(&model.name));
        current = Some(clean(&model.name));
    }
    end_solid(&mut out, current);
    vec![NamedBytes { name: format!("{}.stl", model.name), bytes: out }]
}

/// The name of the solid of a group's faces. Faces without a group have none in a mesh that has groups.
fn solid_name(model: &Model, object: &NamedMesh, group: u32) -> String {
    let groups = object.mesh.column(Element::Face, keys::FACE_GROUP.name);
    match groups.and_then(|groups| groups.labels.get(group as usize)) {
        Some(label) => clean(label),
        None if groups.is_some_and(|groups| !groups.labels.is_empty()) => String::new(),
        None if model.objects.len() > 1 => clean(&object.name),
        None => clean(&model.name),
    }
}

/// A name as it can stand on a line.
fn clean(name: &str) -> String {
    let name: String = name.chars().map(|c| if c.is_control() { ' ' } else { c }).collect();
    name.trim().to_owned()
}

fn push_line(out: &mut Vec<u8>, word: &str, name: &str) {
    out.extend_from_slice(word.as_bytes());
    if !name.is_empty() {
        out.push(b' ');
        out.extend_from_slice(name.as_bytes());
    }
    out.push(b'\n');
}

fn end_solid(out: &mut Vec<u8>, name: Option<String>) {
    if let Some(name) = name {
        push_line(out, "endsolid", &name);
    }
}

/// All faces cut into triangles, with their unit normals; zero where a triangle has no area.
fn for_each_triangle(model: &Model, mut take: impl FnMut(&NamedMesh, FaceId, Vec3, &[Vec3; 3])) {
    for object in &model.objects {
        let mesh = &object.mesh;
        let mut triangulator = MeshTriangulator::new(mesh);
        for f in mesh.faces() {
            for corners in triangulator.triangulate_face(f) {
                let [a, b, c] = corners.map(|h| mesh.position(mesh.from(h)));
                take(object, f, (b - a).cross(c - a).normalize_or_zero(), &[a, b, c]);
            }
        }
    }
}
