//! The fuzz targets: `cargo fuzz` and the native test `crates/formats/tests/fuzz.rs` both include this
//! file.

use formats::{Format, Image, Import, Material, Materials, NamedBytes, NonManifold, Repairs};
use halfedge::Mesh;
use std::ops::ControlFlow;

/// The targets, one for each parser, with the file name that their bytes get. The name of `any` has no
/// extension, so that the content decides on the format.
#[allow(dead_code, reason = "libFuzzer's binaries name their own target")]
pub const TARGETS: [(&str, &str); 9] = [
    ("any", "any"),
    ("bezier", "a.bez"),
    ("collada", "a.dae"),
    ("gltf", "a.gltf"),
    ("mtl", "a.mtl"),
    ("obj", "a.obj"),
    ("off", "a.off"),
    ("ply", "a.ply"),
    ("stl", "a.stl"),
];

/// An OBJ that material libraries belong to.
const OWNER: &[u8] = b"mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\nusemtl blue\nf 3 2 1\n";

/// Reads bytes as a file of this name. What was read must be valid, and must come back with the same
/// faces from every format that can hold them.
///
/// # Panics
/// It is not or does not: that is what fuzzing looks for.
pub fn run(name: &str, data: &[u8]) {
    let mut files = vec![NamedBytes::new(name, data)];
    if name.ends_with(".mtl") {
        files.insert(0, NamedBytes::new("a.obj", OWNER));
    }
    let Some(import) = read(&files) else { return };
    for object in &import.model.objects {
        check(&object.mesh);
        // Faces that don't form a mesh can be repaired in other ways too.
        for (non_manifold, orient, merge) in [
            (NonManifold::Drop, true, None),
            (NonManifold::Separate, false, None),
            (NonManifold::Drop, false, Some(0.5)),
        ] {
            if let Some(soup) = &object.soup {
                let repairs = Repairs { non_manifold, orient, merge_by_distance: merge };
                check(&formats::rebuild(soup, &repairs).expect("small").0);
            }
        }
    }
    for format in Format::all().filter(|format| format.can_read()) {
        let _ = formats::losses(format, &import.model);
        let Ok(written) = formats::write(format, &import.model) else { continue };
        // The document may hold nothing that the format can hold.
        let Some(back) = read(&written) else { continue };
        if matches!(format.code(), "obj" | "ply" | "off") {
            assert_eq!(sizes(&back), sizes(&import), "{format:?}");
        }
        if format.code() == "obj" {
            for material in &back.model.materials.list {
                // Those of other formats come back with the statements that were made for them.
                let known = import.model.materials.get(&material.name).filter(|known| known.mtl.is_some());
                if let Some(known) = known {
                    assert_eq!(
                        described(&back.model.materials, material),
                        described(&import.model.materials, known)
                    );
                }
            }
        }
    }
}

fn read(files: &[NamedBytes]) -> Option<Import> {
    formats::read(files, &mut |_| ControlFlow::Continue(())).ok()
}

/// A material with the images that it shows in place of their numbers.
fn described(all: &Materials, material: &Material) -> (Material, Vec<Option<Image>>) {
    let images = material.textures.iter().map(|texture| all.image(texture).cloned()).collect();
    let mut material = material.clone();
    material.textures.iter_mut().for_each(|texture| texture.image = 0);
    (material, images)
}

fn check(mesh: &Mesh) {
    mesh.validate().expect("a valid mesh");
    assert!(mesh.positions().iter().all(|position| position.is_finite()), "finite positions");
}

fn sizes(import: &Import) -> [usize; 2] {
    let sum = |count: fn(&Mesh) -> usize| import.model.objects.iter().map(|object| count(&object.mesh)).sum();
    [sum(Mesh::vertex_count), sum(Mesh::face_count)]
}
