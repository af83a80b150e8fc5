//! Reading and writing OBJ, on texts written here.

mod common;

use common::{by_code, mesh, model, read, read_obj, renamed, text, write};
use formats::{Materials, Model, NamedBytes, ReadError, TextureRole};
use glam::{Vec2, Vec3};
use halfedge::attribute::{Column, keys};
use halfedge::{Color, Element, FaceId, Mesh, NONE, PolygonSoup, VertexId};
use std::ops::ControlFlow;
use std::sync::Arc;

fn corners(mesh: &Mesh, face: usize) -> Vec<u32> {
    mesh.face_vertices(FaceId::new(face)).map(|v| v.raw()).collect()
}

fn labels(mesh: &Mesh, key: halfedge::attribute::Key<u32>) -> Vec<Option<String>> {
    let column = mesh.column(Element::Face, key.name);
    mesh.faces()
        .map(|f| {
            let value = mesh.get(key, f.index());
            column.and_then(|column| column.labels.get(value as usize)).cloned()
        })
        .collect()
}

fn some(names: &[&str]) -> Vec<Option<String>> {
    names.iter().map(|name| (!name.is_empty()).then(|| (*name).to_owned())).collect()
}

/// Written and read again, the same mesh to the bit.
fn assert_round_trip(mesh: &Mesh) {
    let files = write(by_code("obj"), mesh);
    let back = read(&files).expect("what was written reads");
    assert_eq!(back.report.warnings().collect::<Vec<_>>(), [""; 0]);
    assert!(common::mesh(&back) == mesh, "{}", text(&files[0]));
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

#[test]
fn all_index_forms_and_negative_indices() {
    for face in [
        "1 2 3 4",
        "1/1 2/2 3/3 4/4",
        "1//1 2//1 3//1 4//1",
        "1/1/1 2/2/1 3/3/1 4/4/1",
        "-4/-4/-1 -3/-3/-1 -2/-2/-1 -1/-1/-1",
    ] {
        let import = read_obj(&format!("{SQUARE}vt 0 0\nvt 1 0\nvt 1 1\nvt 0 .5\nvn 0 0 1\nf {face}\n"));
        let mesh = mesh(&import);
        assert!(import.report.is_clean(), "{face}: {}", import.report);
        assert_eq!(corners(mesh, 0), [0, 1, 2, 3]);
        let last = mesh.face_halfedges(FaceId::new(0)).last().expect("corners").index();
        let has_uv = face.contains('/') && !face.contains("//");
        assert_eq!(
            mesh.attribute(keys::CORNER_UV).map(|uv| uv[last]),
            has_uv.then_some(Vec2::new(0.0, 0.5)),
            "{face}"
        );
        let has_normal = face.matches('/').count() == 8;
        assert_eq!(
            mesh.attribute(keys::CORNER_NORMAL).map(|n| n[last]),
            has_normal.then_some(Vec3::Z),
            "{face}"
        );
        assert_round_trip(mesh);
    }
}

#[test]
fn layout_of_the_text_does_not_matter() {
    let plain = read_obj(&format!("{SQUARE}f 1 2 3 4\n"));
    for text in [
        "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2 3 4\r\n".to_owned(),
        "v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4\r".to_owned(),
        format!("\u{feff}{SQUARE}f 1 2 3 4"),
        format!("# start\n\n   # indented\n{SQUARE}  f\t1  2 3\t4   # end\n#"),
        "v 0 0 \\\n0\nv 1 \\\r\n 0 0\nv 1 1 0 # corner\nv 0 1 0#\nf 1 2 \\\n3 \\\n\\\n4".to_owned(),
        format!("f 1 2 3 4\n{SQUARE}"),
        format!("# a drawing \\_/ \\\n{SQUARE}# another \\\nf 1 2 3 4"),
        format!("{SQUARE}f +1 +2 03 4"),
    ] {
        let import = read_obj(&text);
        assert!(import.report.is_clean(), "{}", import.report);
        assert!(mesh(&import) == mesh(&plain), "{text:?}");
    }
}

#[test]
fn vertices_keep_their_order_whether_used_or_not() {
    let import = read_obj("v 9 9 9\nv 0 0 0\nv 5 5 5\nv 1 0 0\nv 0 1 0\nf 2 4 5\nv 7 7 7");
    let mesh = mesh(&import);
    assert_eq!(mesh.positions().iter().map(|p| p.x).collect::<Vec<_>>(), [9.0, 0.0, 5.0, 1.0, 0.0, 7.0]);
    assert_eq!(corners(mesh, 0), [1, 3, 4]);
    assert_round_trip(mesh);
}

#[test]
fn fourth_coordinates_and_vertex_colours() {
    let import = read_obj("v 0 0 0 2\nv 1 0 0 1 0.5 0.25\nv 1 1 0 1\nv 0 1 0 0.5 1 0 .125\nf 1 2 3 4");
    let mesh = mesh(&import);
    assert_eq!(mesh.position(VertexId::new(0)), Vec3::ZERO);
    let colors = mesh.attribute(keys::VERTEX_COLOR).expect("colours");
    assert!(colors[0].is_nan() && colors[2].is_nan());
    assert_eq!((colors[1], colors[3]), (Vec3::new(1.0, 0.5, 0.25), Vec3::new(1.0, 0.0, 0.125)));
    assert_eq!(
        import.report.warnings().collect::<Vec<_>>(),
        ["2 vertices kept as x, y, z: the fourth coordinate (w) is not used (lines 1, 4)"]
    );
    assert_round_trip(mesh);
}

#[test]
fn groups_objects_materials_and_smoothing_are_kept() {
    let import = read_obj(&format!(
        "mtllib a.mtl\n{SQUARE}v 2 0 0\nv 2 1 0\nv 3 0 0\nv 3 1 0\nf 1 2 3\no car\nf 1 3 4\ng  wheel   left # comment\ns 3\nusemtl red paint\nf 2 5 6\ng unused\ng\nusemtl Material #25\nf 2 6 3\no\ns off\ng wheel left\nf 5 7 8 6\n"
    ));
    let mesh = mesh(&import);
    assert_eq!(
        labels(mesh, keys::FACE_GROUP),
        some(&["", "o car", "o car; g wheel left", "o car", "wheel left"])
    );
    assert_eq!(mesh.column(Element::Face, "group").map(|c| c.labels.len()), Some(3));
    assert_eq!(
        labels(mesh, keys::FACE_MATERIAL),
        some(&["", "", "red paint", "Material #25", "Material #25"])
    );
    assert_eq!(mesh.attribute(keys::FACE_SMOOTHING), Some(&[0, 0, 3, 3, 0][..]));
    assert_eq!(mesh.attribute(keys::FACE_COLOR), None);
    assert!(import.report.to_string().contains("a.mtl, which was not given"), "{}", import.report);
    let files = write(by_code("obj"), mesh);
    assert_eq!(files.len(), 1, "no colours, so no file that could replace the real materials");
    assert_round_trip(mesh);
}

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
    assert!(import.report.to_string().contains("1 material that no face has left out: grey"));
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
    assert!(report.contains("1 material that no face has left out: x"), "{report}");
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
    assert!(!back.report.to_string().contains("that no face has"), "{}", back.report);
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
    let expected = "PLY holds less of materials: of 2 materials, specular colour (1), shininess (1), base colour \
                    texture (1), alpha (1) are lost";
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
    assert!(
        report.contains("1 image that its materials use not given, so only referred to: gone.png"),
        "{report}"
    );
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
    assert!(warnings.len() == 1 && warnings[0].starts_with("b.obj: Material m is another"), "{warnings:?}");
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

#[test]
fn several_objects_are_sections() {
    let first = read_obj(&format!("{SQUARE}vt 1 1\nusemtl m\ns 2\ng front\nf 1/1 2/1 3/1\no tail\nf 1 3 4"));
    let second = read_obj("v 5 5 5\nv 6 5 5\nv 5 6 5\nvt .5 .5\nf 1/1 2/1 3/1");
    let (a, b) = (mesh(&first), mesh(&second));
    let files = formats::write(by_code("obj"), &model("both", &[("a", a), ("b\n", b)])).expect("small");
    let back = read(&files).expect("readable");
    let both = mesh(&back);
    assert_eq!((both.vertex_count(), both.face_count()), (7, 3));
    assert_eq!(corners(both, 2), [4, 5, 6]);
    assert_eq!(labels(both, keys::FACE_GROUP), some(&["o a; g front", "o a; g tail", "o b"]));
    assert_eq!(both.attribute(keys::FACE_SMOOTHING), Some(&[2, 2, 0][..]));
    let uv = both.attribute(keys::CORNER_UV).expect("both have some");
    let uv_of = |face: usize| uv[both.halfedge_of(FaceId::new(face)).index()];
    assert_eq!((uv_of(0), uv_of(2)), (Vec2::ONE, Vec2::splat(0.5)));
    assert!(uv_of(1).is_nan());
}

#[test]
fn damage_is_named_by_line_and_the_rest_loads() {
    let import = read_obj(&format!(
        "{SQUARE}v 1 x 2\nv 1 2\nvt a\nvn 1 2\nf 1 2 3\nf 1 2\nf 1 2 seven\nf 1 3 9\nf 0 1 2\nf -9 1 2\nf 1/7 3//2 4\nblah 1\nl 1 2\np 1\nv 1 2 3 4 5\nf 1 2 3.5\nf 1 3 4x\ns many\ncurv 0 1 1 2\n"
    ));
    let mesh = mesh(&import);
    assert_eq!((mesh.vertex_count(), mesh.face_count()), (7, 2));
    assert_eq!(mesh.position(VertexId::new(4)), Vec3::ZERO);
    assert_eq!(corners(mesh, 1), [0, 2, 3]);
    let report = import.report.to_string();
    for expected in [
        "Read 7 vertices and 2 faces as OBJ",
        "3 vertices put at the origin: a vertex is \"v\" and three numbers, a fourth (w) or a colour of three may follow (lines 5, 6, 19)",
        "3 faces left out: a corner can't be read as vertex numbers, like 1 or 1/2/3 (lines 11, 20, 21)",
        "1 face left out: a face needs three corners or more (line 10)",
        "3 faces left out: a corner refers to a vertex that doesn't exist (lines 13, 14, 12)",
        "2 corners without texture coordinate or normal: the one it refers to doesn't exist (line 15, …)",
        "1 texture coordinate ignored: not one to three numbers (line 7)",
        "1 normal ignored: not three numbers (line 8)",
        "1 smoothing group ignored: neither a number nor \"off\" (line 22)",
        "2 line or point elements (l, p) left out: only faces are edited here (lines 17, 18)",
        "1 statement left out: free-form curves and surfaces and display settings are not used here (line 23)",
        "1 line ignored: it doesn't start with a word of the OBJ format (line 16)",
    ] {
        assert!(report.contains(expected), "{expected}\nnot in\n{report}");
    }
}

#[test]
fn what_the_build_changes_is_in_the_report() {
    let import = read_obj(&format!(
        "{SQUARE}g a\nf 1 2 2\ng b\nf 1 2 3\ng c\nf 3 2 1 1\nf 1 2 3\nf 1 4 3\nv nan 0 0\n"
    ));
    let mesh = mesh(&import);
    assert_eq!(mesh.face_count(), 2);
    assert_eq!(labels(mesh, keys::FACE_GROUP), some(&["b", "c"]));
    assert_eq!(import.report.warnings().count(), 5, "{}", import.report);
    assert_round_trip(mesh);
}

#[test]
fn nonsense_is_an_error_and_says_why() {
    let error = |name: &str, bytes: &[u8]| match read(&[NamedBytes::new(name, bytes)]) {
        Ok(import) => panic!("{name} was read: {}", import.report),
        Err(error) => error.to_string(),
    };
    assert_eq!(
        error("a.obj", b"hello\nworld"),
        "a.obj: this is not an OBJ: none of its 2 lines is a vertex (\"v 1 2 3\") or a face (\"f 1 2 3\"); nothing else \
         that Meshwright opens is in it either, so check that it is the right file, or export the model again"
    );
    assert!(error("a.obj", b"").contains("not an OBJ: none of its 0 lines"));
    assert!(error("a.obj", b"v 1 2 3\nf 1\0 2 3").contains("binary"));
    assert!(error("a.obj", b"\xff\xfev\0 \0").contains("UTF-16"));
    assert!(error("photo.png", b"\x89PNG").contains("photo.png is not a model"));
    assert!(error("a.mtl", b"newmtl a").contains("open it together with the OBJ model"));
    assert!(read(&[]).is_err());
}

#[test]
fn an_empty_mesh_goes_through() {
    assert_round_trip(&Mesh::new());
    let import = read_obj("o nothing\n");
    assert_eq!(mesh(&import).vertex_count(), 0);
}

#[test]
fn reading_can_be_cancelled_at_any_point() {
    let mut text = String::from("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    while text.len() < 3 << 20 {
        text.push_str("# a comment that makes the file long\nv 0 0 0\n");
    }
    let files = [NamedBytes::new("long.obj", text)];
    let mut told = Vec::new();
    formats::read(&files, &mut |part| {
        told.push(part);
        ControlFlow::Continue(())
    })
    .expect("readable");
    assert!(
        told.len() >= 4 && told.is_sorted() && told.iter().all(|part| (0.0..=1.0).contains(part)),
        "{told:?}"
    );
    for stop_at in 0..told.len() {
        let mut calls = 0;
        let result = formats::read(&files, &mut |_| {
            calls += 1;
            if calls > stop_at { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        assert_eq!(result, Err(ReadError::Cancelled));
    }
}

#[test]
fn several_files_make_one_document() {
    let model = |x: f32| format!("v {x} 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n");
    let files = [
        NamedBytes::new("one.obj", model(0.0)),
        NamedBytes::new("notes.doc", "?"),
        NamedBytes::new("two", model(2.0)),
    ];
    let import = read(&files).expect("readable");
    assert_eq!(import.model.objects.iter().map(|o| o.name.as_str()).collect::<Vec<_>>(), ["one", "two"]);
    assert_eq!(import.model.objects[1].mesh.position(VertexId::new(0)).x, 2.0);
    let warnings: Vec<_> = import.report.warnings().collect();
    assert_eq!(warnings.len(), 3);
    assert!(warnings[0].starts_with("one.obj: 1 face left out") && warnings[1].starts_with("two: "));
    assert!(warnings[2].starts_with("notes.doc was left out"));
    assert_eq!(import.model.objects.len(), 2);
}

#[test]
fn ids_with_gaps_are_written_without() {
    let positions = (0..6).map(|i| Vec3::new(i as f32, (i * i) as f32, 0.5)).collect();
    let mut mesh =
        Mesh::build(PolygonSoup::new(positions, &[[0, 1, 2], [0, 2, 3], [3, 4, 5]])).expect("small").mesh;
    let removed = halfedge::edit::delete_faces(&mut mesh, &[FaceId::new(1)]);
    assert!(removed.is_ok() && !mesh.is_compact());
    let back = read(&write(by_code("obj"), &mesh)).expect("readable");
    assert!(back.model.objects[0].mesh.to_soup() == mesh.to_soup());
}
