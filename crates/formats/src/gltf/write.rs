//! Writing a glTF, as one binary file or as JSON with its data beside it.

#![expect(clippy::indexing_slicing, reason = "the keys of JSON objects that are made here")]

use super::names::{BIN_CHUNK, GENERATOR, JSON_CHUNK, MAGIC, VERTEX_ID};
use crate::error::WriteError;
use crate::file::NamedBytes;
use crate::model::Model;
use crate::model::paint::{own_colors, painted};
use crate::model::srgb::to_linear;
use crate::soup::hash::Unique;
use crate::soup::weld::Weld;
use crate::text::print::percent_encoded;
use base64::Engine;
use glam::{DVec3, Vec2, Vec3};
use halfedge::geometry::PolygonTriangulator;
use halfedge::{Color, Element, Mesh, NONE, keys};
use serde_json::{Value, json};
use std::collections::HashMap;

/// Writes a `.glb`.
pub(crate) fn write_binary(model: &Model) -> Result<Vec<NamedBytes>, WriteError> {
    let (document, mut bin) = document(model, None);
    let mut json = document.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    bin.resize(bin.len().next_multiple_of(4), 0);
    let too_large = |_| WriteError::new("a GLB holds at most 4 GB: save as OBJ instead");
    let total = u32::try_from(12 + 8 + json.len() + 8 + bin.len()).map_err(too_large)?;
    let mut bytes = MAGIC.to_vec();
    bytes.extend_from_slice(&2u32.to_le_bytes());
    bytes.extend_from_slice(&total.to_le_bytes());
    for (kind, chunk) in [(JSON_CHUNK, &json), (BIN_CHUNK, &bin)] {
        bytes.extend_from_slice(&(chunk.len() as u32).to_le_bytes());
        bytes.extend_from_slice(&kind.to_le_bytes());
        bytes.extend_from_slice(chunk);
    }
    Ok(vec![NamedBytes { name: format!("{}.glb", model.name), bytes }])
}

/// Writes a `.gltf` and a `.bin` beside it.
pub(crate) fn write_text(model: &Model) -> Vec<NamedBytes> {
    let data = format!("{}.bin", model.name);
    let (document, bin) = document(model, Some(&data));
    let json = NamedBytes { name: format!("{}.gltf", model.name), bytes: document.to_string().into_bytes() };
    vec![json, NamedBytes { name: data, bytes: bin }]
}

/// What [`write_text`] wrote as one file, with its data inside.
pub(crate) fn single_file(files: Vec<NamedBytes>) -> Option<NamedBytes> {
    let mut files = files.into_iter();
    let model = files.next()?;
    Some(match files.next() {
        Some(data) => with_data(model, &data),
        None => model,
    })
}

fn with_data(json: NamedBytes, data: &NamedBytes) -> NamedBytes {
    let Ok(mut document) = serde_json::from_slice::<Value>(&json.bytes) else { return json };
    if let Some(buffer) = document.pointer_mut("/buffers/0") {
        let text = base64::engine::general_purpose::STANDARD.encode(&data.bytes);
        buffer["uri"] = json!(format!("data:application/octet-stream;base64,{text}"));
    }
    NamedBytes { name: json.name, bytes: document.to_string().into_bytes() }
}

fn document(model: &Model, uri: Option<&str>) -> (Value, Vec<u8>) {
    let mut writer = Writer { own_colors: own_colors(model, str::to_owned), ..Writer::default() };
    let (mut meshes, mut nodes) = (Vec::new(), Vec::new());
    for object in &model.objects {
        let mesh = object.mesh.to_compact();
        let primitives = writer.primitives(&mesh);
        let mut node = json!({ "name": object.name });
        if model.offset != DVec3::ZERO {
            node["translation"] = json!(model.offset.to_array());
        }
        // A mesh needs something to draw; an empty one stays a node by name.
        if !primitives.is_empty() {
            node["mesh"] = json!(meshes.len());
            meshes.push(json!({ "name": object.name, "primitives": primitives }));
        }
        nodes.push(node);
    }
    let mut document = json!({
        "asset": { "version": "2.0", "generator": GENERATOR },
        "scene": 0,
        "scenes": [{ "nodes": (0..nodes.len()).collect::<Vec<_>>() }],
        "nodes": nodes,
    });
    let mut buffer = json!({ "byteLength": writer.bin.len() });
    if let Some(uri) = uri {
        buffer["uri"] = json!(percent_encoded(uri));
    }
    // Empty lists are not allowed.
    for (key, list) in [
        ("meshes", meshes),
        ("materials", writer.materials),
        ("accessors", writer.accessors),
        ("bufferViews", writer.views),
        ("buffers", if writer.bin.is_empty() { Vec::new() } else { vec![buffer] }),
    ] {
        if !list.is_empty() {
            document[key] = Value::Array(list);
        }
    }
    (document, writer.bin)
}

#[derive(Default)]
struct Writer {
    bin: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
    materials: Vec<Value>,
    material_numbers: HashMap<(String, Option<Color>), usize>,
    /// The colours that go under materials' own names.
    own_colors: HashMap<String, Color>,
}

impl Writer {
    /// Adds rows of floats; gives the accessor.
    fn floats<const N: usize>(&mut self, rows: &[[f32; N]], bounds: bool) -> usize {
        let offset = self.bin.len();
        self.bin.extend(rows.iter().flatten().flat_map(|value| value.to_le_bytes()));
        let mut accessor = json!({ "componentType": 5126, "count": rows.len(), "type": format!("VEC{N}") });
        if bounds {
            let fold = |pick: fn(f32, f32) -> f32, start: f32| {
                (0..N)
                    .map(|i| rows.iter().filter_map(|row| row.get(i)).fold(start, |a, &b| pick(a, b)))
                    .collect::<Vec<_>>()
            };
            accessor["min"] = json!(fold(f32::min, f32::INFINITY));
            accessor["max"] = json!(fold(f32::max, f32::NEG_INFINITY));
        }
        self.accessor(offset, 34962, accessor)
    }

    /// Adds numbers of vertices as [`VERTEX_ID`] has them; gives the accessor.
    fn ids(&mut self, ids: &[u32]) -> usize {
        let offset = self.bin.len();
        self.bin.extend(ids.iter().flat_map(|id| id.to_le_bytes()));
        let accessor = json!({ "componentType": 5121, "count": ids.len(), "type": "VEC4" });
        self.accessor(offset, 34962, accessor)
    }

    fn indices(&mut self, indices: &[u32]) -> usize {
        let offset = self.bin.len();
        self.bin.extend(indices.iter().flat_map(|index| index.to_le_bytes()));
        self.accessor(
            offset,
            34963,
            json!({ "componentType": 5125, "count": indices.len(), "type": "SCALAR" }),
        )
    }

    fn accessor(&mut self, offset: usize, target: u32, mut accessor: Value) -> usize {
        accessor["bufferView"] = json!(self.views.len());
        self.views.push(json!({
            "buffer": 0, "byteOffset": offset, "byteLength": self.bin.len() - offset, "target": target
        }));
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    /// The vertices of a mesh once, a primitive for each material that uses them, and one of points
    /// for those in no face.
    fn primitives(&mut self, mesh: &Mesh) -> Vec<Value> {
        let vertices = Vertices::new(mesh);
        if vertices.positions.is_empty() {
            return Vec::new();
        }
        let mut attributes = json!({ "POSITION": self.floats(&vertices.positions, true) });
        if !vertices.normals.is_empty() {
            attributes["NORMAL"] = json!(self.floats(&vertices.normals, false));
        }
        if !vertices.uvs.is_empty() {
            attributes["TEXCOORD_0"] = json!(self.floats(&vertices.uvs, false));
        }
        if !vertices.colors.is_empty() {
            attributes["COLOR_0"] = json!(self.floats(&vertices.colors, false));
        }
        if has_coincident(mesh) {
            attributes[VERTEX_ID] = json!(self.ids(&vertices.ids));
        }
        // Triangles by material, in order of first use; faces of one material stay in order.
        let mut order: Vec<(Option<usize>, Vec<u32>)> = Vec::new();
        let mut places: HashMap<Option<usize>, usize> = HashMap::new();
        let labels =
            mesh.column(Element::Face, keys::FACE_MATERIAL.name).map_or(&[][..], |column| &column.labels);
        let colors = mesh.attribute(keys::FACE_COLOR);
        let (mut points, mut corners) = (Vec::new(), Vec::new());
        let mut triangulator = PolygonTriangulator::new();
        for f in mesh.faces() {
            let label =
                labels.get(mesh.get(keys::FACE_MATERIAL, f.index()) as usize).map_or("", String::as_str);
            let color = colors.and_then(|colors| colors.get(f.index())).copied();
            let plain = label.is_empty() && color.is_none_or(|color| color == Color::UNPAINTED);
            let material = (!plain).then(|| self.material(label, color));
            let place = *places.entry(material).or_insert_with(|| {
                order.push((material, Vec::new()));
                order.len() - 1
            });
            points.clear();
            corners.clear();
            for h in mesh.face_halfedges(f) {
                points.push(mesh.position(mesh.from(h)));
                corners.push(vertices.of_corner.get(h.index()).copied().unwrap_or(0));
            }
            if let Some((_, indices)) = order.get_mut(place) {
                let triangles = triangulator.triangulate(&points);
                indices.extend(triangles.iter().flatten().filter_map(|&c| corners.get(c as usize)));
            }
        }
        let mut primitives: Vec<Value> = order
            .into_iter()
            .map(|(material, indices)| {
                let mut primitive = json!({ "attributes": attributes, "indices": self.indices(&indices) });
                if let Some(material) = material {
                    primitive["material"] = json!(material);
                }
                primitive
            })
            .collect();
        if !vertices.loose.is_empty() {
            let points = self.indices(&vertices.loose);
            primitives.push(json!({ "attributes": attributes, "indices": points, "mode": 0 }));
        }
        primitives
    }

    fn material(&mut self, label: &str, color: Option<Color>) -> usize {
        let key = (label.to_owned(), color);
        if let Some(&number) = self.material_numbers.get(&key) {
            return number;
        }
        let name = match color {
            Some(color) if self.own_colors.get(label) != Some(&color) => painted(label, color),
            _ => label.to_owned(),
        };
        let mut surface = json!({ "metallicFactor": 0.0 });
        if let Some(Color(channels)) = color {
            let [r, g, b] = channels.map(|c| to_linear(f32::from(c) / 255.0));
            surface["baseColorFactor"] = json!([r, g, b, 1.0]);
        }
        let number = self.materials.len();
        self.materials.push(json!({ "name": name, "doubleSided": true, "pbrMetallicRoughness": surface }));
        self.material_numbers.insert(key, number);
        number
    }
}

/// Vertices as glTF has them: split where corners of one vertex differ, in order of ours.
#[derive(Default)]
struct Vertices {
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    uvs: Vec<[f32; 2]>,
    colors: Vec<[f32; 3]>,
    /// The mesh's vertex that each is one of.
    ids: Vec<u32>,
    /// Those in no face.
    loose: Vec<u32>,
    /// For each half-edge of a face the vertex of its corner.
    of_corner: Vec<u32>,
}

impl Vertices {
    fn new(mesh: &Mesh) -> Self {
        let mut this = Self { of_corner: vec![NONE; mesh.halfedge_capacity()], ..Self::default() };
        let corners = || mesh.halfedges().filter(|&h| !mesh.is_boundary_halfedge(h));
        // glTF has no way to leave a normal out: all corners have one, or none is written.
        let normals = mesh.attribute(keys::CORNER_NORMAL).filter(|normals| {
            corners().all(|h| normals.get(h.index()).is_some_and(|normal| !normal.is_nan()))
        });
        let uvs = mesh
            .attribute(keys::CORNER_UV)
            .filter(|uvs| corners().any(|h| uvs.get(h.index()).is_some_and(|uv| !uv.is_nan())));
        let colors =
            mesh.attribute(keys::VERTEX_COLOR).filter(|colors| colors.iter().any(|color| !color.is_nan()));
        let mut unique = Unique::new();
        for v in mesh.vertices() {
            let mut loose = true;
            // The vertex takes part in the comparison by the bits of its number.
            let id = f32::from_bits(v.raw());
            let push = |this: &mut Self, uv: Vec2, normal: Vec3| {
                this.positions.push(mesh.position(v).to_array());
                this.ids.push(v.raw());
                if normals.is_some() {
                    this.normals.push(normal.to_array());
                }
                if uvs.is_some() {
                    this.uvs.push([uv.x, 1.0 - uv.y]);
                }
                if let Some(color) = colors.and_then(|colors| colors.get(v.index())) {
                    let color = if color.is_nan() { Vec3::ONE } else { *color };
                    this.colors.push(color.to_array().map(to_linear));
                }
            };
            for h in mesh.outgoing(v).filter(|&h| !mesh.is_boundary_halfedge(h)) {
                let uv = uvs
                    .and_then(|uvs| uvs.get(h.index()))
                    .copied()
                    .filter(|uv| !uv.is_nan())
                    .unwrap_or(Vec2::ZERO);
                let normal = normals.and_then(|normals| normals.get(h.index())).copied().unwrap_or_default();
                let (number, new) = unique.number([id, uv.x, uv.y, normal.x, normal.y, normal.z]);
                if new {
                    push(&mut this, uv, normal);
                }
                loose = false;
                if let Some(corner) = this.of_corner.get_mut(h.index()) {
                    *corner = number;
                }
            }
            if loose {
                // Numbers go by what was added, so this takes one too.
                this.loose.push(unique.number([id, f32::NAN, 0.0, 0.0, 0.0, 0.0]).0);
                push(&mut this, Vec2::ZERO, Vec3::Z);
            }
        }
        this
    }
}

/// Whether two vertices lie at the same place.
fn has_coincident(mesh: &Mesh) -> bool {
    let mut places = Weld::new();
    mesh.vertices().for_each(|v| {
        places.vertex(mesh.position(v));
    });
    places.positions.len() < mesh.vertex_count()
}
