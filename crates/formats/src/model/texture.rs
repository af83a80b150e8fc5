//! Textures of materials, and the images that they show.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use serde::de::{self, Visitor};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::fmt;
use std::sync::Arc;

/// The use of an image by a material.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Texture {
    /// What its values are for.
    pub role: TextureRole,
    /// The image, by its place in [`Materials::images`].
    pub image: u32,
    /// Which set of texture coordinates places it, from 0.
    #[serde(default)]
    pub uv_set: u32,
    /// What lies beyond the image's edges along u and v.
    #[serde(default)]
    pub wrap: [Wrap; 2],
    /// Factor of its values: scale of a normal map, strength of occlusion, height of bumps.
    #[serde(default = "one")]
    pub scale: f32,
    /// How texture coordinates are moved before the image is looked up.
    #[serde(default)]
    pub transform: Option<UvTransform>,
}

fn one() -> f32 {
    1.0
}

impl Texture {
    /// A texture that repeats, with the first set of texture coordinates.
    pub fn new(role: TextureRole, image: u32) -> Self {
        Self { role, image, uv_set: 0, wrap: [Wrap::Repeat; 2], scale: 1.0, transform: None }
    }
}

/// What a texture's values are for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum TextureRole {
    /// Base (diffuse) colour, possibly with alpha.
    BaseColor,
    /// Normals in tangent space.
    Normal,
    /// Heights, from which normals are derived.
    Bump,
    /// Heights that move the surface.
    Displacement,
    /// Emitted light.
    Emissive,
    /// Metallic in the blue channel and roughness in the green one.
    MetallicRoughness,
    /// Metallic alone.
    Metallic,
    /// Roughness alone.
    Roughness,
    /// Ambient occlusion, in the red channel.
    Occlusion,
    /// Specular colour.
    Specular,
    /// Specular exponent.
    Shininess,
    /// Ambient colour.
    Ambient,
    /// Alpha alone.
    Alpha,
    /// Reflected surroundings.
    Reflection,
    /// Blended over the base colour.
    Decal,
}

impl TextureRole {
    /// All roles.
    pub const ALL: [Self; 15] = [
        Self::BaseColor,
        Self::Normal,
        Self::Bump,
        Self::Displacement,
        Self::Emissive,
        Self::MetallicRoughness,
        Self::Metallic,
        Self::Roughness,
        Self::Occlusion,
        Self::Specular,
        Self::Shininess,
        Self::Ambient,
        Self::Alpha,
        Self::Reflection,
        Self::Decal,
    ];

    /// What messages call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::BaseColor => "base colour texture",
            Self::Normal => "normal map",
            Self::Bump => "bump map",
            Self::Displacement => "displacement map",
            Self::Emissive => "emissive texture",
            Self::MetallicRoughness => "metallic-roughness texture",
            Self::Metallic => "metallic texture",
            Self::Roughness => "roughness texture",
            Self::Occlusion => "occlusion texture",
            Self::Specular => "specular texture",
            Self::Shininess => "shininess texture",
            Self::Ambient => "ambient texture",
            Self::Alpha => "alpha texture",
            Self::Reflection => "reflection map",
            Self::Decal => "decal",
        }
    }
}

/// What lies beyond an image's edge.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Wrap {
    /// The image again.
    #[default]
    Repeat,
    /// The image mirrored.
    Mirror,
    /// The pixels of its edge.
    Clamp,
}

/// A transform of texture coordinates: scaled, then rotated, then moved. It applies to coordinates whose
/// v counts from the top of the image, as in glTF's `KHR_texture_transform`; the mesh's own count from
/// the bottom.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct UvTransform {
    /// Added to u and v.
    pub offset: [f32; 2],
    /// Counter-clockwise angle in radians.
    pub rotation: f32,
    /// Factors of u and v.
    pub scale: [f32; 2],
}

/// An image file.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct Image {
    /// Its file name as the model refers to it, possibly with folders, separated by `/`; a reader names an
    /// embedded image.
    pub name: String,
    /// Its media type, like `image/png`, where it is known.
    pub media_type: Option<String>,
    /// The file's contents: of an image that was embedded or given with the model.
    #[serde(serialize_with = "write_bytes", deserialize_with = "read_bytes")]
    pub bytes: Option<Arc<[u8]>>,
}

impl Image {
    /// The image's name without folders.
    pub fn file_name(&self) -> &str {
        self.name.rsplit(['/', '\\']).next().unwrap_or_default()
    }
}

/// Bytes are base64 in text formats such as JSON, and bytes in binary ones.
fn write_bytes<S: Serializer>(bytes: &Option<Arc<[u8]>>, serializer: S) -> Result<S::Ok, S::Error> {
    struct Bytes<'a>(&'a [u8]);
    impl Serialize for Bytes<'_> {
        fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
            match serializer.is_human_readable() {
                true => serializer.serialize_str(&STANDARD.encode(self.0)),
                false => serializer.serialize_bytes(self.0),
            }
        }
    }
    bytes.as_deref().map(Bytes).serialize(serializer)
}

fn read_bytes<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Option<Arc<[u8]>>, D::Error> {
    struct Bytes(Arc<[u8]>);
    struct BytesVisitor;
    impl Visitor<'_> for BytesVisitor {
        type Value = Bytes;

        fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            f.write_str("bytes or base64 text")
        }

        fn visit_str<E: de::Error>(self, text: &str) -> Result<Bytes, E> {
            STANDARD.decode(text).map(|bytes| Bytes(bytes.into())).map_err(E::custom)
        }

        fn visit_bytes<E: de::Error>(self, bytes: &[u8]) -> Result<Bytes, E> {
            Ok(Bytes(bytes.into()))
        }
    }
    impl<'de> Deserialize<'de> for Bytes {
        fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
            match deserializer.is_human_readable() {
                true => deserializer.deserialize_str(BytesVisitor),
                false => deserializer.deserialize_bytes(BytesVisitor),
            }
        }
    }
    Ok(Option::<Bytes>::deserialize(deserializer)?.map(|bytes| bytes.0))
}
