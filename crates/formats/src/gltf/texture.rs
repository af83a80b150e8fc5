//! Reading textures and images.

use super::buffers::{Buffers, load};
use super::json::{Document, IMAGES, Object, SAMPLERS, TEXTURES};
use super::names::{CLAMP_TO_EDGE, IMAGE_EXTENSIONS, MIRRORED_REPEAT, TEXTURE_TRANSFORM};
use crate::file::NamedBytes;
use crate::model::collector::MaterialCollector;
use crate::model::images::{extension_of, image, media_type};
use crate::model::texture::{Image, Texture, TextureRole, UvTransform, Wrap};
use crate::notes::Notes;
use crate::text::print::percent_decoded;
use std::collections::HashMap;

/// Reads textures. Reads each image once.
pub(super) struct Textures<'b, 'a> {
    document: &'a Document,
    buffers: &'b Buffers<'a>,
    files: &'a [NamedBytes],
    /// The index in the model of each image of the document.
    numbers: HashMap<usize, u32>,
    /// Whether a sampler states how images are filtered.
    has_filters: bool,
}

impl<'b, 'a> Textures<'b, 'a> {
    pub(super) fn new(document: &'a Document, buffers: &'b Buffers<'a>, files: &'a [NamedBytes]) -> Self {
        Self { document, buffers, files, numbers: HashMap::new(), has_filters: false }
    }

    /// Reads a texture and returns it with the set of texture coordinates that it uses in the file; in the
    /// model there is one set.
    ///
    /// # Errors
    /// When the texture or its image can't be read.
    pub(super) fn read(
        &mut self,
        role: TextureRole,
        info: Object,
        materials: &mut MaterialCollector,
    ) -> Result<(Texture, usize), String> {
        let texture = self.document.item(TEXTURES, info.required_index("index")?)?;
        // The core image takes precedence, because every program can show it.
        let others = IMAGE_EXTENSIONS.iter().filter_map(|(name, _)| texture.extension(name));
        let source = match texture.index("source")? {
            Some(source) => Some(source),
            None => others.filter_map(|other| other.index("source").transpose()).next().transpose()?,
        };
        let number = self.image(source.ok_or("it shows no image")?, materials)?;
        let scale = info.number("scale").or(info.number("strength")).unwrap_or(1.0) as f32;
        let mut texture = Texture { wrap: self.wrap(texture)?, scale, ..Texture::new(role, number) };
        let mut set = info.index_or("texCoord", 0)?;
        if let Some(transform) = info.extension(TEXTURE_TRANSFORM) {
            set = transform.index_or("texCoord", set)?;
            let pair = |key: &str, default: [f64; 2]| -> Result<[f32; 2], String> {
                Ok(transform.numbers::<2>(key)?.unwrap_or(default).map(|value| value as f32))
            };
            let (offset, scale) = (pair("offset", [0.0; 2])?, pair("scale", [1.0; 2])?);
            let rotation = transform.number("rotation").unwrap_or(0.0) as f32;
            if (offset, rotation, scale) != ([0.0; 2], 0.0, [1.0; 2]) {
                texture.transform = Some(UvTransform { offset, rotation, scale });
            }
        }
        Ok((texture, set))
    }

    /// The wrap modes of a texture.
    fn wrap(&mut self, texture: Object) -> Result<[Wrap; 2], String> {
        let Some(sampler) = texture.index("sampler")? else { return Ok([Wrap::Repeat; 2]) };
        let sampler = self.document.item(SAMPLERS, sampler)?;
        self.has_filters |= sampler.get("magFilter").or(sampler.get("minFilter")).is_some();
        let side = |key: &str| -> Result<Wrap, String> {
            Ok(match sampler.index(key)? {
                Some(CLAMP_TO_EDGE) => Wrap::Clamp,
                Some(MIRRORED_REPEAT) => Wrap::Mirror,
                _ => Wrap::Repeat,
            })
        };
        Ok([side("wrapS")?, side("wrapT")?])
    }

    /// The index in the model of an image of the document.
    fn image(&mut self, index: usize, materials: &mut MaterialCollector) -> Result<u32, String> {
        if let Some(&number) = self.numbers.get(&index) {
            return Ok(number);
        }
        let object = self.document.item(IMAGES, index)?;
        let uri = object.text("uri");
        let image = match (uri.filter(|uri| !uri.starts_with("data:")), object.index("bufferView")?) {
            (Some(file), _) => image(&percent_decoded(file), self.files),
            (None, Some(view)) => embedded(index, object, self.buffers.view(view)?.bytes),
            (None, None) => {
                let uri = uri.ok_or_else(|| format!("image {index} has no data"))?;
                let bytes = load(uri, self.files)?;
                embedded(index, object, &bytes)
            }
        };
        let number = materials.add_image(image);
        self.numbers.insert(index, number);
        Ok(number)
    }

    /// Notes that filters are not kept if a sampler states any.
    pub(super) fn note_filters(&self, notes: &mut Notes) {
        if self.has_filters {
            notes.info("How textures are filtered when they are shown small or large is not kept");
        }
    }
}

/// An image whose data is in the document.
fn embedded(index: usize, object: Object, bytes: &[u8]) -> Image {
    let mut name = object.name().map_or_else(|| format!("image{index}"), str::to_owned);
    let media_type = object.text("mimeType").map(str::to_owned).or_else(|| media_type(&name, bytes));
    if let Some(extension) = media_type.as_deref().and_then(extension_of)
        && !name.ends_with(&format!(".{extension}"))
    {
        name = format!("{name}.{extension}");
    }
    Image { name, media_type, bytes: Some(bytes.into()) }
}
