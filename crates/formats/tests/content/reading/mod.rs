//! Reading: what a file holds is in the model, or the report names it.

mod collada;
mod gltf;
mod plain;

use super::common::read;
use formats::{Format, Import, NamedBytes, TextureRole};
use glam::{Vec2, Vec3};
use halfedge::attribute::{AttributeType, Key};
use halfedge::{Color, Element, Mesh, keys};

/// The kinds of content that files of some format hold.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Materials,
    Textures,
    FaceColors,
    VertexColors,
    Normals,
    TextureCoordinates,
    SecondTextureCoordinates,
    Groups,
    Names,
    Skins,
    Morphs,
    Animations,
    Lines,
    Points,
    Cameras,
    Lights,
    CustomAttributes,
    Metadata,
}

use Kind::*;

const KINDS: [Kind; 18] = [
    Materials,
    Textures,
    FaceColors,
    VertexColors,
    Normals,
    TextureCoordinates,
    SecondTextureCoordinates,
    Groups,
    Names,
    Skins,
    Morphs,
    Animations,
    Lines,
    Points,
    Cameras,
    Lights,
    CustomAttributes,
    Metadata,
];

/// A file with one kind of content besides a triangle, and what becomes of that.
struct Sample {
    files: Vec<NamedBytes>,
    becomes: Becomes,
}

enum Becomes {
    /// It is in the model, as the check finds.
    Kept(fn(&Import) -> bool),
    /// The report says these words.
    Named(&'static str),
}

use Becomes::{Kept, Named};

fn mesh(import: &Import) -> &Mesh {
    &import.model.objects[0].mesh
}

/// Whether some element has this value.
fn has<T: AttributeType + PartialEq>(import: &Import, key: Key<T>, value: T) -> bool {
    mesh(import).attribute(key).is_some_and(|values| values.contains(&value))
}

fn has_label(import: &Import, key: Key<u32>, label: &str) -> bool {
    let column = mesh(import).column(Element::Face, key.name);
    column.is_some_and(|column| column.labels.iter().any(|own| own == label))
}

fn has_vertex_color(import: &Import) -> bool {
    has(import, keys::VERTEX_COLOR, Vec3::X)
}

fn has_red_faces(import: &Import) -> bool {
    has(import, keys::FACE_COLOR, Color([255, 0, 0]))
}

fn has_normal(import: &Import) -> bool {
    has(import, keys::CORNER_NORMAL, Vec3::Z)
}

fn has_uv(import: &Import) -> bool {
    has(import, keys::CORNER_UV, Vec2::new(0.5, 0.25))
}

fn has_roughness(import: &Import) -> bool {
    let materials = &import.model.materials.list;
    materials.iter().any(|material| {
        material.name == "m" && (material.roughness == Some(0.25) || material.shininess == Some(9.0))
    })
}

fn has_texture(import: &Import) -> bool {
    let materials = &import.model.materials;
    let texture = materials.get("m").and_then(|material| material.texture(TextureRole::BaseColor));
    let image = texture.and_then(|texture| materials.image(texture));
    image.is_some_and(|image| image.name == "a.png" && image.bytes.as_deref() == Some(b"\x89PNG"))
}

fn has_point(import: &Import) -> bool {
    import.model.objects.iter().any(|object| object.mesh.positions().contains(&Vec3::splat(9.0)))
}

fn has_name(import: &Import) -> bool {
    import.model.objects.iter().any(|object| object.name == "part")
        || has_label(import, keys::FACE_GROUP, "o part")
}

fn image() -> NamedBytes {
    NamedBytes::new("a.png", *b"\x89PNG")
}

fn file(name: &str, text: impl Into<Vec<u8>>) -> Vec<NamedBytes> {
    vec![NamedBytes::new(name, text)]
}

/// The sample of each format and kind; none where files of the format can't hold the kind.
fn sample(format: &str, kind: Kind) -> Option<Sample> {
    let (files, becomes) = match format {
        "obj" => plain::obj(kind)?,
        "ply" => plain::ply(kind)?,
        "stl" => plain::stl(kind)?,
        "off" => plain::off(kind)?,
        "dae" => collada::dae(kind)?,
        "gltf" => gltf::text(kind)?,
        "glb" => gltf::binary(kind)?,
        // Control points alone.
        "bzc" | "bez" => return None,
        format => panic!("no samples of {format}"),
    };
    Some(Sample { files, becomes })
}

#[test]
fn what_a_file_holds_is_in_the_model_or_in_the_report() {
    let mut wrong = Vec::new();
    for format in Format::all().filter(|format| format.can_read()) {
        for kind in KINDS {
            let Some(Sample { files, becomes }) = sample(format.code(), kind) else { continue };
            let name = format!("{kind:?} in {}", format.name());
            let import = match read(&files) {
                Ok(import) => import,
                Err(error) => {
                    wrong.push(format!("{name}: {error}"));
                    continue;
                }
            };
            let report = &import.report;
            match becomes {
                Kept(is_there) if !is_there(&import) => wrong.push(format!("{name}: not kept: {report}")),
                Kept(is_there) => {
                    let written = formats::write(format, &import.model).expect("what was read");
                    let back = read(&written).expect("its own");
                    if !is_there(&back) && formats::losses(format, &import.model).is_empty() {
                        wrong.push(format!("{name}: not written: {}", back.report));
                    }
                }
                Named(words) if !report.to_string().contains(words) => {
                    wrong.push(format!("{name}: not named: {report}"));
                }
                _ => {}
            }
            assert_eq!(
                import.model.objects.iter().map(|object| object.mesh.face_count()).max(),
                Some(usize::from(!is_points_alone(format, kind))),
                "{name}"
            );
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Whether the sample is points without a triangle.
fn is_points_alone(format: Format, kind: Kind) -> bool {
    kind == Points && matches!(format.code(), "ply" | "off")
}
