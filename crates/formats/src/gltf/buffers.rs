//! The data of a document: buffers, views into them, and compressed views.

use super::container::Container;
use super::draco::DracoMesh;
use super::json::{BUFFER_VIEWS, BUFFERS, Document, Object};
use super::{draco, meshopt};
use crate::file::{NamedBytes, find};
use crate::text::print::percent_decoded;
use base64::Engine;
use base64::alphabet::STANDARD;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};
use std::borrow::Cow;
use std::cell::{Cell, OnceCell};

/// Total size of decoded views that any file may have, in bytes.
const MIN_DECODED_BUDGET: usize = 64 << 20;

/// Total size of decoded views for each byte of the file. It is large because constant attributes
/// compress to almost nothing.
const DECODED_BYTES_PER_BYTE: usize = 256;

/// The buffers of a document. Compressed views are decoded once, on first use.
pub(super) struct Buffers<'a> {
    document: &'a Document,
    buffers: Vec<Result<Cow<'a, [u8]>, String>>,
    /// The names of the files with data that were not given.
    missing: Vec<String>,
    views: Vec<OnceCell<Result<Vec<u8>, String>>>,
    draco: Vec<OnceCell<Result<DracoMesh, String>>>,
    /// How many more bytes may be decoded.
    budget: Cell<usize>,
}

/// Bytes of a buffer.
#[derive(Clone, Copy)]
pub(super) struct View<'b> {
    pub bytes: &'b [u8],
    /// Distance between rows in bytes, if the view states it.
    pub stride: Option<usize>,
}

impl<'a> Buffers<'a> {
    /// Opens all buffers; `files` are those given with the model.
    pub(super) fn open(container: &'a Container<'a>, files: &'a [NamedBytes]) -> Self {
        let document = &container.document;
        let buffers = document.items(BUFFERS).enumerate().map(|(i, buffer)| {
            match (buffer.text("uri"), container.bin) {
                (Some(uri), _) => load(uri, files),
                (None, Some(bin)) if i == 0 => Ok(Cow::Borrowed(bin)),
                (None, _) => Err(format!("buffer {i} has no data")),
            }
        });
        let buffers: Vec<_> = buffers.collect();
        let uris = document.items(BUFFERS).filter_map(|buffer| buffer.text("uri"));
        let names = uris.filter(|uri| !uri.starts_with("data:")).map(percent_decoded);
        let views = document.count(BUFFER_VIEWS);
        let size: usize = buffers.iter().flatten().map(|buffer| buffer.len()).sum();
        Self {
            document,
            buffers,
            missing: names.filter(|name| find(name, files).is_none()).collect(),
            views: (0..views).map(|_| OnceCell::new()).collect(),
            draco: (0..views).map(|_| OnceCell::new()).collect(),
            budget: Cell::new(size.saturating_mul(DECODED_BYTES_PER_BYTE).max(MIN_DECODED_BUDGET)),
        }
    }

    /// Total size of the buffers that could be loaded, in bytes.
    pub(super) fn size(&self) -> usize {
        self.buffers.iter().flatten().map(|buffer| buffer.len()).sum()
    }

    /// The names of the files with data that were not given.
    pub(super) fn missing(&self) -> &[String] {
        &self.missing
    }

    /// The bytes of a view, cut off at the end of its buffer.
    ///
    /// # Errors
    /// When the view or its buffer can't be read.
    pub(super) fn view(&self, index: usize) -> Result<View<'_>, String> {
        let view = self.document.item(BUFFER_VIEWS, index)?;
        let stride = view.index("byteStride")?.filter(|&stride| stride > 0);
        if let Some(compressed) = meshopt::extension_of(view)
            && let Some(cell) = self.views.get(index)
        {
            match cell.get_or_init(|| self.decoded(compressed)) {
                Ok(bytes) => return Ok(View { bytes, stride }),
                Err(why) => {
                    // Files may hold an uncompressed copy for readers without the extension.
                    let copy = self.bytes(view).ok().filter(|bytes| !bytes.is_empty());
                    let bytes = copy.ok_or_else(|| format!("its compressed data can't be read ({why})"))?;
                    return Ok(View { bytes, stride });
                }
            }
        }
        Ok(View { bytes: self.bytes(view)?, stride })
    }

    /// The bytes that a view, or the compression extension of one, refers to.
    fn bytes(&self, view: Object) -> Result<&[u8], String> {
        let index = view.required_index("buffer")?;
        let buffer = match self.buffers.get(index) {
            Some(Ok(buffer)) => buffer,
            Some(Err(why)) => return Err(why.clone()),
            None => return Err(format!("buffer {index} doesn't exist")),
        };
        let start = view.index_or("byteOffset", 0)?;
        let length = view.required_index("byteLength")?;
        let rest = buffer.get(start..).unwrap_or_default();
        Ok(rest.get(..length).unwrap_or(rest))
    }

    fn decoded(&self, compressed: Object) -> Result<Vec<u8>, String> {
        let bytes = meshopt::decode(compressed, self.bytes(compressed)?, self.budget.get())?;
        self.budget.set(self.budget.get().saturating_sub(bytes.len()));
        Ok(bytes)
    }

    /// The mesh in a view with Draco data.
    ///
    /// # Errors
    /// When it can't be decoded.
    pub(super) fn draco_mesh(&self, index: usize) -> Result<&DracoMesh, String> {
        let cell = self.draco.get(index).ok_or_else(|| format!("buffer view {index} doesn't exist"))?;
        let mesh = cell.get_or_init(|| {
            let mesh = draco::decode(self.view(index)?.bytes, self.budget.get())?;
            self.budget.set(self.budget.get().saturating_sub(mesh.size()));
            Ok(mesh)
        });
        mesh.as_ref().map_err(Clone::clone)
    }
}

/// The names of the files that a document refers to: buffers and images.
pub(super) fn companions(file: &NamedBytes) -> Vec<String> {
    let Ok(container) = Container::open(&file.bytes) else { return Vec::new() };
    let root = container.document.root();
    let uris = root.objects("buffers").chain(root.objects("images")).filter_map(|item| item.text("uri"));
    uris.filter(|uri| !uri.starts_with("data:")).map(percent_decoded).collect()
}

/// The data at an address: part of a `data:` address, or a file given with the model.
///
/// # Errors
/// When the file wasn't given, or the `data:` address isn't base64.
pub(super) fn load<'a>(uri: &str, files: &'a [NamedBytes]) -> Result<Cow<'a, [u8]>, String> {
    if let Some(data) = uri.strip_prefix("data:") {
        return data_of(data).map(Cow::Owned);
    }
    let name = percent_decoded(uri);
    match find(&name, files) {
        Some(file) => Ok(Cow::Borrowed(file.bytes.as_slice())),
        None => Err(format!("its data is in {name}, which was not given; open both files together")),
    }
}

/// The data of a `data:` address, given without this prefix.
fn data_of(data: &str) -> Result<Vec<u8>, String> {
    let (_, text) = data.split_once("base64,").ok_or("its data is not in base64")?;
    let padding = DecodePaddingMode::Indifferent;
    let engine =
        GeneralPurpose::new(&STANDARD, GeneralPurposeConfig::new().with_decode_padding_mode(padding));
    engine.decode(text).map_err(|error| format!("its data is not in base64 ({error})"))
}
