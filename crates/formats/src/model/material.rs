//! Materials and the images that they use: one model for all formats.
//!
//! A face refers to its material by name, with the label of [`FACE_MATERIAL`](halfedge::keys::FACE_MATERIAL).
//! [`FACE_COLOR`](halfedge::keys::FACE_COLOR) is what the editor shows and paints; it starts as the
//! material's [`color`](Material::color).
//!
//! # Who fills what
//!
//! | field | MTL statement | glTF property | COLLADA effect |
//! |---|---|---|---|
//! | `base_color` | `Kd` | `baseColorFactor` (r, g, b) | `diffuse` |
//! | `alpha` | `d`, `Tr` | `baseColorFactor` (a) | `transparent`, `transparency` |
//! | `emissive` | `Ke` | `emissiveFactor`, `KHR_materials_emissive_strength` | `emission` |
//! | `specular`, `ambient`, `shininess` | `Ks`, `Ka`, `Ns` | – | `specular`, `ambient`, `shininess` |
//! | `metallic`, `roughness` | `Pm`, `Pr` | `metallicFactor`, `roughnessFactor` | – |
//! | `index_of_refraction` | `Ni` | `KHR_materials_ior` | `index_of_refraction` |
//! | `alpha_mode` | – | `alphaMode`, `alphaCutoff` | – |
//! | `double_sided` | – | `doubleSided` | – |
//! | `textures` | `map_…`, `bump`, `norm`, … | `…Texture` | `texture` |
//! | `mtl` | all statements as they stand | – | – |
//!
//! A reader fills what its file states and leaves the rest `None`; what the model has no place for it
//! names in the import report. A reader gives every material that is more than a colour a name that no
//! other material of the file has: the label of a face says nothing else.
//!
//! A writer writes a material's values where its format has a place for them; [`losses`](crate::losses)
//! names the rest. It writes the colour of the faces in place of `base_color` where faces were painted
//! (see `paint.rs`). The OBJ writer repeats the statements in `mtl` to the letter where there are any,
//! and makes statements from the other fields where there are none. Writers put images whose bytes are
//! known inside the file or beside it.

use crate::model::srgb::{linear_from_srgb, srgb_from_linear};
use crate::model::texture::{Image, Texture, TextureRole};
use halfedge::Color;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;

/// The materials of a document and the images that their textures show.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Materials {
    /// The materials; no two have the same name.
    pub list: Vec<Material>,
    /// The images, which textures refer to by their place here.
    pub images: Vec<Image>,
}

impl Materials {
    /// Whether there is no material.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// The material of this name.
    pub fn get(&self, name: &str) -> Option<&Material> {
        self.list.iter().find(|material| material.name == name)
    }

    /// The image that a texture shows; none where its number is out of range.
    pub fn image(&self, texture: &Texture) -> Option<&Image> {
        self.images.get(texture.image as usize)
    }

    /// The number of an image, which is added unless the same one is there already.
    pub fn add_image(&mut self, image: Image) -> u32 {
        let known = self.images.iter().position(|known| *known == image);
        known.unwrap_or_else(|| {
            self.images.push(image);
            self.images.len() - 1
        }) as u32
    }

    /// Adds the materials of another file. Gives the names of those left out because a different
    /// material has the name already.
    pub(crate) fn add(&mut self, more: Self) -> Vec<String> {
        let mut differing = Vec::new();
        let mut known: HashMap<String, usize> =
            self.list.iter().enumerate().map(|(i, material)| (material.name.clone(), i)).collect();
        for mut material in more.list {
            for texture in &mut material.textures {
                if let Some(image) = more.images.get(texture.image as usize) {
                    texture.image = self.add_image(image.clone());
                }
            }
            match known.get(&material.name).and_then(|&i| self.list.get(i)) {
                None => {
                    known.insert(material.name.clone(), self.list.len());
                    self.list.push(material);
                }
                Some(first) if *first == material => {}
                Some(_) => differing.push(material.name),
            }
        }
        differing
    }

    /// Approximate memory use, in bytes.
    pub fn bytes(&self) -> usize {
        let images = self.images.iter().map(|image| image.bytes.as_ref().map_or(0, |bytes| bytes.len()));
        self.list.iter().map(Material::bytes).sum::<usize>() + images.sum::<usize>()
    }
}

/// How a surface looks. A field is `None` where the file didn't state it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Material {
    /// Its name, which the labels of faces' materials refer to.
    pub name: String,
    /// Base (diffuse) colour.
    pub base_color: Option<Rgb>,
    /// Opacity, from 0 (invisible) to 1 (opaque).
    pub alpha: Option<f32>,
    /// Colour of the light that the surface emits.
    pub emissive: Option<Rgb>,
    /// From 0 (dielectric) to 1 (metal).
    pub metallic: Option<f32>,
    /// From 0 (smooth) to 1 (rough).
    pub roughness: Option<f32>,
    /// Specular colour of the Phong and Blinn models.
    pub specular: Option<Rgb>,
    /// Ambient colour of the Phong and Blinn models.
    pub ambient: Option<Rgb>,
    /// Specular exponent of the Phong and Blinn models.
    pub shininess: Option<f32>,
    /// Ratio of the speed of light in vacuum to that in the material.
    pub index_of_refraction: Option<f32>,
    /// What alpha means.
    pub alpha_mode: Option<AlphaMode>,
    /// Whether back faces are shown.
    pub double_sided: Option<bool>,
    /// The textures, at most one for each role.
    pub textures: Vec<Texture>,
    /// The statements of the MTL library that the material was read from; none for other formats.
    pub mtl: Option<MtlStatements>,
}

impl Material {
    /// The base colour in 8-bit sRGB, as faces have it.
    pub fn color(&self) -> Option<Color> {
        self.base_color.map(Rgb::to_color)
    }

    /// The texture with this role.
    pub fn texture(&self, role: TextureRole) -> Option<&Texture> {
        self.textures.iter().find(|texture| texture.role == role)
    }

    /// What the material states, base colour included, in a fixed order.
    pub(crate) fn properties(&self) -> Vec<Property> {
        let stated = [
            (Property::BaseColor, self.base_color.is_some()),
            (Property::Alpha, self.alpha.is_some_and(|alpha| alpha != 1.0)),
            (Property::Emissive, self.emissive.is_some_and(|color| color != Rgb::BLACK)),
            (Property::Metallic, self.metallic.is_some()),
            (Property::Roughness, self.roughness.is_some()),
            (Property::Specular, self.specular.is_some()),
            (Property::Ambient, self.ambient.is_some()),
            (Property::Shininess, self.shininess.is_some()),
            (Property::IndexOfRefraction, self.index_of_refraction.is_some()),
            (Property::AlphaMode, self.alpha_mode.is_some_and(|mode| mode != AlphaMode::Opaque)),
            (Property::DoubleSided, self.double_sided.is_some()),
        ];
        let stated = stated.into_iter().filter(|(_, is_stated)| *is_stated).map(|(property, _)| property);
        stated.chain(self.textures.iter().map(|texture| Property::Texture(texture.role))).collect()
    }

    /// Approximate memory use, in bytes.
    pub fn bytes(&self) -> usize {
        let mtl = self.mtl.as_ref().map_or(0, |mtl| {
            mtl.diffuse.as_ref().map_or(0, String::len) + mtl.others.len() + size_of::<MtlStatements>()
        });
        size_of::<Self>() + self.name.len() + self.textures.len() * size_of::<Texture>() + mtl
    }
}

/// A property that a material may state and a format may have no place for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Property {
    BaseColor,
    Alpha,
    Emissive,
    Metallic,
    Roughness,
    Specular,
    Ambient,
    Shininess,
    IndexOfRefraction,
    AlphaMode,
    DoubleSided,
    Texture(TextureRole),
    /// Statements of an MTL library that fill no field.
    MtlStatements,
}

impl Property {
    /// What messages call it.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::BaseColor => "base colour",
            Self::Alpha => "alpha",
            Self::Emissive => "emissive colour",
            Self::Metallic => "metallic",
            Self::Roughness => "roughness",
            Self::Specular => "specular colour",
            Self::Ambient => "ambient colour",
            Self::Shininess => "shininess",
            Self::IndexOfRefraction => "index of refraction",
            Self::AlphaMode => "alpha mode",
            Self::DoubleSided => "double sided",
            Self::Texture(role) => role.name(),
            Self::MtlStatements => "other MTL statements",
        }
    }
}

/// A colour in linear light, in double precision: values that a file gives as `f32`, linear or sRGB,
/// come back to the bit. Components may exceed 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rgb([f64; 3]);

impl Rgb {
    /// Black.
    pub const BLACK: Self = Self([0.0; 3]);

    /// A colour from finite linear components, as glTF has them.
    pub fn from_linear(linear: [f32; 3]) -> Self {
        Self(linear.map(f64::from))
    }

    /// A colour from finite sRGB components, as MTL and COLLADA have them.
    pub fn from_srgb(srgb: [f32; 3]) -> Self {
        Self(srgb.map(|channel| linear_from_srgb(f64::from(channel))))
    }

    /// A colour from 8-bit sRGB.
    pub fn from_color(color: Color) -> Self {
        Self::from_srgb(color.0.map(|channel| f32::from(channel) / 255.0))
    }

    /// Linear components.
    pub fn to_linear(self) -> [f32; 3] {
        self.0.map(|channel| channel as f32)
    }

    /// sRGB components.
    pub fn to_srgb(self) -> [f32; 3] {
        self.0.map(|channel| srgb_from_linear(channel) as f32)
    }

    /// 8-bit sRGB, clamped.
    pub fn to_color(self) -> Color {
        Color(self.to_srgb().map(|channel| (channel * 255.0).round().clamp(0.0, 255.0) as u8))
    }
}

/// What a material's alpha means (glTF 2.0, 3.9.4).
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum AlphaMode {
    /// Alpha is ignored.
    Opaque,
    /// Shown where alpha is at least the cutoff, hidden elsewhere.
    Mask {
        /// The cutoff, from 0 to 1.
        cutoff: f32,
    },
    /// Mixed with what lies behind.
    Blend,
}

/// The statements of one material in an MTL library, kept to be written again to the letter.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct MtlStatements {
    /// The readable `Kd` statement's values as text: the OBJ writer replaces them for painted faces.
    pub diffuse: Option<String>,
    /// The other statements, each with a line end.
    pub others: String,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::texture::UvTransform;

    #[test]
    fn materials_survive_serialisation() {
        let mut materials = Materials::default();
        let image = materials.add_image(Image {
            name: "wood.png".to_owned(),
            media_type: Some("image/png".to_owned()),
            bytes: Some([0, 255, 128].as_slice().into()),
        });
        materials.list.push(Material {
            name: "wood".to_owned(),
            base_color: Some(Rgb::from_srgb([0.1, 0.2, 0.3])),
            alpha_mode: Some(AlphaMode::Mask { cutoff: 0.25 }),
            textures: vec![Texture {
                transform: Some(UvTransform { offset: [0.1, 0.2], rotation: 0.3, scale: [1.0, 2.0] }),
                ..Texture::new(TextureRole::BaseColor, image)
            }],
            mtl: Some(MtlStatements { diffuse: None, others: "Ns 9\n".to_owned() }),
            ..Material::default()
        });
        let json = serde_json::to_string(&materials).expect("plain data");
        assert!(json.contains("\"AP+A\""), "{json}");
        assert_eq!(serde_json::from_str::<Materials>(&json).expect("its own output"), materials);
    }

    #[test]
    fn colours_come_back_to_the_bit_in_both_encodings() {
        for k in 0..=100_000u32 {
            let value = k as f32 / 50_000.0;
            let colors = [value, -value, value * 1e-3];
            assert_eq!(Rgb::from_srgb(colors).to_srgb(), colors);
            assert_eq!(Rgb::from_linear(colors).to_linear(), colors);
        }
        let all = (0..=255).map(|k| Color([k, 255 - k, k / 2]));
        assert!(all.into_iter().all(|color| Rgb::from_color(color).to_color() == color));
    }

    #[test]
    fn adding_materials_renumbers_their_images_and_keeps_the_first_of_a_name() {
        let image = |name: &str| Image { name: name.to_owned(), ..Image::default() };
        let textured = |name: &str, image| Material {
            name: name.to_owned(),
            textures: vec![Texture::new(TextureRole::BaseColor, image)],
            ..Material::default()
        };
        let mut all = Materials { list: vec![textured("a", 0)], images: vec![image("x")] };
        let more = Materials {
            list: vec![textured("b", 0), textured("a", 1)],
            images: vec![image("y"), image("x")],
        };
        assert_eq!(all.add(more.clone()), [""; 0]);
        let shown = |all: &Materials, name: &str| {
            let texture = all.get(name).and_then(|material| material.texture(TextureRole::BaseColor));
            texture.and_then(|texture| all.image(texture)).map(|image| image.name.clone())
        };
        assert_eq!((shown(&all, "a"), shown(&all, "b")), (Some("x".to_owned()), Some("y".to_owned())));
        assert_eq!(all.images.len(), 2);
        assert_eq!(all.add(Materials { list: vec![textured("a", 0)], ..more }), ["a"]);
    }
}
