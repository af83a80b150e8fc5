//! The JSON of a glTF, as far as it matters here, and its buffers.

use super::names::{BIN_CHUNK, JSON_CHUNK, MAGIC};
use crate::error::not_a;
use crate::file::NamedBytes;
use crate::text::print::percent_decoded;
use base64::Engine;
use serde::Deserialize;
use std::borrow::Cow;
use std::collections::HashMap;

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(crate) struct Document {
    pub asset: Asset,
    pub scene: Option<usize>,
    pub scenes: Vec<Scene>,
    pub nodes: Vec<Node>,
    pub meshes: Vec<Mesh>,
    pub accessors: Vec<Accessor>,
    pub buffer_views: Vec<View>,
    buffers: Vec<Buffer>,
    pub materials: Vec<Material>,
    extensions_required: Vec<String>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(crate) struct Asset {
    pub generator: Option<String>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(crate) struct Scene {
    pub nodes: Vec<usize>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(crate) struct Node {
    pub name: Option<String>,
    pub mesh: Option<usize>,
    pub children: Vec<usize>,
    pub matrix: Option<[f64; 16]>,
    pub translation: Option<[f64; 3]>,
    pub rotation: Option<[f64; 4]>,
    pub scale: Option<[f64; 3]>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(crate) struct Mesh {
    pub name: Option<String>,
    pub primitives: Vec<Primitive>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub(crate) struct Primitive {
    pub attributes: HashMap<String, usize>,
    pub indices: Option<usize>,
    pub material: Option<usize>,
    pub mode: Option<u32>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(crate) struct Accessor {
    pub buffer_view: Option<usize>,
    pub byte_offset: usize,
    pub component_type: u32,
    pub normalized: bool,
    pub count: usize,
    #[serde(rename = "type")]
    pub kind: String,
    pub sparse: Option<serde::de::IgnoredAny>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(crate) struct View {
    pub buffer: usize,
    pub byte_offset: usize,
    pub byte_length: usize,
    pub byte_stride: Option<usize>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Buffer {
    uri: Option<String>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(crate) struct Material {
    pub name: Option<String>,
    pub pbr_metallic_roughness: Surface,
}

#[derive(Debug, Default, Deserialize)]
#[serde(default, rename_all = "camelCase")]
pub(crate) struct Surface {
    pub base_color_factor: Option<[f32; 4]>,
    pub base_color_texture: Option<serde::de::IgnoredAny>,
}

/// Whether the file starts like a binary glTF.
pub(crate) fn is_binary(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
}

/// Whether the file starts like a glTF in JSON.
pub(crate) fn is_json(bytes: &[u8]) -> bool {
    !is_binary(bytes) && looks_like(bytes)
}

/// Whether the file starts like a glTF.
fn looks_like(bytes: &[u8]) -> bool {
    if bytes.starts_with(MAGIC) {
        return true;
    }
    let head = bytes.get(..64 * 1024).unwrap_or(bytes);
    let head = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head);
    let has = |key: &[u8]| head.windows(key.len()).any(|word| word == key);
    // Which of them comes first, and how far in, is up to the writer.
    head.trim_ascii_start().starts_with(b"{")
        && (has(b"\"asset\"") || has(b"\"accessors\"") || has(b"\"bufferViews\"") || has(b"\"buffers\""))
}

/// The bytes of each buffer.
pub(crate) type Buffers<'a> = Vec<Cow<'a, [u8]>>;

/// The document and all its buffers.
pub(crate) fn open<'a>(
    file: &'a NamedBytes,
    files: &'a [NamedBytes],
) -> Result<(Document, Buffers<'a>), String> {
    let bytes = file.bytes.as_slice();
    let (json, bin) = if bytes.starts_with(MAGIC) { chunks(bytes)? } else { (bytes, None) };
    let json = json.strip_prefix(b"\xef\xbb\xbf").unwrap_or(json);
    let document: Document = serde_json::from_slice(json).map_err(|error| {
        let why = format!("its JSON can't be read: {error}");
        if looks_like(bytes) { why } else { not_a("a glTF", &why) }
    })?;
    // Compressed geometry and the like; what is merely used is not needed.
    let needed = document.extensions_required.iter().find(|name| {
        !(name.starts_with("KHR_materials")
            || *name == "KHR_texture_transform"
            || *name == "KHR_mesh_quantization")
    });
    if let Some(extension) = needed {
        return Err(format!("it needs the extension {extension}, which can't be read; export it without"));
    }
    let mut buffers = Vec::new();
    for (i, buffer) in document.buffers.iter().enumerate() {
        buffers.push(match (&buffer.uri, bin) {
            (None, Some(bin)) if i == 0 => Cow::Borrowed(bin),
            (None, _) => return Err(format!("buffer {i} has no data")),
            (Some(uri), _) => load(uri, files)?,
        });
    }
    Ok((document, buffers))
}

/// The JSON and the first binary chunk of a binary file.
fn chunks(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), String> {
    let word = |at: usize| bytes.get(at..)?.first_chunk::<4>().map(|word| u32::from_le_bytes(*word));
    if word(4) != Some(2) {
        return Err("only version 2 of glTF can be read".to_owned());
    }
    let (mut json, mut bin) = (None, None);
    let mut at = 12usize;
    while let (Some(length), Some(kind)) = (word(at), word(at.saturating_add(4))) {
        let start = at.saturating_add(8);
        let end = start.saturating_add(length as usize);
        let chunk = bytes.get(start..end).ok_or("the file ends in the middle of a chunk")?;
        match kind {
            JSON_CHUNK if json.is_none() => json = Some(chunk),
            BIN_CHUNK if bin.is_none() => bin = Some(chunk),
            _ => {}
        }
        at = end;
    }
    Ok((json.ok_or("the file has no JSON chunk")?, bin))
}

/// The names of the files that hold the buffers of a glTF; none where it can't be read.
pub(crate) fn buffer_names(file: &NamedBytes) -> Vec<String> {
    let bytes = file.bytes.as_slice();
    let json = if bytes.starts_with(MAGIC) { chunks(bytes).map_or(&[][..], |(json, _)| json) } else { bytes };
    let json = json.strip_prefix(b"\xef\xbb\xbf").unwrap_or(json);
    let Ok(document) = serde_json::from_slice::<Document>(json) else { return Vec::new() };
    let uris = document.buffers.iter().filter_map(|buffer| buffer.uri.as_deref());
    uris.filter(|uri| !uri.starts_with("data:")).map(percent_decoded).collect()
}

/// A buffer from its address: in the address itself, or a file given along.
fn load<'a>(uri: &str, files: &'a [NamedBytes]) -> Result<Cow<'a, [u8]>, String> {
    if let Some(data) = uri.strip_prefix("data:") {
        let (_, text) = data.split_once("base64,").ok_or("a buffer is not in base64")?;
        let engine = base64::engine::GeneralPurpose::new(
            &base64::alphabet::STANDARD,
            base64::engine::GeneralPurposeConfig::new()
                .with_decode_padding_mode(base64::engine::DecodePaddingMode::Indifferent),
        );
        return engine
            .decode(text)
            .map(Cow::Owned)
            .map_err(|error| format!("a buffer is not in base64: {error}"));
    }
    let base = |name: &str| name.rsplit(['/', '\\']).next().unwrap_or(name).to_lowercase();
    let name = percent_decoded(uri);
    let found = files.iter().find(|file| base(&file.name) == base(&name));
    found
        .map(|file| Cow::Borrowed(file.bytes.as_slice()))
        .ok_or_else(|| format!("its data is in {name}, which was not given: open both files together"))
}
