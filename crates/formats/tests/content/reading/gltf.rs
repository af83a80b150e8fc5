//! Samples of glTF, as JSON and as a binary file.

use super::Becomes::{self, Kept, Named};
use super::Kind::{self, *};
use super::*;
use base64::Engine;
use serde_json::{Value, json};

/// A document, its binary data, and what becomes of the content.
type Sample = (Value, Vec<u8>, Becomes);

/// The sample as JSON with its data inside.
pub fn text(kind: Kind) -> Option<(Vec<NamedBytes>, Becomes)> {
    let (document, data, becomes) = sample(kind)?;
    Some((text_files(document, data), becomes))
}

/// The sample as a binary file.
pub fn binary(kind: Kind) -> Option<(Vec<NamedBytes>, Becomes)> {
    let (document, data, becomes) = sample(kind)?;
    Some((binary_files(document, data), becomes))
}

fn sample(kind: Kind) -> Option<Sample> {
    let mut data = Vec::new();
    let mut views = Vec::new();
    let mut accessors = Vec::new();
    let mut add = |values: &[f32], kind: &str, count: usize| {
        views.push(json!({ "buffer": 0, "byteOffset": data.len(), "byteLength": values.len() * 4 }));
        data.extend(values.iter().flat_map(|value| value.to_le_bytes()));
        accessors.push(
            json!({ "bufferView": views.len() - 1, "componentType": 5126, "count": count, "type": kind }),
        );
        accessors.len() - 1
    };
    let position = add(&[0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0], "VEC3", 3);
    let z = add(&[0.0, 0.0, 1.0].repeat(3), "VEC3", 3);
    let uv = add(&[0.5, 0.75].repeat(3), "VEC2", 3);
    let red = add(&[1.0, 0.0, 0.0].repeat(3), "VEC3", 3);
    let four = add(&[1.0, 0.0, 0.0, 0.0].repeat(3), "VEC4", 3);
    let far = add(&[9.0; 3], "VEC3", 1);
    let matrix =
        add(&[1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0], "MAT4", 1);
    let time = add(&[0.0], "SCALAR", 1);
    let primitive = |attributes: Value| json!({ "attributes": attributes, "material": 0 });
    let base = json!({ "POSITION": position });
    let mut primitives = vec![primitive(base.clone())];
    let mut material = json!({ "name": "m" });
    let mut node = json!({ "name": "part", "mesh": 0 });
    let mut more = json!({});
    let with = |name: &str, accessor: usize| vec![primitive(json!({ "POSITION": position, name: accessor }))];
    let becomes = match kind {
        Materials => {
            material["pbrMetallicRoughness"] = json!({ "roughnessFactor": 0.25 });
            Kept(has_roughness)
        }
        Textures => {
            material["pbrMetallicRoughness"] = json!({ "baseColorTexture": { "index": 0 } });
            more = json!({ "textures": [{ "source": 0 }], "images": [{ "uri": "a.png" }] });
            primitives = with("TEXCOORD_0", uv);
            Kept(has_texture)
        }
        FaceColors => {
            material["pbrMetallicRoughness"] = json!({ "baseColorFactor": [1, 0, 0, 1] });
            Kept(has_red_faces)
        }
        VertexColors => {
            primitives = with("COLOR_0", red);
            Kept(has_vertex_color)
        }
        Normals => {
            primitives = with("NORMAL", z);
            Kept(has_normal)
        }
        TextureCoordinates => {
            primitives = with("TEXCOORD_0", uv);
            Kept(has_uv)
        }
        SecondTextureCoordinates => {
            primitives = vec![primitive(json!({ "POSITION": position, "TEXCOORD_0": uv, "TEXCOORD_1": uv }))];
            Named("TEXCOORD_1")
        }
        Names => Kept(has_name),
        Skins => {
            primitives =
                vec![primitive(json!({ "POSITION": position, "JOINTS_0": four, "WEIGHTS_0": four }))];
            node["skin"] = json!(0);
            more = json!({ "skins": [{ "joints": [0], "inverseBindMatrices": matrix }] });
            Named("1 joint and their weights are not kept")
        }
        Morphs => {
            let mut morphing = primitive(base.clone());
            morphing["targets"] = json!([{ "POSITION": z }]);
            primitives = vec![morphing];
            Named("morph")
        }
        Animations => {
            more = json!({ "animations": [{
                "channels": [{ "sampler": 0, "target": { "node": 0, "path": "translation" } }],
                "samplers": [{ "input": time, "output": far }]
            }] });
            Named("1 animation")
        }
        Lines => {
            primitives.push(json!({ "attributes": base, "mode": 1 }));
            Named("lines")
        }
        Points => {
            primitives.push(json!({ "attributes": { "POSITION": far }, "mode": 0 }));
            Kept(has_point)
        }
        Cameras => {
            more =
                json!({ "cameras": [{ "type": "perspective", "perspective": { "yfov": 1, "znear": 1 } }] });
            Named("1 camera")
        }
        Lights => {
            more = json!({
                "extensionsUsed": ["KHR_lights_punctual"],
                "extensions": { "KHR_lights_punctual": { "lights": [{ "type": "point" }] } }
            });
            Named("light")
        }
        CustomAttributes => {
            primitives = with("_QUALITY", z);
            Named("_QUALITY")
        }
        Metadata => {
            node["extras"] = json!({ "made": "by x" });
            Named("extras")
        }
        Groups => return None,
    };
    let mut document = json!({
        "asset": { "version": "2.0" },
        "scene": 0,
        "scenes": [{ "nodes": [0] }],
        "nodes": [node],
        "meshes": [{ "primitives": primitives }],
        "materials": [material],
        "bufferViews": views,
        "accessors": accessors,
        "buffers": [{ "byteLength": data.len() }],
    });
    if let (Value::Object(document), Value::Object(more)) = (&mut document, more) {
        document.extend(more);
    }
    Some((document, data, becomes))
}

fn text_files(mut document: Value, data: Vec<u8>) -> Vec<NamedBytes> {
    let text = base64::engine::general_purpose::STANDARD.encode(data);
    document["buffers"][0]["uri"] = json!(format!("data:application/octet-stream;base64,{text}"));
    vec![NamedBytes::new("a.gltf", document.to_string()), image()]
}

fn binary_files(document: Value, data: Vec<u8>) -> Vec<NamedBytes> {
    let mut json = document.to_string().into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut bytes =
        [&b"glTF"[..], &2u32.to_le_bytes(), &((28 + json.len() + data.len()) as u32).to_le_bytes()].concat();
    for (kind, chunk) in [(b"JSON", json), (b"BIN\0", data)] {
        bytes.extend((chunk.len() as u32).to_le_bytes());
        bytes.extend(kind);
        bytes.extend(chunk);
    }
    vec![NamedBytes::new("a.glb", bytes), image()]
}
