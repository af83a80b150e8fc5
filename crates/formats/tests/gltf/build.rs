//! Documents made for tests.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use formats::NamedBytes;
use serde_json::{Value, json};

/// A document with its data.
pub struct Doc {
    pub json: Value,
    pub bin: Vec<u8>,
}

/// The corners of a square, two triangles.
pub const SQUARE: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
pub const SQUARE_INDICES: [u16; 6] = [0, 1, 2, 0, 2, 3];

impl Doc {
    /// A document with nothing in it.
    pub fn new() -> Self {
        let empty = json!([]);
        let json = json!({
            "asset": { "version": "2.0" },
            "accessors": empty, "bufferViews": empty, "meshes": empty, "nodes": empty,
        });
        Self { json, bin: Vec::new() }
    }

    /// One mesh of a square, `"square"`, that node 0 shows. Accessor 0 has its positions, 1 its indices.
    pub fn square() -> Self {
        let mut doc = Self::new();
        let positions = doc.floats("VEC3", SQUARE.as_flattened());
        let indices = doc.shorts("SCALAR", &SQUARE_INDICES);
        doc.push(
            "meshes",
            json!({
                "name": "square",
                "primitives": [{ "attributes": { "POSITION": positions }, "indices": indices }],
            }),
        );
        doc.push("nodes", json!({ "mesh": 0 }));
        doc
    }

    /// Adds an item to a list, and returns its number.
    pub fn push(&mut self, list: &str, item: Value) -> usize {
        if self.json[list].is_null() {
            self.json[list] = json!([]);
        }
        let list = self.json[list].as_array_mut().expect("a list");
        list.push(item);
        list.len() - 1
    }

    /// Adds bytes, and returns their view.
    pub fn view(&mut self, bytes: &[u8]) -> usize {
        self.bin.resize(self.bin.len().next_multiple_of(4), 0);
        let offset = self.bin.len();
        self.bin.extend_from_slice(bytes);
        self.push("bufferViews", json!({ "buffer": 0, "byteOffset": offset, "byteLength": bytes.len() }))
    }

    fn accessor(&mut self, bytes: &[u8], component: u32, kind: &str, count: usize) -> usize {
        let view = self.view(bytes);
        let width = match kind {
            "SCALAR" => 1,
            "MAT4" => 16,
            vector => vector[3..].parse().expect("VEC and a number"),
        };
        let accessor =
            json!({ "bufferView": view, "componentType": component, "count": count / width, "type": kind });
        self.push("accessors", accessor)
    }

    /// Adds floats, and returns their accessor.
    pub fn floats(&mut self, kind: &str, values: &[f32]) -> usize {
        let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        self.accessor(&bytes, 5126, kind, values.len())
    }

    /// Adds 16-bit numbers, and returns their accessor.
    pub fn shorts(&mut self, kind: &str, values: &[u16]) -> usize {
        let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        self.accessor(&bytes, 5123, kind, values.len())
    }

    /// The document as one file.
    pub fn file(&self) -> NamedBytes {
        let mut json = self.json.clone();
        let data = STANDARD.encode(&self.bin);
        json["buffers"] = json!([{
            "byteLength": self.bin.len(),
            "uri": format!("data:application/octet-stream;base64,{data}"),
        }]);
        NamedBytes::new("a.gltf", json.to_string())
    }
}
