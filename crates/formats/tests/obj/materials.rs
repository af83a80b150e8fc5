//! Materials of an OBJ.

use super::common::{by_code, mesh, read, read_obj, renamed, text, write};
use super::{SQUARE, assert_round_trip, common, labels, some};
use formats::{Materials, Model, NamedBytes, TextureRole};
use halfedge::attribute::{Column, keys};
use halfedge::{Color, Element, Mesh, NONE};
use std::sync::Arc;

#[test]
fn materials_bring_their_colours() {
    let library = "newmtl red\nKd 1 0 0\nnewmtl grey\nKd 0.5 0.5 0.5\nmap_Kd wood.png\nnewmtl plain\n";
    let model = format!("mtllib Some Dir/A.MTL\n{SQUARE}usemtl red\nf 1 2 3\nusemtl plain\nf 1 3 4\n");
    let files = [NamedBytes::new("x/a.mtl", library), NamedBytes::new("x/model.obj", model)];
    let import = read(&files).expect("readable");
    assert_eq!(import.model.name, "model");
    let mesh = mesh(&import);
    assert_eq!(mesh.attribute(keys::FACE_COLOR), Some(&[Color([255, 0, 0]), Color::UNPAINTED][..]));
    assert_eq!(labels(mesh, keys::FACE_MATERIAL), some(&["red", "plain"]));
    assert!(import.report.to_string().contains("Materials that no face uses are left out: grey"));
    assert_round_trip(mesh);
}

#[test]
fn materials_come_back_as_they_were() {
    let library = "newmtl wood\nKd 0.5 0.2 0.2\nKs 0 0 0\nNs 10\nmap_Kd wood.png\n\nnewmtl glass\nd 0.3\n\nnewmtl x\nd 1\n";
    let model = format!("mtllib a.mtl\n{SQUARE}usemtl wood\nf 1 2 3\nusemtl glass\nf 1 3 4\n");
    let import =
        read(&[NamedBytes::new("a.mtl", library), NamedBytes::new("a.obj", model)]).expect("readable");
    let report = import.report.to_string();
    assert!(report.contains("saved as OBJ: Ks (1), Ns (1), map_Kd (1), d (1)"), "{report}");
    assert!(report.contains("Materials that no face uses are left out: x"), "{report}");
    let with = |mesh: &Mesh, materials: &Materials| Model {
        materials: materials.clone(),
        ..Model::of_mesh("a", mesh.clone())
    };
    let written =
        |mesh: &Mesh, format| formats::write(format, &with(mesh, &import.model.materials)).expect("small");
    let kept = library.split("\nnewmtl x").next().expect("a start");
    let files = written(mesh(&import), by_code("obj"));
    assert_eq!(text(&files[1]), format!("# Materials written by Meshwright\n\n{kept}"));
    let back = read(&files).expect("its own");
    assert!(back.model.materials == import.model.materials && common::mesh(&back) == mesh(&import));
    // Faces of another colour have it, and all the rest.
    let mut painted = mesh(&import).clone();
    painted.set(keys::FACE_COLOR, 0, Color([0, 0, 255]));
    let files = written(&painted, by_code("obj"));
    assert_eq!(
        text(&files[1]),
        format!("# Materials written by Meshwright\n\n{}", kept.replace("0.5 0.2 0.2", "0 0 1"))
    );
    painted.set(keys::FACE_COLOR, 0, Color([0, 0, 255]));
    painted.insert_column(Element::Face, {
        let mut one = mesh(&import).column(Element::Face, "material").expect("materials").clone();
        one.values = halfedge::attribute::Values::U32(vec![0, 0]);
        one
    });
    let files = written(&painted, by_code("obj"));
    assert_eq!(text(&files[1]).matches("map_Kd wood.png\n").count(), 2, "{}", text(&files[1]));
    let back = read(&files).expect("its own");
    assert!(!back.report.to_string().contains("that no face uses"), "{}", back.report);
    assert_eq!(back.model.materials.list.len(), 1);
    // Without colours too: a library is written for what it says besides.
    let plain = read(&[
        NamedBytes::new("a.mtl", "newmtl wood\nmap_Kd wood.png\n"),
        NamedBytes::new("a.obj", format!("mtllib a.mtl\n{SQUARE}usemtl wood\nf 1 2 3\nf 1 3 4\n")),
    ])
    .expect("readable");
    let files = formats::write(by_code("obj"), &renamed(&plain, "a")).expect("small");
    assert!(text(&files[1]).ends_with("newmtl wood\nmap_Kd wood.png\n"));
    assert!(common::mesh(&read(&files).expect("its own")) == mesh(&plain));
    // Where no face has the material any more it goes.
    let bare = read_obj(&format!("{SQUARE}f 1 2 3\n"));
    assert_eq!(written(mesh(&bare), by_code("obj")).len(), 1);
    // Other formats say what they lose.
    let lost = formats::losses(by_code("ply"), &import.model).join("\n");
    let expected = "PLY holds less of materials: of 2 materials, specular colour (1), shininess (1), alpha (1) \
                    are lost";
    assert!(lost.contains(expected), "{lost}");
    assert_eq!(formats::losses(by_code("dae"), &import.model), [""; 0]);
    assert_eq!(formats::losses(by_code("obj"), &import.model), [""; 0]);
}

#[test]
fn images_given_with_a_model_are_written_with_it() {
    let png = [0x89, b'P', b'N', b'G', 1, 2, 3];
    let files = [
        NamedBytes::new("model.obj", format!("mtllib sub/a.mtl\n{SQUARE}usemtl wood\nf 1 2 3\n")),
        NamedBytes::new(
            "sub/a.mtl",
            "newmtl wood\nmap_Kd tex\\Wood.png\nbump gone.png\nnewmtl x\nmap_Kd x.png\n",
        ),
        NamedBytes::new("sub/tex/wood.PNG", png),
        NamedBytes::new("x.png", png),
        NamedBytes::new("other.png", png),
    ];
    let import = read(&files).expect("readable");
    let wood = import.model.materials.get("wood").expect("in use");
    let image = import.model.materials.image(wood.texture(TextureRole::BaseColor).expect("a texture"));
    let image = image.expect("an image");
    assert_eq!((image.name.as_str(), image.media_type.as_deref()), ("tex/Wood.png", Some("image/png")));
    assert_eq!(image.bytes.as_deref(), Some(&png[..]));
    assert_eq!(import.model.materials.images.len(), 2, "{:?}", import.model.materials.images);
    let report = import.report.to_string();
    assert!(report.contains("Image files that its materials refer to were not given: gone.png"), "{report}");
    assert!(report.contains("other.png was left out") && !report.contains("ood.png was"), "{report}");
    let written = formats::write(by_code("obj"), &renamed(&import, "a")).expect("small");
    let names: Vec<&str> = written.iter().map(|file| file.name.as_str()).collect();
    assert_eq!(names, ["a.obj", "a.mtl", "tex/Wood.png"]);
    assert_eq!(written[2].bytes, png);
    assert!(text(&written[1]).contains("map_Kd tex\\Wood.png\nbump gone.png\n"));
    assert_eq!(read(&written).expect("its own").model.materials, import.model.materials);
}

#[test]
fn a_painted_face_leaves_the_others_their_material() {
    let library = NamedBytes::new("a.mtl", "newmtl white\nKd 1 1 1\n");
    let model =
        format!("mtllib a.mtl\n{SQUARE}v 2 0 0\nv 2 1 0\nusemtl white\nf 1 2 3\nf 1 3 4\nf 2 5 6\nf 2 6 3\n");
    let import = read(&[NamedBytes::new("a.obj", model), library]).expect("readable");
    let paint = |faces: &[usize]| {
        let mut painted = mesh(&import).clone();
        faces.iter().for_each(|&f| painted.set(keys::FACE_COLOR, f, Color([255, 0, 0])));
        painted
    };
    let none = Materials::default();
    let names = |format, mesh: &Mesh, materials: &Materials| -> String {
        let model = Model { materials: materials.clone(), ..Model::of_mesh("a", mesh.clone()) };
        let files = formats::write(format, &model).expect("small");
        let back = read(&files).expect("its own");
        let colors = |mesh: &Mesh| -> Vec<Color> {
            let mut all: Vec<Color> = mesh.faces().map(|f| mesh.get(keys::FACE_COLOR, f.index())).collect();
            all.sort_by_key(|color| color.0);
            all
        };
        assert_eq!(colors(common::mesh(&back)), colors(mesh), "{format:?}");
        files.iter().map(|file| String::from_utf8_lossy(&file.bytes).into_owned()).collect()
    };
    for faces in [&[0][..], &[3], &[0, 1, 2]] {
        let text = names(by_code("obj"), &paint(faces), &import.model.materials);
        assert!(text.contains("newmtl white\nKd 1 1 1\n"), "{text}");
        assert!(text.contains("newmtl white.color-ff0000\nKd 1 0 0\n"), "{text}");
        for format in [by_code("gltf"), by_code("dae")] {
            let text = names(format, &paint(faces), &import.model.materials);
            assert!(text.contains("white.color-ff0000") && !text.contains("white.color-ffffff"), "{text}");
        }
    }
    // Where no library says what the material's own colour is, most faces do.
    let text = names(by_code("obj"), &paint(&[0]), &none);
    assert!(text.contains("newmtl white\nKd 1 1 1\n") && text.contains("white.color-ff0000"), "{text}");
    let text = names(by_code("obj"), &paint(&[0, 1, 2]), &none);
    assert!(text.contains("newmtl white\nKd 1 0 0\n") && text.contains("white.color-ffffff"), "{text}");
    // Painted all over, the material has that colour.
    let text = names(by_code("obj"), &paint(&[0, 1, 2, 3]), &import.model.materials);
    assert!(text.contains("newmtl white\nKd 1 0 0\n") && !text.contains("color-"), "{text}");
}

#[test]
fn materials_of_one_name_in_two_files_are_told() {
    let file = |name: &str, text: String| NamedBytes::new(name, text);
    let model = |library: &str| format!("mtllib {library}\n{SQUARE}usemtl m\nf 1 2 3\n");
    let files = |second: &str| {
        [
            file("a.obj", model("a.mtl")),
            file("b.obj", model("b.mtl")),
            file("a.mtl", "newmtl m\nKd 1 0 0\nd 1\n".to_owned()),
            file("b.mtl", format!("newmtl m\n{second}")),
        ]
    };
    let import = read(&files("Kd 0 1 0\n")).expect("readable");
    let warnings: Vec<&str> = import.report.warnings().collect();
    assert!(warnings.len() == 1 && warnings[0].starts_with("b.obj: Material m differs"), "{warnings:?}");
    assert_eq!(import.model.materials.list.len(), 1);
    assert_eq!(import.model.objects[1].mesh.get(keys::FACE_COLOR, 0), Color([0, 255, 0]));
    assert!(read(&files("Kd 1 0 0\nd 1\n")).expect("readable").report.is_clean());
}

#[test]
fn painted_faces_come_back_with_or_without_material() {
    let mut import =
        read_obj(&format!("{SQUARE}v 2 0 0\nv 2 1 0\nf 1 2 3\nusemtl wood\nf 1 3 4\nf 2 5 6\nf 2 6 3\n"));
    let mesh = Arc::make_mut(&mut import.model.objects[0].mesh);
    let colors = [Color([1, 2, 3]), Color([250, 128, 7]), Color::UNPAINTED, Color([1, 2, 3])];
    mesh.insert_column(Element::Face, Column::with_values(keys::FACE_COLOR, colors.to_vec()));
    let files = write(by_code("obj"), mesh);
    assert_eq!(files[1].name, "test.mtl");
    assert!(text(&files[0]).contains("mtllib test.mtl\n"));
    assert_eq!(text(&files[1]).matches("newmtl").count(), 4);
    assert_round_trip(mesh);

    // Without the library the painted faces' names still tell their colour.
    let alone = read(&files[..1]).expect("readable");
    let alone = &alone.model.objects[0].mesh;
    assert_eq!(alone.get(keys::FACE_COLOR, 0), colors[0]);
    assert_eq!(alone.get(keys::FACE_COLOR, 3), colors[3]);
    assert_eq!(labels(alone, keys::FACE_MATERIAL), some(&["", "wood", "wood", "wood"]));

    // A face that goes back to no colour after painted ones.
    mesh.insert_column(Element::Face, Column::with_values(keys::FACE_MATERIAL, vec![NONE; 4]));
    let back = read(&write(by_code("obj"), mesh)).expect("readable");
    assert_eq!(back.model.objects[0].mesh.attribute(keys::FACE_COLOR), Some(&colors[..]));
    assert_eq!(back.model.objects[0].mesh.attribute(keys::FACE_MATERIAL), None);
}
