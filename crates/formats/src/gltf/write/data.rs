//! Collects the binary data of a document with its views and accessors.

use super::fields::set;
use serde_json::{Value, json};

/// The target of views with vertex data.
const ARRAY_BUFFER: u32 = 34962;
/// The target of views with indices.
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

/// The data so far.
#[derive(Default)]
pub(super) struct Data {
    pub bin: Vec<u8>,
    pub views: Vec<Value>,
    pub accessors: Vec<Value>,
}

impl Data {
    /// Adds rows of floats, with their bounds if `has_bounds`, and returns the accessor.
    pub(super) fn floats<const N: usize>(&mut self, rows: &[[f32; N]], has_bounds: bool) -> usize {
        let mut accessor = json!({ "componentType": 5126, "count": rows.len(), "type": format!("VEC{N}") });
        if has_bounds {
            let fold = |pick: fn(f32, f32) -> f32, start: f32| {
                (0..N)
                    .map(|i| rows.iter().filter_map(|row| row.get(i)).fold(start, |a, &b| pick(a, b)))
                    .collect::<Vec<_>>()
            };
            set(&mut accessor, "min", fold(f32::min, f32::INFINITY));
            set(&mut accessor, "max", fold(f32::max, f32::NEG_INFINITY));
        }
        let bytes = rows.iter().flatten().flat_map(|value| value.to_le_bytes());
        self.accessor(bytes, ARRAY_BUFFER, accessor)
    }

    /// Adds the values of the `_VERTEX_ID` attribute and returns the accessor.
    pub(super) fn ids(&mut self, ids: &[u32]) -> usize {
        let accessor = json!({ "componentType": 5121, "count": ids.len(), "type": "VEC4" });
        self.accessor(ids.iter().flat_map(|id| id.to_le_bytes()), ARRAY_BUFFER, accessor)
    }

    /// Adds indices and returns the accessor.
    pub(super) fn indices(&mut self, indices: &[u32]) -> usize {
        let accessor = json!({ "componentType": 5125, "count": indices.len(), "type": "SCALAR" });
        self.accessor(indices.iter().flat_map(|index| index.to_le_bytes()), ELEMENT_ARRAY_BUFFER, accessor)
    }

    fn accessor(&mut self, bytes: impl Iterator<Item = u8>, target: u32, mut accessor: Value) -> usize {
        let offset = self.bin.len();
        self.bin.extend(bytes);
        let length = self.bin.len() - offset;
        set(&mut accessor, "bufferView", self.views.len());
        self.views.push(json!({ "buffer": 0, "byteOffset": offset, "byteLength": length, "target": target }));
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }

    /// Adds a file and returns the view. No accessors may follow: their data has to be aligned.
    pub(super) fn file(&mut self, bytes: &[u8]) -> usize {
        let offset = self.bin.len();
        self.bin.extend_from_slice(bytes);
        self.views.push(json!({ "buffer": 0, "byteOffset": offset, "byteLength": bytes.len() }));
        self.views.len() - 1
    }
}
