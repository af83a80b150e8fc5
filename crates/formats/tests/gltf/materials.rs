//! Materials, textures and images, read, and written in several formats.

use super::build::Doc;
use super::common::{self, by_code, case_file, mesh, read};
use formats::{
    AlphaMode, Image, Import, Material, Materials, Model, NamedBytes, Rgb, Texture, TextureRole, UvTransform,
    Wrap,
};
use glam::{Vec2, Vec3};
use halfedge::attribute::{Column, keys};
use halfedge::{Color, Mesh, PolygonSoup};
use serde_json::{Value, json};

fn open(doc: &Doc) -> Import {
    read(&[doc.file()]).unwrap_or_else(|error| panic!("{error}"))
}

/// The square with this material.
fn with_material(material: Value) -> Doc {
    let mut doc = Doc::square();
    doc.json["materials"] = json!([material]);
    doc.json["meshes"][0]["primitives"][0]["material"] = json!(0);
    doc
}

fn material(import: &Import) -> &Material {
    let [material] = import.model.materials.list.as_slice() else { panic!("{:?}", import.model.materials) };
    material
}

#[test]
fn a_textured_material_is_kept() {
    let import = read(&[case_file("gltf-textured.gltf")]).expect("readable");
    assert!(import.report.is_clean(), "{}", import.report);
    let materials = &import.model.materials;
    let skin = material(&import);
    assert_eq!(skin.name, "skin");
    assert_eq!((skin.metallic, skin.roughness, skin.base_color), (Some(0.7), Some(0.2), None));
    assert_eq!(
        (skin.emissive, skin.alpha_mode),
        (Some(Rgb::from_linear([1.0, 0.0, 0.0])), Some(AlphaMode::Blend))
    );
    let image = materials.image(skin.texture(TextureRole::BaseColor).expect("a texture")).expect("an image");
    assert_eq!((image.name.as_str(), image.media_type.as_deref()), ("image0.png", Some("image/png")));
    assert!(image.bytes.as_ref().is_some_and(|bytes| bytes.starts_with(b"\x89PNG")));
    assert_eq!(mesh(&import).column(halfedge::Element::Face, "material").expect("kept").labels, ["skin"]);
    // It comes back from both ways of writing glTF, and from one file alone.
    for code in ["glb", "gltf"] {
        let files = formats::write(by_code(code), &import.model).expect("small");
        assert_eq!(formats::losses(by_code(code), &import.model), [""; 0]);
        assert_eq!(files.iter().any(|file| file.name == "image0.png"), code == "gltf", "{code}");
        for files in [files.clone(), vec![formats::single_file(files).expect("one")]] {
            let back = read(&files).expect("readable");
            assert_eq!(back.model.materials, *materials, "{code}");
            assert!(mesh(&back) == mesh(&import) && back.report.is_clean(), "{}", back.report);
        }
    }
    // An OBJ has what its library has a statement for; the rest is named.
    let files = formats::write(by_code("obj"), &import.model).expect("small");
    let library = common::text(files.iter().find(|file| file.name.ends_with(".mtl")).expect("a library"));
    for statement in ["map_Kd image0.png", "Ke 1 0 0", "Pm 0.7", "Pr 0.2"] {
        assert!(library.contains(statement), "{library}");
    }
    assert!(files.iter().any(|file| file.name == "image0.png"));
    let lost = formats::losses(by_code("obj"), &import.model).join("\n");
    assert!(lost.contains("alpha mode") && !lost.contains("texture"), "{lost}");
}

#[test]
fn factors_are_read_with_their_defaults() {
    let of = |value: Value| material(&open(&with_material(value))).clone();
    // A surface is a rough metal unless it says otherwise, and shows its front.
    let plain = of(json!({ "name": "a" }));
    assert_eq!((plain.metallic, plain.roughness, plain.double_sided), (Some(1.0), Some(1.0), Some(false)));
    let plain =
        of(json!({ "name": "a", "pbrMetallicRoughness": { "metallicFactor": 0 }, "doubleSided": true }));
    assert_eq!((plain.metallic, plain.roughness, plain.double_sided), (None, None, Some(true)));
    let glass = of(json!({
        "pbrMetallicRoughness": { "baseColorFactor": [0.25, 0.5, 1, 0.5] }, "alphaMode": "MASK",
        "emissiveFactor": [0.5, 0.25, 0], "extensions": {
            "KHR_materials_emissive_strength": { "emissiveStrength": 6 }, "KHR_materials_ior": { "ior": 1.25 } },
    }));
    assert_eq!(glass.name, "material 0");
    assert_eq!((glass.base_color, glass.alpha), (Some(Rgb::from_linear([0.25, 0.5, 1.0])), Some(0.5)));
    assert_eq!(glass.emissive, Some(Rgb::from_linear([3.0, 1.5, 0.0])));
    assert_eq!(
        (glass.alpha_mode, glass.index_of_refraction),
        (Some(AlphaMode::Mask { cutoff: 0.5 }), Some(1.25))
    );
    let old = json!({ "extensions": { "KHR_materials_pbrSpecularGlossiness": {
        "diffuseFactor": [1, 0, 0, 1], "glossinessFactor": 0.75 } } });
    let import = open(&with_material(old));
    assert_eq!(
        (material(&import).base_color, material(&import).roughness),
        (Some(Rgb::from_linear([1.0, 0.0, 0.0])), Some(0.25))
    );
    assert!(import.report.to_string().contains("its specular colour is left out"), "{}", import.report);
}

#[test]
fn faults_in_a_material_are_named() {
    for (value, says) in [
        (
            json!({ "pbrMetallicRoughness": { "baseColorFactor": "red" } }),
            "its \"baseColorFactor\" is not 4 numbers",
        ),
        (json!({ "alphaMode": "FOG" }), "its alpha mode \"FOG\" is unknown"),
        (json!({ "normalTexture": { "index": 5 } }), "its normal map is left out: texture 5 doesn't exist"),
        (json!({ "normalTexture": {} }), "its normal map is left out: it has no \"index\""),
        (json!({ "normalTexture": { "index": 0 } }), "its normal map is left out: it shows no image"),
        (json!({ "normalTexture": { "index": 1 } }), "its normal map is left out: image 9 doesn't exist"),
        (json!({ "normalTexture": { "index": 2 } }), "its normal map is left out: image 0 has no data"),
        (json!({ "normalTexture": { "index": 3 } }), "its normal map is left out: its data is not in base64"),
        (json!({ "normalTexture": { "index": 4 } }), "its normal map is left out: sampler 3 doesn't exist"),
    ] {
        let mut doc = with_material(value.clone());
        doc.json["textures"] =
            json!([{}, { "source": 9 }, { "source": 0 }, { "source": 1 }, { "source": 2, "sampler": 3 }]);
        doc.json["images"] = json!([{}, { "uri": "data:image/png;base64,!" }, { "uri": "a.png" }]);
        let import = open(&doc);
        assert!(import.report.to_string().contains(says), "{} instead of {says}", import.report);
        assert_eq!(mesh(&import).face_count(), 2, "{value}");
    }
    let mut doc = Doc::square();
    doc.json["meshes"][0]["primitives"][0]["material"] = json!(4);
    doc.json["materials"] = json!([{ "name": "spare" }]);
    let report = open(&doc).report.to_string();
    assert!(report.contains("its material is left out (material 4 doesn't exist)"), "{report}");
    assert!(report.contains("Materials that no face uses are left out: material \"spare\""), "{report}");
}

/// The square with a base colour texture of the first image, and two sets of texture coordinates.
fn textured(info: Value, texture: Value, images: Value) -> Doc {
    let mut doc = with_material(json!({ "name": "m", "pbrMetallicRoughness": { "baseColorTexture": info } }));
    let first = doc.floats("VEC2", &[0.0; 8]);
    let second = doc.floats("VEC2", &[0.5; 8]);
    let attributes = &mut doc.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["TEXCOORD_0"] = json!(first);
    attributes["TEXCOORD_1"] = json!(second);
    doc.json["textures"] = json!([texture]);
    doc.json["images"] = images;
    doc.json["samplers"] = json!([{ "wrapS": 33071, "wrapT": 33648, "magFilter": 9728 }]);
    doc
}

#[test]
fn textures_keep_their_place_and_edges() {
    let info = json!({ "index": 0, "extensions": { "KHR_texture_transform": { "offset": [0.5, 0.25], "rotation": 1.5, "scale": [2, 3], "texCoord": 1 } } });
    let import =
        open(&textured(info, json!({ "source": 0, "sampler": 0 }), json!([{ "uri": "my%20wood.png" }])));
    let texture = material(&import).texture(TextureRole::BaseColor).expect("a texture");
    assert_eq!(texture.wrap, [Wrap::Clamp, Wrap::Mirror]);
    assert_eq!(
        texture.transform,
        Some(UvTransform { offset: [0.5, 0.25], rotation: 1.5, scale: [2.0, 3.0] })
    );
    assert_eq!(import.model.materials.images[0].name, "my wood.png");
    // Corners have the texture coordinates that the texture uses; the others are named.
    let uvs = mesh(&import).attribute(keys::CORNER_UV).expect("uvs");
    assert!(uvs.iter().filter(|uv| !uv.is_nan()).all(|&uv| uv == Vec2::splat(0.5)));
    let report = import.report.to_string();
    assert!(report.contains("mesh \"square\": TEXCOORD_0 left out"), "{report}");
    assert!(report.contains("How textures are filtered"), "{report}");
    assert_eq!(
        formats::companions(
            &textured(json!({ "index": 0 }), json!({}), json!([{ "uri": "a%20b.png" }])).file()
        ),
        ["a b.png"]
    );
}

#[test]
fn textures_of_other_texture_coordinates_are_named() {
    let mut doc = textured(json!({ "index": 0 }), json!({ "source": 0 }), json!([{ "uri": "a.png" }]));
    doc.json["materials"][0]["occlusionTexture"] = json!({ "index": 0, "texCoord": 1, "strength": 0.5 });
    let import = open(&doc);
    let says = "its occlusion texture has other texture coordinates in the file than corners have here";
    assert!(import.report.to_string().contains(says), "{}", import.report);
    assert_eq!(material(&import).texture(TextureRole::Occlusion).expect("kept").scale, 0.5);
}

#[test]
fn embedded_images_are_files_of_different_names() {
    let png = "data:image/png;base64,iVBORw0KGgo=";
    let other = "data:;base64,iVBORw0KGgoA";
    let images =
        json!([{ "uri": png, "name": "wood.png" }, { "uri": other, "name": "wood" }, { "uri": png }]);
    let mut doc = textured(json!({ "index": 0 }), json!({ "source": 0 }), images);
    doc.json["textures"] = json!([{ "source": 0 }, { "source": 1 }, { "source": 2 }]);
    for (i, key) in ["normalTexture", "emissiveTexture"].iter().enumerate() {
        doc.json["materials"][0][*key] = json!({ "index": i + 1 });
    }
    let import = open(&doc);
    let names: Vec<&str> = import.model.materials.images.iter().map(|image| image.name.as_str()).collect();
    assert_eq!(names, ["wood.png", "wood.png", "image2.png"]);
    let files = formats::write(by_code("gltf"), &import.model).expect("small");
    let names: Vec<&str> = files.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(names, ["a.gltf", "a.bin", "wood.png", "wood-2.png", "image2.png"]);
    for code in ["glb", "gltf"] {
        let back = read(&formats::write(by_code(code), &import.model).expect("small")).expect("readable");
        let images = |import: &Import| -> Vec<_> {
            import.model.materials.images.iter().map(|image| image.bytes.clone()).collect()
        };
        assert_eq!(images(&back), images(&import), "{code}");
    }
}

#[test]
fn images_of_extensions_are_kept_and_written_with_them() {
    let webp = NamedBytes::new("gone.webp", b"RIFF\0\0\0\0WEBP".to_vec());
    let import = read(&[case_file("gltf-webp-texture-missing.gltf"), webp]).expect("readable");
    assert!(import.report.is_clean(), "{}", import.report);
    for code in ["glb", "gltf"] {
        let files = formats::write(by_code(code), &import.model).expect("small");
        let text = String::from_utf8_lossy(&files[0].bytes);
        assert!(text.contains("\"extensionsRequired\":[\"EXT_texture_webp\"]"), "{text}");
        assert_eq!(read(&files).expect("readable").model.materials, import.model.materials, "{code}");
    }
    // The copy that every program shows is taken.
    let texture = json!({ "source": 0, "extensions": { "EXT_texture_webp": { "source": 1 } } });
    let import =
        open(&textured(json!({ "index": 0 }), texture, json!([{ "uri": "a.png" }, { "uri": "a.webp" }])));
    assert_eq!(import.model.materials.images[0].name, "a.png");
}

/// A model of a square in halves with these materials.
fn halves(names: [&str; 2], colors: [Color; 2], materials: Materials) -> Model {
    let mut soup = PolygonSoup::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::ONE], &[[0, 1, 2], [1, 3, 2]]);
    let mut labels = names.map(str::to_owned).to_vec();
    labels.dedup();
    let numbers = vec![0, labels.len() as u32 - 1];
    soup.face_columns.push(Column { labels, ..Column::with_values(keys::FACE_MATERIAL, numbers) });
    soup.face_columns.push(Column::with_values(keys::FACE_COLOR, colors.to_vec()));
    Model { materials, ..Model::of_mesh("x", Mesh::build(soup).expect("small").mesh) }
}

/// A material with everything that glTF holds, and one that says little.
fn rich_and_plain() -> Materials {
    let roles = [
        TextureRole::BaseColor,
        TextureRole::MetallicRoughness,
        TextureRole::Normal,
        TextureRole::Occlusion,
        TextureRole::Emissive,
    ];
    let mut textures: Vec<Texture> = (0..).zip(roles).map(|(i, role)| Texture::new(role, i % 3)).collect();
    textures[0].wrap = [Wrap::Clamp, Wrap::Mirror];
    textures[1].transform = Some(UvTransform { offset: [0.25, -2.5], rotation: 0.75, scale: [2.0, 3.0] });
    textures[2].scale = 0.5;
    textures[3].scale = 0.25;
    let rich = Material {
        name: "rich \"and\" fine".to_owned(),
        base_color: Some(Rgb::from_linear([0.1, 0.5, 0.75])),
        alpha: Some(0.3),
        emissive: Some(Rgb::from_linear([0.1, 5.0, 0.0])),
        metallic: Some(0.7),
        roughness: Some(0.2),
        index_of_refraction: Some(1.3),
        alpha_mode: Some(AlphaMode::Mask { cutoff: 0.3 }),
        double_sided: Some(false),
        textures,
        ..Material::default()
    };
    let plain = Material {
        name: "plain".to_owned(),
        emissive: Some(Rgb::from_linear([1.0; 3])),
        ..Material::default()
    };
    let image = |name: &str, kind: &str, bytes: &[u8]| Image {
        name: name.to_owned(),
        media_type: Some(format!("image/{kind}")),
        bytes: Some(bytes.into()),
    };
    let images = vec![
        image("my folder/a#1.png", "png", b"\x89PNG1"),
        image("b.webp", "webp", b"RIFF\0\0\0\0WEBP"),
        Image { name: "../c.jpg".to_owned(), media_type: Some("image/jpeg".to_owned()), bytes: None },
    ];
    Materials { list: vec![rich, plain], images }
}

#[test]
fn materials_come_back() {
    let materials = rich_and_plain();
    let own = materials.list[0].color().expect("a colour");
    for colors in [[own, Color::UNPAINTED], [own, Color([1, 2, 3])]] {
        let model = halves(["rich \"and\" fine", "plain"], colors, materials.clone());
        for code in ["glb", "gltf"] {
            assert_eq!(formats::losses(by_code(code), &model), [""; 0]);
            let back = read(&formats::write(by_code(code), &model).expect("small")).expect("readable");
            assert!(back.report.is_clean(), "{}", back.report);
            assert!(*back.model.objects[0].mesh == *model.objects[0].mesh, "{code}");
            let mut expected = materials.clone();
            expected.list[1].base_color = (colors[1] != Color::UNPAINTED).then(|| Rgb::from_color(colors[1]));
            // Formats of 32-bit floats: colours in linear light come back to 32 bits.
            let linear = |color: Option<Rgb>| color.map(Rgb::to_linear);
            assert_eq!(linear(back.model.materials.list[1].base_color), linear(expected.list[1].base_color));
            expected.list[1].base_color = back.model.materials.list[1].base_color;
            assert_eq!(back.model.materials, expected, "{code}");
        }
    }
    // Painted faces have materials of their own in the file, and one here, whichever comes first.
    for colors in [[own, Color([9, 8, 7])], [Color([9, 8, 7]), own]] {
        let model = halves(["rich \"and\" fine", "rich \"and\" fine"], colors, materials.clone());
        let back = read(&formats::write(by_code("glb"), &model).expect("small")).expect("readable");
        assert!(*back.model.objects[0].mesh == *model.objects[0].mesh);
        assert_eq!(back.model.materials.list, materials.list[..1]);
    }
}

#[test]
fn what_gltf_has_no_place_for_is_named() {
    let mut materials = rich_and_plain();
    let shiny = &mut materials.list[1];
    shiny.shininess = Some(20.0);
    shiny.specular = Some(Rgb::BLACK);
    shiny.textures = vec![Texture::new(TextureRole::Bump, 0), Texture::new(TextureRole::Specular, 0)];
    materials.list[0].textures[0].image = 3;
    materials.images.push(Image {
        name: "x/d.bmp".to_owned(),
        media_type: Some("image/bmp".to_owned()),
        bytes: None,
    });
    let colors = [Color::UNPAINTED; 2];
    let model = halves(["rich \"and\" fine", "plain"], colors, materials);
    let lost = formats::losses(by_code("glb"), &model);
    assert_eq!(
        lost,
        [
            "GLB holds less of materials: of 1 material, specular colour (1), shininess (1), bump map (1), specular texture (1) are lost",
            "glTF holds PNG, JPEG, WebP, KTX 2, AVIF and DDS images: programs may not show d.bmp",
        ]
    );
    assert!(read(&formats::write(by_code("glb"), &model).expect("small")).is_ok());
}

#[test]
fn transparent_materials_of_other_formats_are_shown_so() {
    let glass = Material { name: "glass".to_owned(), alpha: Some(0.5), ..Material::default() };
    let materials = Materials { list: vec![glass], ..Materials::default() };
    let model = halves(["glass", "glass"], [Color::UNPAINTED; 2], materials);
    let files = formats::write(by_code("gltf"), &model).expect("small");
    assert!(common::text(&files[0]).contains("\"alphaMode\":\"BLEND\""));
    let back = read(&files).expect("readable");
    assert_eq!((material(&back).alpha, material(&back).alpha_mode), (Some(0.5), Some(AlphaMode::Blend)));
}
