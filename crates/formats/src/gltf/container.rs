//! The containers of a document: a text file, or a binary file with a JSON chunk and a data chunk.

use super::json::Document;
use super::names::{BIN_CHUNK, JSON_CHUNK, MAGIC};
use crate::error::not_a;
use crate::text::encoding::{Encoding, decode};

/// How many bytes from the start of a file are searched for the keys of a glTF.
const HEAD_BYTES: usize = 64 * 1024;

/// The parts of a glTF file.
pub(super) struct Container<'a> {
    pub document: Document,
    /// The data of the first buffer, in a binary file.
    pub bin: Option<&'a [u8]>,
    /// Faults of the container, as clauses for the report.
    pub faults: Vec<String>,
}

/// Whether the file is a binary glTF.
pub(super) fn is_binary(bytes: &[u8]) -> bool {
    bytes.starts_with(MAGIC)
}

/// Whether the file starts like a JSON glTF.
pub(super) fn is_json(bytes: &[u8]) -> bool {
    let (head, _) = decode(bytes.get(..HEAD_BYTES).unwrap_or(bytes));
    // The order of the keys is up to the writer.
    let keys = ["\"asset\"", "\"accessors\"", "\"bufferViews\"", "\"buffers\""];
    head.trim_start().starts_with('{') && keys.iter().any(|key| head.contains(key))
}

impl<'a> Container<'a> {
    /// # Errors
    /// When the file is not glTF 2.0 or its JSON can't be parsed.
    pub(super) fn open(bytes: &'a [u8]) -> Result<Self, String> {
        let (json, bin, mut faults) =
            if is_binary(bytes) { chunks(bytes)? } else { (bytes, None, Vec::new()) };
        let (text, encoding) = decode(json);
        let document = Document::parse(&text)
            .map_err(|why| if is_binary(bytes) || is_json(bytes) { why } else { not_a("a glTF", &why) })?;
        check_version(&document)?;
        if encoding == Encoding::Latin1 {
            faults.push("letters that are not UTF-8, which were read as Latin-1".to_owned());
        }
        Ok(Self { document, bin, faults })
    }
}

/// # Errors
/// When the document states another version than 2.
fn check_version(document: &Document) -> Result<(), String> {
    let root = document.root();
    let asset = root.object("asset");
    let version = asset.and_then(|asset| asset.get("minVersion").or(asset.get("version")));
    let version = version.map(|version| match version.as_str() {
        Some(text) => text.to_owned(),
        None => version.to_string(),
    });
    match version {
        Some(version) if !version.starts_with('2') => Err(other_version(&version)),
        // Version 1 has objects where version 2 has lists.
        None if root.object("meshes").is_some() => Err(other_version("1.0")),
        _ => Ok(()),
    }
}

fn other_version(version: &str) -> String {
    let found = match version.trim() {
        "" => "it doesn't say which version of glTF it is".to_owned(),
        version => format!("it is glTF {version}"),
    };
    format!("{found}. Meshwright reads version 2: export the model as glTF 2.0")
}

/// The JSON and the first binary chunk of a binary file, with faults.
type Chunks<'a> = (&'a [u8], Option<&'a [u8]>, Vec<String>);

fn chunks(bytes: &[u8]) -> Result<Chunks<'_>, String> {
    let word = |at: usize| bytes.get(at..)?.first_chunk::<4>().map(|word| u32::from_le_bytes(*word));
    match word(4) {
        Some(2) => {}
        Some(version) => return Err(other_version(&format!("{version}.0"))),
        None => return Err("the file ends in its header".to_owned()),
    }
    let (mut json, mut bin, mut faults) = (None, None, Vec::new());
    let mut at = 12usize;
    while let (Some(length), Some(kind)) = (word(at), word(at.saturating_add(4))) {
        let start = at.saturating_add(8);
        let end = start.saturating_add(length as usize);
        let chunk = bytes.get(start..end).or_else(|| bytes.get(start..)).unwrap_or_default();
        match kind {
            JSON_CHUNK if json.is_none() => json = Some(chunk),
            BIN_CHUNK if bin.is_none() => {
                bin = Some(chunk);
                let missing = length as usize - chunk.len();
                if missing > 0 {
                    faults.push(format!("the last {missing} bytes of its data: the file ends too early"));
                }
            }
            _ => {}
        }
        at = end;
    }
    Ok((json.ok_or("the file has no JSON chunk")?, bin, faults))
}
