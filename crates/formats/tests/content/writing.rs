//! Writing: what a format holds reads back, and [`formats::losses`] names the rest.

use super::common::{by_code, model, read, tetrahedron};
use formats::{
    AlphaMode, Bezier, Format, Image, Material, Materials, Model, NamedMesh, Rgb, Texture, TextureRole,
    UvTransform, Wrap,
};
use glam::{DVec3, Vec2, Vec3};
use halfedge::attribute::{Column, Key};
use halfedge::{Color, Element, Mesh, NONE, PolygonSoup, keys};
use std::sync::Arc;

/// A kind of content: a model that has it and nothing else of note, whether another model still has it,
/// and what the losses of a format that has no place for it say: one of several words with `|` between.
struct Kind {
    name: String,
    model: Model,
    is_kept: Box<dyn Fn(&Model) -> bool>,
    loss: &'static str,
}

fn kind(
    name: impl Into<String>,
    model: Model,
    loss: &'static str,
    is_kept: impl Fn(&Model) -> bool + 'static,
) -> Kind {
    Kind { name: name.into(), model, is_kept: Box::new(is_kept), loss }
}

/// A tetrahedron without attributes.
fn plain() -> Mesh {
    let soup = tetrahedron().to_soup();
    Mesh::build(PolygonSoup {
        positions: soup.positions,
        corners: soup.corners,
        face_starts: soup.face_starts,
        ..PolygonSoup::default()
    })
    .expect("small")
    .mesh
}

fn of(mesh: Mesh) -> Model {
    Model::of_mesh("m", mesh)
}

/// The first mesh of a model.
fn first(model: &Model) -> &Mesh {
    &model.objects[0].mesh
}

/// The positions and values of all elements that have a value, sorted: vertices and faces may come back in
/// another order.
fn values<T: halfedge::attribute::AttributeType + std::fmt::Debug>(mesh: &Mesh, key: Key<T>) -> Vec<String> {
    let has = |index: usize| mesh.attribute(key).and_then(|values| values.get(index)).copied();
    let value = |index: usize| has(index).map_or("none".to_owned(), |value| format!("{value:?}"));
    let corners = |f| {
        let mut at: Vec<String> = mesh.face_vertices(f).map(|v| mesh.position(v).to_string()).collect();
        at.sort();
        at.join(" ")
    };
    let mut all: Vec<String> = match key.element {
        Element::Vertex => {
            mesh.vertices().map(|v| format!("{} {}", mesh.position(v), value(v.index()))).collect()
        }
        Element::Edge => mesh.edges().map(|e| value(e.index())).collect(),
        Element::Face => mesh.faces().map(|f| format!("{} {}", corners(f), value(f.index()))).collect(),
        Element::Halfedge => mesh
            .halfedges()
            .filter_map(|h| Some((h, mesh.face_of(h)?)))
            .map(|(h, f)| format!("{} {} {}", corners(f), mesh.position(mesh.from(h)), value(h.index())))
            .collect(),
    };
    all.sort();
    all
}

/// The kind of a mesh attribute, the same for all or different for neighbours.
fn attribute<T: halfedge::attribute::AttributeType + std::fmt::Debug>(
    name: &str,
    key: Key<T>,
    loss: &'static str,
    value: impl Fn(usize) -> T,
) -> Kind {
    let mut mesh = plain();
    let count = match key.element {
        Element::Vertex => mesh.vertex_capacity(),
        Element::Edge => mesh.edge_capacity(),
        Element::Face => mesh.face_capacity(),
        Element::Halfedge => mesh.halfedge_capacity(),
    };
    (0..count).for_each(|i| mesh.set(key, i, value(i)));
    let wanted = values(&mesh, key);
    kind(name, of(mesh), loss, move |back| values(first(back), key) == wanted)
}

/// The labels of faces, sorted with their places.
fn labels(mesh: &Mesh, key: Key<u32>) -> Vec<String> {
    let names = mesh.column(Element::Face, key.name).map_or(&[][..], |column| &column.labels);
    let label = |number: u32| names.get(number as usize).map_or("none", String::as_str);
    let place = |f| mesh.face_vertices(f).map(|v| mesh.position(v)).sum::<Vec3>();
    let mut all: Vec<String> =
        mesh.faces().map(|f| format!("{} {}", place(f), label(mesh.get(key, f.index())))).collect();
    all.sort();
    all
}

fn labelled(name: &str, key: Key<u32>, loss: &'static str) -> Kind {
    let mut mesh = plain();
    mesh.insert_column(
        Element::Face,
        Column {
            labels: vec!["first".to_owned(), "second one".to_owned()],
            ..Column::with_values(key, vec![0, 1, NONE, 0])
        },
    );
    let wanted = labels(&mesh, key);
    kind(name, of(mesh), loss, move |back| labels(first(back), key) == wanted)
}

/// A model all of whose faces have this material, with images for its textures.
fn with_material(material: Material) -> Model {
    let mut mesh = plain();
    mesh.insert_column(
        Element::Face,
        Column { labels: vec!["m".to_owned()], ..Column::with_values(keys::FACE_MATERIAL, vec![0; 4]) },
    );
    if let Some(color) = material.color() {
        mesh.insert_column(Element::Face, Column::with_values(keys::FACE_COLOR, vec![color; 4]));
    }
    let image = |name: &str| Image {
        name: name.to_owned(),
        media_type: Some("image/png".to_owned()),
        bytes: Some([b"\x89PNG", name.as_bytes()].concat().into()),
    };
    let materials = Materials {
        list: vec![Material { name: "m".to_owned(), ..material }],
        images: vec![image("one.png"), image("two.png")],
    };
    Model { materials, ..of(mesh) }
}

/// The kind of a property of a material, which `property` gives.
fn property<T: PartialEq + 'static>(
    name: impl Into<String>,
    loss: &'static str,
    material: Material,
    property: impl Fn(&Materials, &Material) -> T + 'static,
) -> Kind {
    let model = with_material(material);
    let wanted = property(&model.materials, &model.materials.list[0]);
    // A format without names of materials may hold their properties.
    kind(name, model, loss, move |back| {
        back.materials.list.iter().any(|material| property(&back.materials, material) == wanted)
    })
}

/// A texture of a material with the image that it shows in place of its number.
fn shown(all: &Materials, material: &Material, role: TextureRole) -> Option<(Texture, Option<Image>)> {
    let texture = material.texture(role)?;
    Some((Texture { image: 0, ..texture.clone() }, all.image(texture).cloned()))
}

fn texture(name: impl Into<String>, loss: &'static str, texture: Texture) -> Kind {
    let role = texture.role;
    let material = Material { textures: vec![texture], ..Material::default() };
    property(name, loss, material, move |all, material| shown(all, material, role))
}

fn kinds() -> Vec<Kind> {
    let mut kinds = mesh_kinds();
    kinds.extend(material_kinds());
    let triangle = [Vec3::ZERO, Vec3::X, Vec3::Y].to_vec();
    let points: Vec<Vec3> = (0..16).map(|i| Vec3::new((i % 4) as f32, (i / 4) as f32, 0.0)).collect();
    for (name, bezier, loss) in [
        ("a curve", Bezier::from_points(true, triangle), "c is left out"),
        ("a surface", Bezier::from_points(false, points), "control points"),
    ] {
        let mesh = bezier.preview().expect("small");
        let bezier = Some(Arc::new(bezier));
        let mut model = model("m", &[("beside", &plain())]);
        model.objects.push(NamedMesh { bezier: bezier.clone(), ..NamedMesh::new("c", mesh) });
        kinds.push(kind(name, model, loss, move |back| {
            back.objects.iter().any(|object| object.bezier == bezier)
        }));
    }
    kinds
}

fn mesh_kinds() -> Vec<Kind> {
    let square = [Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::Y].to_vec();
    let quad = Mesh::build(PolygonSoup::new(square, &[[0, 1, 2, 3]])).expect("small").mesh;
    let points = |places: &[[f32; 2]]| places.iter().map(|&[x, y]| Vec3::new(x, y, 0.0)).collect::<Vec<_>>();
    let polygon = |places: &[[f32; 2]]| {
        let corners: Vec<u32> = (0..places.len() as u32).collect();
        Mesh::build(PolygonSoup::new(points(places), &[corners])).expect("small").mesh
    };
    let pentagon = polygon(&[[0.0, 0.0], [2.0, 0.0], [3.0, 1.0], [1.0, 2.0], [-1.0, 1.0]]);
    let concave = polygon(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [2.0, 1.0], [1.0, 1.0], [0.0, 4.0]]);
    let mut isolated = plain().to_soup();
    isolated.positions.push(Vec3::splat(9.0));
    let isolated = Mesh::build(isolated).expect("small").mesh;
    let mut coincident = plain().to_soup();
    coincident.positions.extend_from_within(..);
    let twice: Vec<u32> = coincident.corners.iter().map(|&v| v + 4).collect();
    for face in twice.chunks(3) {
        coincident.push_face(face.iter().copied());
    }
    let coincident = Mesh::build(coincident).expect("small").mesh;
    let mut moved = plain();
    for v in moved.vertices().collect::<Vec<_>>() {
        moved.set_position(v, moved.position(v) + 5.0);
    }
    let far = DVec3::new(50_000_000.0, 0.0, -70_000_000.0);
    let color = |i: usize| Color([i as u8 * 51, 51, 255]);
    let channels = |i: usize| Vec3::new((i as u8 * 51) as f32 / 255.0, 1.0, 0.0);
    vec![
        kind(
            "names of objects",
            model("m", &[("left", &plain()), ("right", &moved)]),
            "2 objects become one",
            |back| {
                // In an OBJ they are groups.
                let groups = back.objects.iter().flat_map(|object| labels(&object.mesh, keys::FACE_GROUP));
                let names: Vec<String> =
                    back.objects.iter().map(|object| object.name.clone()).chain(groups).collect();
                ["left", "right"].iter().all(|name| names.iter().any(|found| found.ends_with(name)))
            },
        ),
        kind("polygons", of(quad), "1 polygon is cut", |back| first(back).face_count() == 1),
        kind("polygons of five corners", of(pentagon), "1 polygon is cut", |back| {
            first(back).faces().map(|f| first(back).face_degree(f)).eq([5])
        }),
        kind("concave polygons", of(concave.clone()), "1 polygon is cut", move |back| {
            let mesh = first(back);
            let corners = |mesh: &Mesh| -> Vec<Vec3> {
                mesh.faces().flat_map(|f| mesh.face_vertices(f)).map(|v| mesh.position(v)).collect()
            };
            mesh.face_count() == 1 && corners(mesh) == corners(&concave)
        }),
        kind("isolated vertices", of(isolated), "1 vertex is left out", |back| {
            first(back).vertex_count() == 5
        }),
        kind("vertices at one place", of(coincident), "4 vertices at the same place", |back| {
            first(back).vertex_count() == 8
        }),
        kind(
            "far positions",
            Model { offset: far, ..of(plain()) },
            "positions so far from the origin are rounded",
            move |back| {
                let places = first(back).positions().iter().map(|p| p.as_dvec3() + back.offset);
                let places: Vec<DVec3> = places.collect();
                [far, far + DVec3::X].iter().all(|place| places.contains(place))
            },
        ),
        attribute("face colours", keys::FACE_COLOR, "no face colours|bits for a channel", color),
        attribute("vertex colours", keys::VERTEX_COLOR, "no vertex colours", channels),
        attribute("one texture coordinate a vertex", keys::CORNER_UV, "no texture coordinates", |_| {
            Vec2::new(0.25, 0.5)
        }),
        attribute("texture coordinates", keys::CORNER_UV, "texture coordinate", |i| Vec2::new(i as f32, 0.5)),
        attribute("one normal a vertex", keys::CORNER_NORMAL, "no corner normals", |_| Vec3::Z),
        attribute("normals", keys::CORNER_NORMAL, "normal", |i| [Vec3::X, Vec3::Y, Vec3::Z][i % 3]),
        attribute("smoothing groups", keys::FACE_SMOOTHING, "no smoothing groups", |i| i as u32 + 1),
        attribute("edge creases", keys::EDGE_CREASE, "no creases", |i| i as f32),
        attribute("vertex creases", keys::VERTEX_CREASE, "no creases", |i| i as f32),
        attribute("vertex attributes", Key::new(Element::Vertex, "quality", f32::NAN), "attribute", |i| {
            i as f32
        }),
        attribute("face attributes", Key::new(Element::Face, "flags", 0u32), "attribute", |i| i as u32 + 1),
        labelled("groups", keys::FACE_GROUP, "no face groups"),
        labelled("names of materials", keys::FACE_MATERIAL, "no material names"),
    ]
}

fn material_kinds() -> Vec<Kind> {
    let plain = Material::default;
    let rgb = |r: f32, g: f32, b: f32| Some(Rgb::from_srgb([r, g, b]));
    let number = Some(0.25);
    let mut kinds = vec![
        property(
            "base colour",
            "material",
            Material { base_color: rgb(0.2, 0.4, 1.0), ..plain() },
            |_, m| m.base_color.map(Rgb::to_srgb),
        ),
        property("alpha", "alpha", Material { alpha: number, ..plain() }, |_, m| m.alpha),
        property(
            "emissive colour",
            "emissive",
            Material { emissive: rgb(0.5, 0.25, 1.0), ..plain() },
            |_, m| m.emissive.map(Rgb::to_srgb),
        ),
        property("metallic", "metallic", Material { metallic: number, ..plain() }, |_, m| m.metallic),
        property("roughness", "roughness", Material { roughness: number, ..plain() }, |_, m| m.roughness),
        property(
            "specular colour",
            "specular",
            Material { specular: rgb(0.5, 0.25, 0.75), ..plain() },
            |_, m| m.specular.map(Rgb::to_srgb),
        ),
        property(
            "ambient colour",
            "ambient",
            Material { ambient: rgb(0.5, 0.25, 0.75), ..plain() },
            |_, m| m.ambient.map(Rgb::to_srgb),
        ),
        property("shininess", "shininess", Material { shininess: Some(20.5), ..plain() }, |_, m| m.shininess),
        property(
            "index of refraction",
            "index of refraction",
            Material { index_of_refraction: Some(1.25), ..plain() },
            |_, m| m.index_of_refraction,
        ),
        // Where nothing is stated, faces are seen from both sides.
    ];
    for mode in [AlphaMode::Mask { cutoff: 0.25 }, AlphaMode::Blend] {
        kinds.push(property(
            format!("{mode:?}"),
            "alpha mode",
            Material { alpha_mode: Some(mode), ..plain() },
            |_, m| m.alpha_mode,
        ));
    }
    for role in TextureRole::ALL {
        kinds.push(texture(role.name(), role.name(), Texture::new(role, 1)));
    }
    let base = || Texture::new(TextureRole::BaseColor, 0);
    let transform = |rotation, scale| Some(UvTransform { offset: [0.5, 0.25], rotation, scale });
    for (name, placed) in [
        ("wrapped", Texture { wrap: [Wrap::Clamp; 2], ..base() }),
        ("wrapped differently", Texture { wrap: [Wrap::Mirror, Wrap::Clamp], ..base() }),
        ("second set", Texture { uv_set: 1, ..base() }),
        ("moved", Texture { transform: transform(0.0, [2.0, 4.0]), ..base() }),
        ("turned", Texture { transform: transform(0.5, [1.0, 1.0]), ..base() }),
        ("scaled bumps", Texture { scale: 0.5, ..Texture::new(TextureRole::Bump, 0) }),
        ("scaled normals", Texture { scale: 0.5, ..Texture::new(TextureRole::Normal, 0) }),
    ] {
        kinds.push(texture(name, "texture|bump map|normal map", placed));
    }
    kinds
}

/// The formats whose files are read again, and as which format.
fn readable() -> impl Iterator<Item = Format> {
    Format::all().filter(|format| format.can_write() && *format != by_code("json"))
}

#[test]
fn what_a_format_holds_comes_back_and_the_rest_is_named() {
    let mut wrong = Vec::new();
    for kind in kinds() {
        for format in readable() {
            let losses = formats::losses(format, &kind.model).join("\n");
            let last = kind.model.objects.last().map_or("", |object| &object.name);
            let is_named = kind.loss.split('|').any(|word| losses.to_lowercase().contains(word))
                || losses.contains(&format!("{last} is left out"));
            let Ok(files) = formats::write(format, &kind.model) else {
                assert!(format.is_bezier(), "{}: {format:?}", kind.name);
                continue;
            };
            let back = read(&files).unwrap_or_else(|error| panic!("{} in {format:?}: {error}", kind.name));
            let is_kept = (kind.is_kept)(&back.model);
            if is_kept == is_named {
                let what = if is_kept { "kept, but named as lost" } else { "lost without a word" };
                wrong.push(format!("{} in {}: {what} ({losses})", kind.name, format.name()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
