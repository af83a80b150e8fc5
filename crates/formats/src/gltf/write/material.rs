//! Writing materials, textures and images.

use super::data::Data;
use super::fields::set;
use crate::file::NamedBytes;
use crate::gltf::names::{
    CLAMP_TO_EDGE, EMISSIVE_STRENGTH, IMAGE_EXTENSIONS, INDEX_OF_REFRACTION, MIRRORED_REPEAT,
    TEXTURE_TRANSFORM,
};
use crate::model::Model;
use crate::model::images::{image_files, written_names};
use crate::model::material::{AlphaMode, Material, Property, Rgb};
use crate::model::paint::{names_in_use, own_colors, painted};
use crate::model::srgb::to_linear;
use crate::model::texture::{Image, Texture, TextureRole, UvTransform, Wrap};
use crate::report::first_few;
use crate::text::print::percent_encoded;
use halfedge::Color;
use serde_json::{Map, Value, json};
use std::collections::{BTreeSet, HashMap, HashSet};

/// Whether glTF holds this property of a material.
pub(crate) fn keeps(property: Property) -> bool {
    match property {
        Property::BaseColor
        | Property::Alpha
        | Property::Emissive
        | Property::Metallic
        | Property::Roughness
        | Property::IndexOfRefraction
        | Property::AlphaMode
        | Property::DoubleSided => true,
        Property::Texture(role) => place(role).is_some(),
        _ => false,
    }
}

/// The key of the object that holds a texture with this role, empty for the material itself, and the key of
/// the texture in it.
fn place(role: TextureRole) -> Option<(&'static str, &'static str)> {
    Some(match role {
        TextureRole::BaseColor => ("pbrMetallicRoughness", "baseColorTexture"),
        TextureRole::MetallicRoughness => ("pbrMetallicRoughness", "metallicRoughnessTexture"),
        TextureRole::Normal => ("", "normalTexture"),
        TextureRole::Occlusion => ("", "occlusionTexture"),
        TextureRole::Emissive => ("", "emissiveTexture"),
        _ => return None,
    })
}

/// Names the used images of kinds that the format doesn't have.
pub(crate) fn losses(model: &Model) -> Vec<String> {
    let in_use: HashSet<&str> = model.objects.iter().flat_map(|object| names_in_use(&object.mesh)).collect();
    let materials = model.materials.list.iter().filter(|material| in_use.contains(material.name.as_str()));
    let textures = materials.flat_map(|material| &material.textures).filter(|t| place(t.role).is_some());
    let images = textures.filter_map(|texture| model.materials.image(texture));
    let names = images.filter(|image| !is_allowed(image)).map(|image| image.file_name());
    let names: Vec<&str> = names.collect::<BTreeSet<&str>>().into_iter().collect();
    if names.is_empty() {
        return Vec::new();
    }
    let names = first_few(&names, 6);
    vec![format!("glTF holds PNG, JPEG, WebP, KTX 2, AVIF and DDS images: programs may not show {names}")]
}

/// Whether the format or an extension allows images of this kind.
fn is_allowed(image: &Image) -> bool {
    let Some(kind) = image.media_type.as_deref() else { return true };
    matches!(kind, "image/png" | "image/jpeg") || IMAGE_EXTENSIONS.iter().any(|(_, own)| *own == kind)
}

/// Collects the materials that faces use, with their textures and images.
pub(super) struct MaterialWriter<'m> {
    model: &'m Model,
    /// The names of the image files; `None` if images go into the binary data.
    image_names: Option<Vec<String>>,
    /// The colour of the faces that keep their material's name, by name.
    own_colors: HashMap<String, Color>,
    /// The model's materials by name.
    known: HashMap<&'m str, &'m Material>,
    numbers: HashMap<(String, Option<Color>), usize>,
    materials: Vec<Value>,
    textures: Vec<Value>,
    samplers: Vec<Value>,
    /// For each image of the document its index in the model.
    images: Vec<u32>,
    extensions: BTreeSet<&'static str>,
    /// Extensions that textures can't be shown without.
    required: BTreeSet<&'static str>,
}

impl<'m> MaterialWriter<'m> {
    /// `other_files` are the names of the files beside which images are written; `None` if images go into the
    /// binary data.
    pub(super) fn new(model: &'m Model, other_files: Option<[&str; 2]>) -> Self {
        let image_names = other_files.map(|files| written_names(&model.materials.images, files));
        Self {
            model,
            image_names,
            own_colors: own_colors(model, str::to_owned),
            known: model.materials.list.iter().map(|material| (material.name.as_str(), material)).collect(),
            numbers: HashMap::new(),
            materials: Vec::new(),
            textures: Vec::new(),
            samplers: Vec::new(),
            images: Vec::new(),
            extensions: BTreeSet::new(),
            required: BTreeSet::new(),
        }
    }

    /// The index of the material for faces with this label and colour.
    pub(super) fn number(&mut self, label: &str, color: Option<Color>) -> usize {
        let key = (label.to_owned(), color);
        if let Some(&number) = self.numbers.get(&key) {
            return number;
        }
        // Faces of other colours get variants of the material, named so that they read back as one.
        let name = match color {
            Some(color) if self.own_colors.get(label) != Some(&color) => painted(label, color),
            _ => label.to_owned(),
        };
        let material = self.material(&name, color, self.known.get(label).copied());
        self.materials.push(material);
        let number = self.materials.len() - 1;
        self.numbers.insert(key, number);
        number
    }

    fn material(&mut self, name: &str, color: Option<Color>, known: Option<&'m Material>) -> Value {
        let plain = Material::default();
        let stated = known.unwrap_or(&plain);
        // Unless faces were painted, the material's own colour is written, which has more digits.
        let base = match color {
            Some(color) if known.is_none_or(|known| known.color().unwrap_or(Color::UNPAINTED) != color) => {
                Some(color.0.map(|channel| to_linear(f32::from(channel) / 255.0)))
            }
            _ => stated.base_color.map(Rgb::to_linear),
        };
        let mut surface = json!({ "metallicFactor": stated.metallic.unwrap_or(0.0) });
        if let Some(roughness) = stated.roughness {
            set(&mut surface, "roughnessFactor", roughness);
        }
        if base.is_some() || stated.alpha.is_some() {
            let [r, g, b] = base.unwrap_or([1.0; 3]);
            set(&mut surface, "baseColorFactor", vec![r, g, b, stated.alpha.unwrap_or(1.0)]);
        }
        let mut material = json!({
            "name": name,
            "doubleSided": stated.double_sided.unwrap_or(true),
            "pbrMetallicRoughness": surface,
        });
        self.light(stated, &mut material);
        // Without a mode, other programs ignore alpha.
        let is_transparent = stated.alpha.is_some_and(|alpha| alpha < 1.0);
        match stated.alpha_mode.or(is_transparent.then_some(AlphaMode::Blend)) {
            None => {}
            Some(AlphaMode::Opaque) => set(&mut material, "alphaMode", "OPAQUE"),
            Some(AlphaMode::Blend) => set(&mut material, "alphaMode", "BLEND"),
            Some(AlphaMode::Mask { cutoff }) => {
                set(&mut material, "alphaMode", "MASK");
                set(&mut material, "alphaCutoff", cutoff);
            }
        }
        for texture in &stated.textures {
            let Some((parent, key)) = place(texture.role) else { continue };
            let Some(info) = self.texture_info(texture) else { continue };
            let parent = if parent.is_empty() { Some(&mut material) } else { material.get_mut(parent) };
            if let Some(parent) = parent {
                set(parent, key, info);
            }
        }
        material
    }

    /// Writes the emissive colour and the index of refraction.
    fn light(&mut self, stated: &Material, material: &mut Value) {
        let mut extensions = Map::new();
        if let Some(emissive) = stated.emissive.map(Rgb::to_linear) {
            // Factors are at most 1, and an extension multiplies them. Powers of two keep all digits.
            let strength = emissive.into_iter().fold(1.0f32, f32::max).log2().ceil().exp2();
            set(material, "emissiveFactor", emissive.map(|channel| channel / strength).to_vec());
            if strength > 1.0 {
                extensions.insert(EMISSIVE_STRENGTH.to_owned(), json!({ "emissiveStrength": strength }));
                self.extensions.insert(EMISSIVE_STRENGTH);
            }
        }
        if let Some(refraction) = stated.index_of_refraction {
            extensions.insert(INDEX_OF_REFRACTION.to_owned(), json!({ "ior": refraction }));
            self.extensions.insert(INDEX_OF_REFRACTION);
        }
        if !extensions.is_empty() {
            set(material, "extensions", extensions);
        }
    }

    /// A material's reference to a texture; `None` if its image doesn't exist.
    fn texture_info(&mut self, texture: &Texture) -> Option<Value> {
        let image = self.model.materials.image(texture)?;
        let known = self.images.iter().position(|&known| known == texture.image);
        let number = known.unwrap_or_else(|| {
            self.images.push(texture.image);
            self.images.len() - 1
        });
        let kind = image.media_type.as_deref().unwrap_or_default();
        let extension = IMAGE_EXTENSIONS.iter().find(|(_, own)| *own == kind);
        let mut entry = match extension {
            None => json!({ "source": number }),
            Some(&(name, _)) => {
                self.extensions.insert(name);
                self.required.insert(name);
                json!({ "extensions": { name: { "source": number } } })
            }
        };
        if texture.wrap != [Wrap::Repeat; 2] {
            let mut sampler = json!({});
            for (key, wrap) in ["wrapS", "wrapT"].into_iter().zip(texture.wrap) {
                match wrap {
                    Wrap::Repeat => {}
                    Wrap::Mirror => set(&mut sampler, key, MIRRORED_REPEAT),
                    Wrap::Clamp => set(&mut sampler, key, CLAMP_TO_EDGE),
                }
            }
            set(&mut entry, "sampler", number_of(&mut self.samplers, sampler));
        }
        let mut info = json!({ "index": number_of(&mut self.textures, entry) });
        if texture.scale != 1.0 {
            match texture.role {
                TextureRole::Normal => set(&mut info, "scale", texture.scale),
                TextureRole::Occlusion => set(&mut info, "strength", texture.scale),
                _ => {}
            }
        }
        if let Some(UvTransform { offset, rotation, scale }) = texture.transform {
            let transform = json!({ "offset": offset, "rotation": rotation, "scale": scale });
            set(&mut info, "extensions", json!({ TEXTURE_TRANSFORM: transform }));
            self.extensions.insert(TEXTURE_TRANSFORM);
        }
        Some(info)
    }

    /// The files of the images that textures use.
    pub(super) fn image_files(&self) -> Vec<NamedBytes> {
        let names = self.image_names.as_deref().unwrap_or_default();
        image_files(&self.model.materials.images, names, &self.images.iter().copied().collect())
    }

    /// The finished lists of the document. Writes images to the data if they go there.
    pub(super) fn finish(&mut self, data: &mut Data) -> [(&'static str, Vec<Value>); 6] {
        let images = self.images.iter().filter_map(|&number| {
            let image = self.model.materials.images.get(number as usize)?;
            let names = self.image_names.as_ref();
            let Some(bytes) = image.bytes.as_ref().filter(|_| names.is_none()) else {
                let name = names.map_or(Some(&image.name), |names| names.get(number as usize))?;
                return Some(json!({ "uri": percent_encoded(name) }));
            };
            let mut entry = json!({ "name": image.name, "bufferView": data.file(bytes) });
            if let Some(kind) = &image.media_type {
                set(&mut entry, "mimeType", kind.as_str());
            }
            Some(entry)
        });
        let images = images.collect();
        let names = |names: &BTreeSet<&str>| names.iter().map(|name| json!(name)).collect();
        [
            ("images", images),
            ("materials", std::mem::take(&mut self.materials)),
            ("textures", std::mem::take(&mut self.textures)),
            ("samplers", std::mem::take(&mut self.samplers)),
            ("extensionsUsed", names(&self.extensions)),
            ("extensionsRequired", names(&self.required)),
        ]
    }
}

/// The index of an item in a list. Adds it if it is missing.
fn number_of(list: &mut Vec<Value>, item: Value) -> usize {
    list.iter().position(|known| *known == item).unwrap_or_else(|| {
        list.push(item);
        list.len() - 1
    })
}
