//! Names and numbers of the format that the reader and the writer share.

/// The generator that our files state. In our files a node without a mesh is an empty object, as a mesh
/// needs at least one primitive.
pub(super) const GENERATOR: &str = "Meshwright";

/// The attribute with the number of each row's vertex, as four bytes in little-endian order, because
/// attributes can't have 32-bit integers. Written only if several vertices share a position.
pub(super) const VERTEX_ID: &str = "_VERTEX_ID";

/// The first bytes of a binary file.
pub(super) const MAGIC: &[u8; 4] = b"glTF";
pub(super) const JSON_CHUNK: u32 = 0x4e4f_534a;
pub(super) const BIN_CHUNK: u32 = 0x004e_4942;

/// Extensions for textures with other kinds of images, with the media type of each.
pub(super) const IMAGE_EXTENSIONS: [(&str, &str); 4] = [
    ("EXT_texture_webp", "image/webp"),
    ("KHR_texture_basisu", "image/ktx2"),
    ("EXT_texture_avif", "image/avif"),
    ("MSFT_texture_dds", "image/vnd-ms.dds"),
];

/// The extension that transforms texture coordinates.
pub(super) const TEXTURE_TRANSFORM: &str = "KHR_texture_transform";
/// The extension for emissive colours brighter than 1.
pub(super) const EMISSIVE_STRENGTH: &str = "KHR_materials_emissive_strength";
pub(super) const INDEX_OF_REFRACTION: &str = "KHR_materials_ior";
/// The archived extension that older files use instead of metallic and roughness.
pub(super) const SPECULAR_GLOSSINESS: &str = "KHR_materials_pbrSpecularGlossiness";

/// Wrap modes of samplers; all others repeat the image.
pub(super) const CLAMP_TO_EDGE: usize = 33071;
pub(super) const MIRRORED_REPEAT: usize = 33648;
