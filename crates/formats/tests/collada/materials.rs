//! Materials: textures and what else effects say of surfaces.

use super::common::{self, by_code, case_file, mesh, read, renamed};
use formats::{Image, Material, Materials, Rgb, Texture, TextureRole, UvTransform, Wrap};
use formats::{Import, Model, NamedBytes};
use glam::{Vec2, Vec3};
use halfedge::attribute::Column;
use halfedge::{Color, Mesh, PolygonSoup, keys};

/// Reads the textured case with these edits, and these files beside it.
fn textured(edits: &[(&str, &str)], files: &[NamedBytes]) -> Import {
    let mut file = case_file("dae-textured.dae");
    let mut text = String::from_utf8(file.bytes).expect("UTF-8");
    for (old, new) in edits {
        assert!(text.contains(old), "{old}");
        text = text.replace(old, new);
    }
    file.bytes = text.into_bytes();
    let mut all = vec![file];
    all.extend_from_slice(files);
    read(&all).expect("readable")
}

/// The texture of this role in the only material.
fn texture(import: &Import, role: TextureRole) -> (&Texture, &Image) {
    let [material] = import.model.materials.list.as_slice() else { panic!("{:?}", import.model.materials) };
    let texture = material.texture(role).expect("a texture");
    (texture, import.model.materials.image(texture).expect("an image"))
}

#[test]
fn a_texture_is_kept_with_its_image() {
    let import = textured(&[], &[]);
    let (texture, image) = texture(&import, TextureRole::BaseColor);
    assert_eq!(
        (image.name.as_str(), image.bytes.is_some(), texture.wrap),
        ("wood.png", false, [Wrap::Repeat; 2])
    );
    assert_eq!(import.model.materials.list[0].name, "wood");
    assert!(import.report.to_string().contains("were not given: wood.png"), "{}", import.report);
    assert_eq!(formats::companions(&case_file("dae-textured.dae")), ["wood.png"]);
    // In an OBJ its library names the image.
    let written = formats::write(by_code("obj"), &renamed(&import, "x")).expect("small");
    assert!(common::text(&written[1]).contains("map_Kd wood.png"), "{}", common::text(&written[1]));
    // A GLB has the texture, or the losses name it.
    let lost = formats::losses(by_code("glb"), &import.model).join("\n");
    let written = formats::write(by_code("glb"), &import.model).expect("small");
    let back = read(&written).expect("its own").model.materials;
    let is_kept = back.get("wood").is_some_and(|wood| wood.texture(TextureRole::BaseColor).is_some());
    assert!(is_kept != lost.contains("base colour texture"), "{lost}");
    // An image given along travels with the model.
    let import = textured(&[], &[NamedBytes::new("folder/wood.png", b"\x89PNG".to_vec())]);
    for format in [by_code("dae"), by_code("obj")] {
        let written = formats::write(format, &renamed(&import, "x")).expect("small");
        let image = written.iter().find(|file| file.name == "wood.png").expect("beside the model");
        assert_eq!(image.bytes, b"\x89PNG");
        let back = read(&written).expect("readable");
        assert_eq!(back.model.materials.images, import.model.materials.images, "{format:?}");
    }
}

#[test]
fn images_are_found_however_they_are_named() {
    let name = |edits: &[(&str, &str)]| texture(&textured(edits, &[]), TextureRole::BaseColor).1.name.clone();
    let path = "<init_from>wood.png</init_from>";
    for (address, expected) in [
        ("./a%20b/wood.png", "a b/wood.png"),
        ("file:///C:/x/wood.png", "C:/x/wood.png"),
        ("file://wood.png", "wood.png"),
        ("textures\\wood.png", "textures/wood.png"),
        ("<ref>wood.png</ref>", "wood.png"),
    ] {
        assert_eq!(name(&[(path, &format!("<init_from>{address}</init_from>"))]), expected, "{address}");
    }
    // The image itself, a sampler of COLLADA 1.5, and a parameter that the material sets.
    assert_eq!(name(&[("texture=\"sm\"", "texture=\"im\"")]), "wood.png");
    assert_eq!(name(&[("<source>s</source>", "<instance_image url=\"#im\"/>")]), "wood.png");
    let planar = "<init_planar><all ref=\"im\"/></init_planar>";
    assert_eq!(name(&[("<init_from>im</init_from>", planar)]), "wood.png");
    let other = "<image id=\"other\"><init_from>other.png</init_from></image></library_images>";
    let set = "<instance_effect url=\"#e\"><setparam ref=\"s\"><surface><init_from>other</init_from></surface></setparam></instance_effect>";
    assert_eq!(name(&[("</library_images>", other), ("<instance_effect url=\"#e\"/>", set)]), "other.png");
    // Bytes in the document.
    let import = textured(&[(path, "<init_from><hex format=\"PNG\">89504E 47</hex></init_from>")], &[]);
    let (_, image) = texture(&import, TextureRole::BaseColor);
    assert_eq!((image.name.as_str(), image.bytes.as_deref()), ("im.png", Some(b"\x89PNG".as_slice())));
}

#[test]
fn what_of_a_material_is_not_kept_is_named() {
    for (edits, expected) in [
        (
            vec![("texture=\"sm\"", "texture=\"gone\"")],
            "its base colour texture is left out: image \"gone\" doesn't exist",
        ),
        (vec![("wood.png", "")], "its base colour texture is left out: it names no file"),
        (
            vec![("<instance_effect url=\"#e\"/>", "<instance_effect url=\"#f\"/>")],
            "its effect \"#f\" doesn't exist",
        ),
        (vec![("target=\"#m\"", "target=\"#n\"")], "material \"#n\" doesn't exist"),
        (
            vec![(
                "</lambert>",
                "<transparent opaque=\"RGB_ZERO\"><texture texture=\"sm\" texcoord=\"UV\"/></transparent></lambert>",
            )],
            "its alpha texture means transparency in the file and opacity here",
        ),
        (vec![("</profile_COMMON>", "</profile_COMMON><profile_GLSL/>")], "its shader programs are left out"),
        (
            vec![(
                "</lambert>",
                "<reflective><color>1 1 1 1</color></reflective><reflectivity><float>1</float></reflectivity></lambert>",
            )],
            "its reflectivity is left out",
        ),
        (
            vec![(
                "</lambert>",
                "<transparent><color>1 1 1 1</color></transparent><transparency><float>0</float></transparency></lambert>",
            )],
            "would be invisible",
        ),
        (
            vec![("</library_materials>", "<material id=\"z\" name=\"zinc\"/></library_materials>")],
            "that no face uses are left out: zinc",
        ),
    ] {
        let import = textured(&edits, &[]);
        assert!(import.report.to_string().contains(expected), "{}\n{edits:?}", import.report);
        assert_eq!(mesh(&import).face_count(), 1);
    }
}

#[test]
fn transparency_has_four_meanings() {
    let alpha = |transparent: &str| {
        let edit = ("</lambert>", &*format!("{transparent}</lambert>"));
        textured(&[edit], &[]).model.materials.list[0].alpha
    };
    let both = |opaque: &str| {
        alpha(&format!(
            "<transparent opaque=\"{opaque}\"><color>0.5 0.5 0.5 0.25</color></transparent><transparency><float>0.5</float></transparency>"
        ))
    };
    assert_eq!(alpha(""), None);
    assert_eq!(alpha("<transparency><float>0.25</float></transparency>"), Some(0.25));
    assert_eq!(both("A_ONE"), Some(0.125));
    assert_eq!(both("A_ZERO"), Some(0.875));
    assert!(both("RGB_ONE").is_some_and(|alpha| (alpha - 0.25).abs() < 1e-6));
    assert!(both("RGB_ZERO").is_some_and(|alpha| (alpha - 0.75).abs() < 1e-6));
}

#[test]
fn the_bound_set_of_texture_coordinates_is_kept() {
    let second = "<input semantic=\"TEXCOORD\" source=\"#t\" offset=\"0\" set=\"0\"/>\
        <input semantic=\"TEXCOORD\" source=\"#u\" offset=\"0\" set=\"1\"/>";
    let source = "<source id=\"u\"><float_array id=\"ua\" count=\"12\">9 9 9 9 9 9 9 9 9 9 9 9</float_array><technique_common>\
        <accessor source=\"#ua\" count=\"6\" stride=\"2\"/></technique_common></source><vertices";
    let edits =
        [("<input semantic=\"TEXCOORD\" source=\"#t\" offset=\"0\"/>", second), ("<vertices", source)];
    let uv = |import: &Import| {
        let mesh = mesh(import);
        let corner = mesh.face_halfedges(mesh.faces().next().expect("a face")).next().expect("a corner");
        mesh.get(keys::CORNER_UV, corner.index())
    };
    let import = textured(&edits, &[]);
    assert_eq!(uv(&import), Vec2::ZERO);
    assert!(import.report.to_string().contains("1 set of texture coordinates left out"), "{}", import.report);
    let bind = "target=\"#m\"><bind_vertex_input semantic=\"UV\" input_semantic=\"TEXCOORD\" input_set=\"1\"/></instance_material>";
    let bound = [edits[0], edits[1], ("target=\"#m\"/>", bind)];
    assert_eq!(uv(&textured(&bound, &[])), Vec2::splat(9.0));
}

/// A mesh of two faces with these materials.
fn with_materials(names: [&str; 2], colors: [Color; 2]) -> Mesh {
    let mut soup = PolygonSoup::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::ONE], &[[0, 1, 2], [1, 3, 2]]);
    let mut labels = names.map(str::to_owned).to_vec();
    labels.dedup();
    let numbers = vec![0, labels.len() as u32 - 1];
    soup.face_columns.push(Column { labels, ..Column::with_values(keys::FACE_MATERIAL, numbers) });
    soup.face_columns.push(Column::with_values(keys::FACE_COLOR, colors.to_vec()));
    Mesh::build(soup).expect("small").mesh
}

#[test]
fn materials_come_back() {
    let color = |r, g, b| Some(Rgb::from_srgb([r, g, b]));
    let roles = [
        TextureRole::Emissive,
        TextureRole::Ambient,
        TextureRole::BaseColor,
        TextureRole::Specular,
        TextureRole::Reflection,
        TextureRole::Alpha,
        TextureRole::Bump,
        TextureRole::Normal,
    ];
    let mut textures: Vec<Texture> = (0..).zip(roles).map(|(i, role)| Texture::new(role, i % 2)).collect();
    textures[0].wrap = [Wrap::Clamp, Wrap::Mirror];
    textures[2].transform = Some(UvTransform { offset: [0.25, -2.5], rotation: 0.0, scale: [2.0, 3.0] });
    textures[3].transform = Some(UvTransform { offset: [0.25, 0.5], rotation: 0.75, scale: [1.0, 1.0] });
    textures[6].scale = 0.5;
    let rich = Material {
        name: "rich & <fine>".to_owned(),
        base_color: color(0.25, 0.5, 0.75),
        alpha: Some(0.5),
        emissive: color(0.125, 0.0, 1.0),
        specular: color(0.1, 0.2, 0.3),
        ambient: color(0.5, 0.5, 0.5),
        shininess: Some(20.5),
        index_of_refraction: Some(1.5),
        double_sided: Some(true),
        textures,
        ..Material::default()
    };
    let plain = Material { name: "plain".to_owned(), emissive: color(1.0, 1.0, 1.0), ..Material::default() };
    let image = |name: &str, bytes: &[u8]| Image {
        name: name.to_owned(),
        media_type: Some("image/png".to_owned()),
        bytes: Some(bytes.into()),
    };
    let images = vec![image("my folder/a#1.png", b"\x89PNG1"), image("b.png", b"\x89PNG2")];
    let materials = Materials { list: vec![rich.clone(), plain], images };
    let own = rich.color().expect("a colour");
    for colors in [[own, Color::UNPAINTED], [own, Color([1, 2, 3])]] {
        let mesh = with_materials(["rich & <fine>", "plain"], colors);
        let model = Model { materials: materials.clone(), ..Model::of_mesh("a", mesh.clone()) };
        assert_eq!(formats::losses(by_code("dae"), &model), [""; 0]);
        let back = read(&formats::write(by_code("dae"), &model).expect("small")).expect("readable");
        assert!(back.report.is_clean(), "{}", back.report);
        assert!(*back.model.objects[0].mesh == mesh);
        let mut expected = materials.clone();
        expected.list[1].base_color = (colors[1] != Color::UNPAINTED).then(|| Rgb::from_color(colors[1]));
        assert_eq!(back.model.materials, expected);
    }
    // Painted faces have materials of their own in the file, and one here.
    let mesh = with_materials(["rich & <fine>", "rich & <fine>"], [own, Color([9, 8, 7])]);
    let model = Model { materials: materials.clone(), ..Model::of_mesh("a", mesh.clone()) };
    let back = read(&formats::write(by_code("dae"), &model).expect("small")).expect("readable");
    assert!(*back.model.objects[0].mesh == mesh);
    assert_eq!(back.model.materials.list, [rich]);
}

#[test]
fn different_materials_of_one_name_get_two() {
    let second = "<material id=\"m2\" name=\"wood\"/></library_materials>";
    let triangles = "</triangles><triangles count=\"1\" material=\"N\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 2 3</p></triangles>";
    let bind = "</technique_common></bind_material>";
    let import = textured(
        &[
            ("</library_materials>", second),
            ("</triangles>", triangles),
            (bind, &format!("<instance_material symbol=\"N\" target=\"#m2\"/>{bind}")),
        ],
        &[],
    );
    let names: Vec<&str> =
        import.model.materials.list.iter().map(|material| material.name.as_str()).collect();
    assert_eq!(names, ["wood", "wood.2"]);
}
