//! Reading materials.

use super::buffers::Buffers;
use super::json::{Document, MATERIALS, Object};
use super::names::{EMISSIVE_STRENGTH, GENERATOR, INDEX_OF_REFRACTION, SPECULAR_GLOSSINESS};
use super::texture::Textures;
use crate::file::NamedBytes;
use crate::model::collector::{MaterialCollector, Paint, is_color};
use crate::model::material::{AlphaMode, Material, Materials, Rgb};
use crate::model::texture::TextureRole;
use crate::notes::{Fault, Notes};
use crate::report::first_few;
use std::collections::HashMap;
use std::rc::Rc;

/// The default cutoff of a mask (glTF 2.0, 5.19.7).
const DEFAULT_CUTOFF: f32 = 0.5;

/// What the faces of a material have.
pub(super) struct FaceMaterial {
    pub paint: Paint,
    /// The set of texture coordinates of its base colour texture, or else of its first texture.
    pub uv_set: usize,
}

/// The materials of a document that faces use, read on first use.
pub(super) struct Library<'b, 'a> {
    document: &'a Document,
    textures: Textures<'b, 'a>,
    materials: MaterialCollector,
    known: HashMap<usize, Rc<FaceMaterial>>,
}

impl<'b, 'a> Library<'b, 'a> {
    /// `files` are those given with the model, images among them.
    pub(super) fn new(document: &'a Document, buffers: &'b Buffers<'a>, files: &'a [NamedBytes]) -> Self {
        let textures = Textures::new(document, buffers, files);
        Self { document, textures, materials: MaterialCollector::default(), known: HashMap::new() }
    }

    /// The materials that faces use. Notes unused materials.
    pub(super) fn finish(self, notes: &mut Notes) -> Materials {
        let unused = (0..self.document.count(MATERIALS)).filter(|index| !self.known.contains_key(index));
        let unused: Vec<String> = unused.map(|index| self.document.label(MATERIALS, index)).collect();
        if !unused.is_empty() {
            notes.info(format!("Materials that no face uses are left out: {}", first_few(&unused, 6)));
        }
        self.textures.note_filters(notes);
        self.materials.finish()
    }

    /// The material with this index.
    ///
    /// # Errors
    /// When there is none.
    pub(super) fn material(&mut self, index: usize, notes: &mut Notes) -> Result<Rc<FaceMaterial>, String> {
        if let Some(known) = self.known.get(&index) {
            return Ok(Rc::clone(known));
        }
        let object = self.document.item(MATERIALS, index)?;
        let label = object.name().map_or_else(|| index.to_string(), |name| format!("\"{name}\""));
        let mut faults = Faults { label: &label, notes };
        let mut material = factors(self.document, object, &mut faults);
        let uv_set = self.add_textures(object, &mut material, &mut faults);
        let paint = match object.name() {
            // A mere colour needs no name.
            None if is_color(&material) => Paint { name: String::new(), color: material.color() },
            None => self.materials.add(&format!("material {index}"), material),
            Some(name) => self.materials.add(name, material),
        };
        let known = Rc::new(FaceMaterial { paint, uv_set });
        self.known.insert(index, Rc::clone(&known));
        Ok(known)
    }

    /// Adds the textures of a material and returns the set of texture coordinates that they use.
    fn add_textures(&mut self, object: Object, material: &mut Material, faults: &mut Faults) -> usize {
        let mut sets = Vec::new();
        for (role, info) in textures(object) {
            match self.textures.read(role, info, &mut self.materials) {
                Ok((texture, set)) => {
                    material.textures.push(texture);
                    sets.push((role, set));
                }
                Err(why) => faults.add(&format!("its {} is left out: {why}", role.name())),
            }
        }
        let is_base = |(role, _): &&(TextureRole, usize)| *role == TextureRole::BaseColor;
        let main = sets.iter().find(is_base).or(sets.first()).map_or(0, |&(_, set)| set);
        for (role, _) in sets.iter().filter(|&&(_, set)| set != main) {
            faults.add(&format!(
                "its {} has other texture coordinates in the file than corners have here",
                role.name()
            ));
        }
        main
    }
}

/// Notes the faults of one material.
struct Faults<'n> {
    label: &'n str,
    notes: &'n mut Notes,
}

impl Faults<'_> {
    fn add(&mut self, what: &str) {
        self.notes.fault(Fault::Material, format!("{}: {what}", self.label));
    }

    /// The value, or `None` after noting why it can't be read.
    fn take<T>(&mut self, read: Result<Option<T>, String>) -> Option<T> {
        read.unwrap_or_else(|why| {
            self.add(&why);
            None
        })
    }
}

/// The textures of a material by their roles.
fn textures(object: Object) -> impl Iterator<Item = (TextureRole, Object)> {
    let surface = object.object("pbrMetallicRoughness");
    let glossy = object.extension(SPECULAR_GLOSSINESS).filter(|_| surface.is_none());
    let base = surface.and_then(|surface| surface.object("baseColorTexture"));
    let all = [
        (TextureRole::BaseColor, base.or(glossy.and_then(|glossy| glossy.object("diffuseTexture")))),
        (
            TextureRole::MetallicRoughness,
            surface.and_then(|surface| surface.object("metallicRoughnessTexture")),
        ),
        (TextureRole::Normal, object.object("normalTexture")),
        (TextureRole::Occlusion, object.object("occlusionTexture")),
        (TextureRole::Emissive, object.object("emissiveTexture")),
    ];
    all.into_iter().filter_map(|(role, info)| Some((role, info?)))
}

/// Reads everything but the textures of a material.
fn factors(document: &Document, object: Object, faults: &mut Faults) -> Material {
    let mut material = Material::default();
    let mut base = None;
    if let Some(surface) = object.object("pbrMetallicRoughness") {
        base = faults.take(surface.numbers::<4>("baseColorFactor"));
        let metallic = surface.number("metallicFactor").map_or(1.0, |value| value as f32);
        let roughness = surface.number("roughnessFactor").map(|value| value as f32);
        // A dielectric without a stated roughness stands for a material of a format without either.
        if metallic != 0.0 || roughness.is_some() {
            material.metallic = Some(metallic);
            material.roughness = Some(roughness.unwrap_or(1.0));
        }
    } else if let Some(glossy) = object.extension(SPECULAR_GLOSSINESS) {
        base = faults.take(glossy.numbers::<4>("diffuseFactor"));
        material.metallic = Some(0.0);
        material.roughness = Some(1.0 - glossy.number("glossinessFactor").unwrap_or(1.0) as f32);
        faults.add("its specular colour is left out, and its roughness comes from its glossiness");
    } else {
        (material.metallic, material.roughness) = (Some(1.0), Some(1.0));
    }
    if let Some([r, g, b, a]) = base {
        material.base_color = Some(Rgb::from_linear([r, g, b].map(|channel| channel as f32)));
        material.alpha = Some(a as f32).filter(|&alpha| alpha != 1.0);
    }
    let strength = object.extension(EMISSIVE_STRENGTH);
    let strength = strength.and_then(|strength| strength.number("emissiveStrength")).unwrap_or(1.0);
    let emissive = faults.take(object.numbers::<3>("emissiveFactor"));
    material.emissive = emissive.map(|rgb| Rgb::from_linear(rgb.map(|channel| (channel * strength) as f32)));
    let refraction = object.extension(INDEX_OF_REFRACTION);
    material.index_of_refraction =
        refraction.map(|refraction| refraction.number("ior").unwrap_or(1.5) as f32);
    material.alpha_mode = match object.text("alphaMode") {
        None => None,
        Some("OPAQUE") => Some(AlphaMode::Opaque),
        Some("BLEND") => Some(AlphaMode::Blend),
        Some("MASK") => {
            let cutoff = object.number("alphaCutoff").map_or(DEFAULT_CUTOFF, |cutoff| cutoff as f32);
            Some(AlphaMode::Mask { cutoff })
        }
        Some(other) => {
            faults.add(&format!("its alpha mode \"{other}\" is unknown"));
            None
        }
    };
    // Our writer makes materials double-sided unless they state otherwise.
    let generator = document.root().object("asset").and_then(|asset| asset.text("generator"));
    let both = object.flag("doubleSided").unwrap_or(false);
    material.double_sided = Some(both).filter(|both| !(*both && generator == Some(GENERATOR)));
    material
}
