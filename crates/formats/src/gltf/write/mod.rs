//! Writing a document: one binary file, or JSON with data and images in files beside it.

mod data;
mod fields;
mod geometry;
mod material;
mod vertices;

use super::names::{BIN_CHUNK, GENERATOR, JSON_CHUNK, MAGIC};
use crate::error::WriteError;
use crate::file::NamedBytes;
use crate::format::loss;
use crate::model::Model;
use crate::model::images::media_type;
use crate::text::print::{percent_decoded, percent_encoded};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use data::Data;
use fields::set;
use geometry::primitives;
use glam::DVec3;
use material::MaterialWriter;
pub(super) use material::keeps;
use serde_json::{Value, json};

/// Writes a `.glb`, with images inside.
pub(super) fn write_binary(model: &Model) -> Result<Vec<NamedBytes>, WriteError> {
    let mut materials = MaterialWriter::new(model, None);
    let (document, mut bin) = document(model, &mut materials, None);
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

/// Writes a `.gltf`, with a `.bin` and images beside it.
pub(super) fn write_text(model: &Model) -> Vec<NamedBytes> {
    let data = format!("{}.bin", model.name);
    let json = format!("{}.gltf", model.name);
    let mut materials = MaterialWriter::new(model, Some([&json, &data]));
    let (document, bin) = document(model, &mut materials, Some(&data));
    let json = NamedBytes { name: json, bytes: document.to_string().into_bytes() };
    let mut files = vec![json, NamedBytes { name: data, bytes: bin }];
    files.extend(materials.image_files());
    files
}

/// What [`write_text`] wrote as one file, with its data and images inside.
pub(super) fn single_file(files: Vec<NamedBytes>) -> Option<NamedBytes> {
    let mut files = files.into_iter();
    let model = files.next()?;
    let companions: Vec<NamedBytes> = files.collect();
    let Ok(mut document) = serde_json::from_slice::<Value>(&model.bytes) else { return Some(model) };
    for list in ["buffers", "images"] {
        let items = document.get_mut(list).and_then(Value::as_array_mut);
        for uri in items.into_iter().flatten().filter_map(|item| item.get_mut("uri")) {
            let name = percent_decoded(uri.as_str().unwrap_or_default());
            let Some(file) = companions.iter().find(|file| file.name == name) else { continue };
            let kind = match list {
                "images" => media_type(&file.name, &file.bytes),
                _ => None,
            };
            let kind = kind.as_deref().unwrap_or("application/octet-stream");
            *uri = json!(format!("data:{kind};base64,{}", STANDARD.encode(&file.bytes)));
        }
    }
    Some(NamedBytes { name: model.name, bytes: document.to_string().into_bytes() })
}

/// Writes the document and its data; `uri` is the name of the data's file, if it has one of its own.
fn document(model: &Model, materials: &mut MaterialWriter, uri: Option<&str>) -> (Value, Vec<u8>) {
    let mut data = Data::default();
    let (mut meshes, mut nodes) = (Vec::new(), Vec::new());
    for object in &model.objects {
        let primitives = primitives(&object.mesh.to_compact(), &mut data, materials);
        let mut node = json!({ "name": object.name });
        if model.offset != DVec3::ZERO {
            set(&mut node, "translation", model.offset.to_array());
        }
        // A mesh needs a primitive, so an empty object becomes a node without a mesh.
        if !primitives.is_empty() {
            set(&mut node, "mesh", meshes.len());
            meshes.push(json!({ "name": object.name, "primitives": primitives }));
        }
        nodes.push(node);
    }
    let mut document = json!({
        "asset": { "version": "2.0", "generator": GENERATOR },
        "scene": 0,
        "scenes": [{ "nodes": (0..nodes.len()).collect::<Vec<_>>() }],
    });
    let lists = materials.finish(&mut data);
    let Data { bin, views, accessors } = data;
    let mut buffer = json!({ "byteLength": bin.len() });
    if let Some(uri) = uri {
        set(&mut buffer, "uri", percent_encoded(uri));
    }
    let buffers = if bin.is_empty() { Vec::new() } else { vec![buffer] };
    let own = [
        ("nodes", nodes),
        ("meshes", meshes),
        ("accessors", accessors),
        ("bufferViews", views),
        ("buffers", buffers),
    ];
    // The format allows no empty lists.
    for (key, list) in own.into_iter().chain(lists).filter(|(_, list)| !list.is_empty()) {
        set(&mut document, key, list);
    }
    (document, bin)
}

/// What else than polygons, groups and the like is lost of a model.
pub(super) fn losses(model: &Model) -> Vec<String> {
    loss::conflicting_triangles("glTF", model)
        .into_iter()
        .chain(vertices::losses(model))
        .chain(material::losses(model))
        .collect()
}
