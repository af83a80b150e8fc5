//! Words and numbers that readers and writers of glTF share.

/// The generator that our files name. In these a node without a mesh is an empty object: the format has no
/// meshes with nothing to draw.
pub(super) const GENERATOR: &str = "Meshwright";

/// The attribute with the number of the vertex that a row is one of, as four bytes, low ones first: the
/// format has no 32-bit numbers for attributes. Written where vertices lie at one place, which would
/// become one.
pub(super) const VERTEX_ID: &str = "_VERTEX_ID";

/// The first bytes of a binary file.
pub(super) const MAGIC: &[u8; 4] = b"glTF";
pub(super) const JSON_CHUNK: u32 = 0x4e4f_534a;
pub(super) const BIN_CHUNK: u32 = 0x004e_4942;

/// Extensions that put another kind of image in a texture's place, each with its media type.
pub(super) const IMAGE_EXTENSIONS: [(&str, &str); 4] = [
    ("EXT_texture_webp", "image/webp"),
    ("KHR_texture_basisu", "image/ktx2"),
    ("EXT_texture_avif", "image/avif"),
    ("MSFT_texture_dds", "image/vnd-ms.dds"),
];

/// Where texture coordinates are moved before an image is looked up.
pub(super) const TEXTURE_TRANSFORM: &str = "KHR_texture_transform";
/// The factor of an emissive colour brighter than 1.
pub(super) const EMISSIVE_STRENGTH: &str = "KHR_materials_emissive_strength";
pub(super) const INDEX_OF_REFRACTION: &str = "KHR_materials_ior";
/// The archived extension that many older files have in place of metal and roughness.
pub(super) const SPECULAR_GLOSSINESS: &str = "KHR_materials_pbrSpecularGlossiness";

/// How samplers number what lies beyond an image's edges.
pub(super) const CLAMP_TO_EDGE: usize = 33071;
pub(super) const MIRRORED_REPEAT: usize = 33648;
