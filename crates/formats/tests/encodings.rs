//! Text files in every encoding: UTF-8, UTF-16 with and without a byte order mark, and Latin-1.

mod common;

use common::{by_code, case_file, mesh, read};
use formats::{Bezier, Format, Import, Model, NamedBytes};
use glam::Vec3;
use halfedge::attribute::Column;
use halfedge::{Element, Mesh, PolygonSoup, keys};
use surface::bezier::Curve;

const NAME: &str = "Körper é";

/// A triangle in a group and of a material with accents in their names.
fn triangle() -> Mesh {
    let corners = vec![Vec3::ZERO, Vec3::X, Vec3::Y];
    let mut mesh = Mesh::build(PolygonSoup::new(corners, &[[0u32, 1, 2]])).expect("small").mesh;
    for key in [keys::FACE_GROUP, keys::FACE_MATERIAL] {
        let labels = vec![NAME.to_owned()];
        mesh.insert_column(Element::Face, Column { labels, ..Column::with_values(key, vec![0]) });
    }
    mesh
}

/// What text formats write of it, or of a Bezier curve.
fn written() -> Vec<(Format, Vec<NamedBytes>)> {
    let codes = ["obj", "ply-text", "stl-text", "off", "dae", "gltf", "bzc"];
    codes
        .map(|code| {
            let mut model = Model::of_mesh("x", triangle());
            if code == "bzc" {
                let points = vec![Vec3::ZERO, Vec3::X, Vec3::ONE];
                let curve = Bezier::Curve(Curve { points });
                model.objects = vec![common::bezier("x", &curve)];
            }
            (by_code(code), formats::write(by_code(code), &model).expect("small"))
        })
        .to_vec()
}

fn with_first(files: &[NamedBytes], bytes: Vec<u8>) -> Import {
    let mut files = files.to_vec();
    files[0].bytes = bytes;
    read(&files).unwrap_or_else(|error| panic!("{error}"))
}

fn utf16(text: &str, mark: &str, big: bool) -> Vec<u8> {
    let unit = |unit: u16| if big { unit.to_be_bytes() } else { unit.to_le_bytes() };
    mark.encode_utf16().chain(text.encode_utf16()).flat_map(unit).collect()
}

#[test]
fn every_text_format_is_read_in_every_encoding() {
    for (format, files) in written() {
        let text = common::text(&files[0]).to_owned();
        let expected = read(&files).expect("its own");
        for mark in ["", "\u{feff}"] {
            for bytes in
                [[mark, &text].concat().into_bytes(), utf16(&text, mark, false), utf16(&text, mark, true)]
            {
                let import = with_first(&files, bytes);
                assert!(import.model.objects == expected.model.objects, "{format:?}");
                assert_eq!(import.report, expected.report, "{format:?}");
            }
        }
    }
}

#[test]
fn text_in_no_other_encoding_is_latin_1_and_said_to_be() {
    for code in ["obj", "stl-text", "dae"] {
        let files = formats::write(by_code(code), &Model::of_mesh("x", triangle())).expect("small");
        let expected = read(&files).expect("its own");
        let text = common::text(&files[0]);
        let latin1: Vec<u8> = text.chars().map(|c| u8::try_from(c).expect("in Latin-1")).collect();
        assert_ne!(latin1, text.as_bytes(), "{code}");
        let import = with_first(&files, latin1);
        assert!(import.model.objects == expected.model.objects, "{code}");
        assert!(import.report.to_string().contains("Latin-1"), "{code} {}", import.report);
    }
}

#[test]
fn material_libraries_are_read_in_every_encoding() {
    let library = format!("newmtl {NAME}\nKd 1 0 0\nmap_Kd Bär.png\n");
    let obj = NamedBytes::new(
        "a.obj",
        format!("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl {NAME}\nf 1 2 3\n"),
    );
    let latin1: Vec<u8> = library.chars().map(|c| u8::try_from(c).expect("in Latin-1")).collect();
    for bytes in
        [library.clone().into_bytes(), utf16(&library, "", false), utf16(&library, "\u{feff}", true), latin1]
    {
        let mtl = NamedBytes::new("a.mtl", bytes);
        assert_eq!(formats::companions(&mtl), ["Bär.png"]);
        let import = read(&[obj.clone(), mtl]).expect("readable");
        assert_eq!(import.model.materials.list[0].name, NAME);
        assert_eq!(mesh(&import).get(keys::FACE_COLOR, 0).0, [255, 0, 0]);
    }
    // The names of companions are found in every encoding, too.
    let utf16 = NamedBytes::new("a.obj", utf16("mtllib Bär.mtl\nv 0 0 0\n", "\u{feff}", false));
    assert_eq!(formats::companions(&utf16), ["Bär.mtl"]);
}

#[test]
fn content_in_utf_16_tells_its_format() {
    let file = case_file("obj-utf16.obj");
    for name in ["obj-utf16.obj", "pasted", "a.stl"] {
        let import = read(&[NamedBytes { name: name.to_owned(), ..file.clone() }]).expect("readable");
        assert_eq!((mesh(&import).vertex_count(), mesh(&import).face_count()), (3, 1));
        assert!(import.report.is_clean(), "{}", import.report);
    }
}

#[test]
fn binary_files_are_not_taken_for_text() {
    // Every byte of the numbers could be a character of Latin-1 or UTF-16.
    let number = f32::from_le_bytes([0x41, 0xe4, 0x41, 0x42]);
    let mesh = Mesh::build(PolygonSoup::new(vec![Vec3::splat(number)], &[[0u32; 0]; 0])).expect("small").mesh;
    let ply = formats::write(by_code("ply"), &Model::of_mesh("x", mesh.clone())).expect("small");
    assert!(std::str::from_utf8(&ply[0].bytes).is_err());
    assert!(*common::mesh(&read(&ply).expect("its own")) == mesh);
    let mut stl = formats::write(by_code("stl"), &Model::of_mesh("x", triangle())).expect("small");
    for (place, unit) in stl[0]
        .bytes
        .as_chunks_mut::<2>()
        .0
        .iter_mut()
        .zip("made by x, with a header in UTF-16 ".encode_utf16())
    {
        *place = unit.to_le_bytes();
    }
    assert_eq!(common::mesh(&read(&stl).expect("its own")).face_count(), 1);
}
