//! Reports the content that a mesh editor doesn't keep.

use super::json::{Document, IMAGES, MATERIALS, MESHES, NODES, Object, SCENES, TEXTURES};
use super::names::{
    EMISSIVE_STRENGTH, IMAGE_EXTENSIONS, INDEX_OF_REFRACTION, SPECULAR_GLOSSINESS, TEXTURE_TRANSFORM,
};
use super::{draco, meshopt};
use crate::notes::{Fault, Notes};
use crate::report::first_few;
use halfedge::words::counted;

/// Extensions whose content is kept, or reported elsewhere.
const KNOWN_EXTENSIONS: [&str; 6] = [
    "KHR_mesh_quantization",
    "KHR_lights_punctual",
    TEXTURE_TRANSFORM,
    EMISSIVE_STRENGTH,
    INDEX_OF_REFRACTION,
    SPECULAR_GLOSSINESS,
];

/// Notes the content of a document besides meshes and materials.
pub(super) fn note(document: &Document, notes: &mut Notes) {
    let root = document.root();
    let lights = root.extension("KHR_lights_punctual").map_or(0, |lights| lights.list("lights").len());
    let counts = [
        (root.list("animations").len(), "animation", "animations"),
        (root.list("cameras").len(), "camera", "cameras"),
        (lights, "light", "lights"),
    ];
    let counts = counts.into_iter().filter(|(count, ..)| *count > 0);
    let counts: Vec<String> = counts.map(|(count, one, many)| counted(count, one, many)).collect();
    if !counts.is_empty() {
        notes.info(format!("Not kept: {}", counts.join(", ")));
    }
    let extras = extras(document);
    if extras > 0 {
        notes.info(format!("The extras of {} are not kept", counted(extras, "item", "items")));
    }
    let names = |key: &str| root.list(key).iter().filter_map(|name| name.as_str());
    let unknown = |name: &&str| {
        !KNOWN_EXTENSIONS.contains(name)
            && !meshopt::EXTENSIONS.contains(name)
            && *name != draco::EXTENSION
            && !IMAGE_EXTENSIONS.iter().any(|(known, _)| known == name)
    };
    let mut required: Vec<&str> = names("extensionsRequired").filter(unknown).collect();
    let mut used: Vec<&str> = names("extensionsUsed").filter(unknown).collect();
    for list in [&mut required, &mut used] {
        list.sort_unstable();
        list.dedup();
    }
    used.retain(|name| !required.contains(name));
    // Meshes can be read without the extensions of materials and textures.
    let (materials, others): (Vec<&str>, Vec<&str>) =
        required.into_iter().partition(|name| name.contains("_materials_") || name.contains("_texture_"));
    used.extend(materials);
    for name in others {
        notes.fault(
            Fault::Scene,
            format!("what the file needs the extension {name} for, which can't be read: meshes may be missing or wrong"),
        );
    }
    if !used.is_empty() {
        notes.info(format!("The content of extensions is not kept: {}", first_few(&used, 12)));
    }
}

/// How many items hold data of programs.
fn extras(document: &Document) -> usize {
    let is_extra = |item: &Object| {
        // Names of morph targets are named with those.
        let fields = item.object("extras").map(|extras| extras.fields().any(|(key, _)| key != "targetNames"));
        fields.unwrap_or(item.get("extras").is_some())
    };
    let lists = [SCENES, NODES, MESHES, MATERIALS, TEXTURES, IMAGES].into_iter();
    let items = lists.flat_map(|list| document.items(list));
    let primitives = document.items(MESHES).flat_map(|mesh| mesh.objects("primitives"));
    let root = document.root();
    items.chain(primitives).chain([root]).chain(root.object("asset")).filter(is_extra).count()
}
