//! Writing meshes.

use super::data::Data;
use super::fields::set;
use super::material::MaterialWriter;
use super::vertices::{Vertices, has_coincident};
use crate::gltf::names::VERTEX_ID;
use halfedge::geometry::MeshTriangulator;
use halfedge::{Color, Element, Mesh, keys};
use serde_json::{Value, json};
use std::collections::HashMap;

/// Writes a mesh: its vertices once, a primitive of triangles for each material, and one of points for
/// vertices in no face.
pub(super) fn primitives(mesh: &Mesh, data: &mut Data, materials: &mut MaterialWriter) -> Vec<Value> {
    let vertices = Vertices::new(mesh);
    if vertices.positions.is_empty() {
        return Vec::new();
    }
    let mut attributes = json!({ "POSITION": data.floats(&vertices.positions, true) });
    if !vertices.normals.is_empty() {
        set(&mut attributes, "NORMAL", data.floats(&vertices.normals, false));
    }
    if !vertices.uvs.is_empty() {
        set(&mut attributes, "TEXCOORD_0", data.floats(&vertices.uvs, false));
    }
    if !vertices.colors.is_empty() {
        set(&mut attributes, "COLOR_0", data.floats(&vertices.colors, false));
    }
    if has_coincident(mesh) {
        set(&mut attributes, VERTEX_ID, data.ids(&vertices.ids));
    }
    let mut primitives: Vec<Value> = triangles(mesh, &vertices, materials)
        .into_iter()
        .map(|(material, indices)| {
            let mut primitive = json!({ "attributes": attributes, "indices": data.indices(&indices) });
            if let Some(material) = material {
                set(&mut primitive, "material", material);
            }
            primitive
        })
        .collect();
    if !vertices.isolated.is_empty() {
        let points = data.indices(&vertices.isolated);
        primitives.push(json!({ "attributes": attributes, "indices": points, "mode": 0 }));
    }
    primitives
}

/// The indices of the triangles of each material, in order of first use; faces of a material stay in order.
fn triangles(
    mesh: &Mesh,
    vertices: &Vertices,
    materials: &mut MaterialWriter,
) -> Vec<(Option<usize>, Vec<u32>)> {
    let mut order: Vec<(Option<usize>, Vec<u32>)> = Vec::new();
    let mut places: HashMap<Option<usize>, usize> = HashMap::new();
    let labels =
        mesh.column(Element::Face, keys::FACE_MATERIAL.name).map_or(&[][..], |column| &column.labels);
    let colors = mesh.attribute(keys::FACE_COLOR);
    let mut triangulator = MeshTriangulator::new(mesh);
    for f in mesh.faces() {
        let label = labels.get(mesh.get(keys::FACE_MATERIAL, f.index()) as usize).map_or("", String::as_str);
        let color = colors.and_then(|colors| colors.get(f.index())).copied();
        let is_plain = label.is_empty() && color.is_none_or(|color| color == Color::UNPAINTED);
        let material = (!is_plain).then(|| materials.number(label, color));
        let place = *places.entry(material).or_insert_with(|| {
            order.push((material, Vec::new()));
            order.len() - 1
        });
        if let Some((_, indices)) = order.get_mut(place) {
            let corners = triangulator.triangulate_face(f).iter().flatten();
            indices.extend(corners.map(|h| vertices.of_corner.get(h.index()).copied().unwrap_or(0)));
        }
    }
    order
}
