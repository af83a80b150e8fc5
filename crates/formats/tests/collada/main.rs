//! COLLADA: files of others, every kind of primitive, encodings, and documents that are written and read
//! back. The modules hold cases from other programs' bug reports, controllers, and faulty input.

#[path = "../common/mod.rs"]
mod common;

mod cases;
mod content;
mod controllers;
mod faults;
mod materials;

use common::{by_code, load, mesh, model, read, renamed};
use formats::{Import, NamedBytes};
use glam::{Vec2, Vec3};
use halfedge::attribute::{Column, keys};
use halfedge::{Color, Element, Mesh, PolygonSoup, VertexId};
use proptest::prelude::*;

fixtures::shared_tests!(
    the_courses_files_have_their_counts,
    the_courses_cube_is_scaled_turned_and_coloured,
    shared_models_round_trip
);

fn read_dae(text: impl Into<Vec<u8>>) -> Result<Import, String> {
    read(&[NamedBytes::new("a.dae", text)]).map_err(|error| error.to_string())
}

/// A document with one geometry of six vertices, the corners of two unit squares side by side, with these
/// primitives and this scene.
fn document(asset: &str, primitives: &str, scene: &str) -> String {
    format!(
        "<?xml version=\"1.0\"?><COLLADA xmlns=\"x\" version=\"1.4.1\"><asset>{asset}</asset><library_geometries>\
         <geometry id=\"g\" name=\"shape\"><mesh><source id=\"s\"><float_array id=\"sa\" count=\"18\">0 0 0 1 0 0 1 1 0 0 1 0 2 0 0 2 1 0</float_array>\
         <technique_common><accessor source=\"#sa\" count=\"6\" stride=\"3\"/></technique_common></source>\
         <vertices id=\"v\"><input semantic=\"POSITION\" source=\"#s\"/></vertices>{primitives}</mesh></geometry>\
         </library_geometries>{scene}</COLLADA>"
    )
}

const INPUT: &str = "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>";

#[test]
fn nodes_that_mirror_turn_faces_round() {
    let files = common::write(by_code("dae"), &common::tetrahedron());
    let text = common::text(&files[0]);
    let place = text.find("<instance_geometry").expect("an instance");
    for (transform, outer, sign) in [
        ("<scale>-1 1 1</scale>", "", Vec3::new(-1.0, 1.0, 1.0)),
        ("<scale>-1 -1 1</scale>", "", Vec3::new(-1.0, -1.0, 1.0)),
        ("<matrix>1 0 0 0 0 1 0 0 0 0 -1 0 0 0 0 1</matrix>", "", Vec3::new(1.0, 1.0, -1.0)),
        ("", "<scale>1 -1 1</scale>", Vec3::new(1.0, -1.0, 1.0)),
        ("<scale>-1 1 1</scale>", "<scale>1 -1 1</scale>", Vec3::new(-1.0, -1.0, 1.0)),
    ] {
        let (before, after) = text.split_at(place);
        let (head, end) = after.split_at(after.find("</node>").expect("its end"));
        let nested = format!("{before}{outer}<node>{transform}{head}</node>{end}");
        common::check_tetrahedron(mesh(&read_dae(nested).expect("readable")), |p| p * sign);
    }
    // Polygons start at the corner they started at, and holes are cut from the right side.
    let square = |scale: &str| {
        let polygons = format!(
            "<polygons count=\"1\">{INPUT}<p>3 0 1 2</p></polygons><polygons count=\"1\">{INPUT}<ph><p>0 4 5</p><h>1 2 3</h></ph></polygons>"
        );
        let scene = format!(
            "<library_visual_scenes><visual_scene><node><scale>{scale}</scale><instance_geometry url=\"#g\"/></node></visual_scene></library_visual_scenes>"
        );
        read_dae(document("", &polygons, &scene)).expect("readable").model.objects.remove(0).mesh
    };
    let corners = |mesh: &Mesh| -> Vec<Vec<u32>> {
        mesh.faces().map(|f| mesh.face_vertices(f).map(|v| v.raw()).collect()).collect()
    };
    let (plain, mirrored) = (corners(&square("1 1 1")), corners(&square("1 1 -1")));
    assert_eq!(plain[0], [3, 0, 1, 2]);
    assert_eq!(mirrored[0], [3, 2, 1, 0]);
    assert_eq!(plain.len(), mirrored.len());
}

fn the_courses_files_have_their_counts() {
    let counts = |folder: &str, counts: &[(&str, usize, usize)]| {
        for path in fixtures::shared_files(folder, "dae") {
            let file = load(&path);
            let Some(&(_, vertices, faces)) = counts.iter().find(|(name, ..)| *name == file.stem()) else {
                panic!("{} is not in the table", file.name);
            };
            let import = read(std::slice::from_ref(&file)).expect("readable");
            let mesh = mesh(&import);
            assert_eq!((mesh.vertex_count(), mesh.face_count()), (vertices, faces), "{folder}/{}", file.name);
            assert!(import.report.is_clean(), "{}", import.report);
            let back = read(&formats::write(by_code("dae"), &renamed(&import, "x")).expect("small"))
                .expect("readable");
            assert!(common::mesh(&back) == mesh, "{folder}/{}", file.name);
        }
    };
    counts(
        "models/cmu462",
        &[("bean", 812, 1620), ("cube", 8, 12), ("quadball", 386, 768), ("teapot", 1232, 2464)],
    );
    for (folder, [input, flip, split, collapse]) in [
        ("cube", [(8, 12), (8, 12), (9, 14), (7, 10)]),
        ("icosahedron", [(12, 20), (12, 20), (13, 22), (11, 18)]),
        ("torus", [(18, 36), (18, 36), (19, 38), (17, 34)]),
    ] {
        let row = |name, (vertices, faces)| (name, vertices, faces);
        counts(
            &format!("models/cmu462/{folder}"),
            &[
                row("input", input),
                row("edgeFlip", flip),
                row("edgeSplit", split),
                row("edgeCollapse", collapse),
            ],
        );
    }
}

fn the_courses_cube_is_scaled_turned_and_coloured() {
    let import = read(&[load(&fixtures::shared("models/cmu462/cube.dae"))]).expect("readable");
    assert!(import.report.to_string().contains("Y is up instead of Z"), "{}", import.report);
    // (1, 1, -1), scaled by (1.999999, 2, 2), turned.
    assert_eq!(mesh(&import).position(VertexId::new(0)), Vec3::new(1.999_999, -2.0, -2.0));
    assert_eq!(mesh(&import).get(keys::FACE_COLOR, 0), Color([163, 163, 163]));
}

#[test]
fn transforms_apply_in_metres_with_y_up() {
    let scene = "<library_nodes><node id=\"n\" name=\"lib\"><scale>2 2 2</scale><instance_geometry url=\"#g\"/></node></library_nodes>\
        <library_visual_scenes><visual_scene id=\"vs\"><node name=\"outer\"><translate>0 0 3</translate><rotate>0 0 1 90</rotate>\
        <instance_geometry url=\"#g\"/><instance_node url=\"#n\"/><node name=\"in\"><matrix>1 0 0 5 0 1 0 0 0 0 1 0 0 0 0 1</matrix><instance_geometry url=\"#g\"/></node></node></visual_scene></library_visual_scenes>\
        <scene><instance_visual_scene url=\"#vs\"/></scene>";
    let text = document(
        "<unit meter=\"0.5\"/><up_axis>X_UP</up_axis>",
        &format!("<triangles>{INPUT}<p>0 1 2</p></triangles>"),
        scene,
    );
    let import = read_dae(text).expect("readable");
    assert_eq!(
        import.model.objects.iter().map(|o| o.name.as_str()).collect::<Vec<_>>(),
        ["outer", "lib", "in"]
    );
    let at = |object: usize| import.model.objects[object].mesh.position(VertexId::new(1));
    // Vertex 1 is (1, 0, 0): turned to (0, 1, 0), moved to (0, 1, 3); X up gives (-1, 0, 3), halved.
    assert!(at(0).distance(Vec3::new(-0.5, 0.0, 1.5)) < 1e-6, "{}", at(0));
    assert!(at(1).distance(Vec3::new(-1.0, 0.0, 1.5)) < 1e-6, "{}", at(1));
    assert!(at(2).distance(Vec3::new(-3.0, 0.0, 1.5)) < 1e-6, "{}", at(2));
}

#[test]
fn every_primitive_is_read() {
    for (primitive, faces, expected) in [
        ("<polylist><I/><vcount>4 3</vcount><p>0 1 2 3 1 4 2</p></polylist>", 2, ""),
        (
            "<polygons><I/><p>0 1 2 3</p><ph><p>1 4 5 2</p><h>0 1 2</h></ph></polygons>",
            2,
            "the holes of 1 polygon were filled",
        ),
        ("<triangles><I/><p>0 1 2 0 2 3</p></triangles>", 2, ""),
        ("<tristrips><I/><p>0 1 3 2</p><p>1 4 2 5</p></tristrips>", 4, ""),
        ("<trifans><I/><p>0 1 2 3</p></trifans>", 2, ""),
        (
            "<triangles><I/></triangles><lines><I/><p>0 1</p></lines>",
            0,
            "1 set of lines; only faces are kept",
        ),
    ] {
        let import = read_dae(document("", &primitive.replace("<I/>", INPUT), "")).expect("readable");
        let mesh = mesh(&import);
        assert_eq!((mesh.vertex_count(), mesh.face_count()), (6, faces), "{primitive}");
        assert!(import.report.to_string().contains(expected), "{}", import.report);
        assert_eq!(import.report.is_clean(), expected.is_empty(), "{}", import.report);
        assert_eq!(import.model.objects[0].name, "shape");
    }
}

#[test]
fn polygons_with_holes_are_cut_round_them() {
    // Vertices 0 to 3 are the outline, a square; the others are the hole.
    let sources = |points: &str, count: usize| {
        format!(
            "<COLLADA><library_geometries><geometry id=\"g\"><mesh><source id=\"p\"><float_array id=\"a\" \
             count=\"{count}\">{points}</float_array><technique_common><accessor source=\"#a\" stride=\"3\"/>\
             </technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>\
             <polygons><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><ph><p>0 1 2 3</p><h>4 5 6 7</h></ph>\
             </polygons></mesh></geometry></library_geometries></COLLADA>"
        )
    };
    let text = sources("0 0 0 4 0 0 4 4 0 0 4 0 1 1 0 3 1 0 3 3 0 1 3 0", 24);
    let import = read_dae(text).expect("readable");
    let mesh = mesh(&import);
    assert!(import.report.is_clean(), "{}", import.report);
    assert!(
        import.report.to_string().contains("1 polygon with holes cut into triangles"),
        "{}",
        import.report
    );
    assert_eq!((mesh.vertex_count(), mesh.face_count(), mesh.boundary_loops().len()), (8, 8, 2));
    assert!(mesh.components().1 == 1 && mesh.euler_characteristic() == 0, "a ring");
}

#[test]
fn encodings_are_detected() {
    let text = document("", &format!("<triangles>{INPUT}<p>0 1 2</p></triangles>"), "")
        .replace("\"shape\"", "\"Körper &amp; &#x3b1;\"");
    let name = |bytes: Vec<u8>| {
        read(&[NamedBytes::new("a", bytes)]).expect("readable").model.objects[0].name.clone()
    };
    assert_eq!(name(text.clone().into_bytes()), "Körper & α");
    assert_eq!(name([b"\xef\xbb\xbf", text.as_bytes()].concat()), "Körper & α");
    assert_eq!(
        name(std::iter::once(0xfeff).chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect()),
        "Körper & α"
    );
    assert_eq!(name(text.encode_utf16().flat_map(u16::to_be_bytes).collect()), "Körper & α");
    let latin = |text: &str| -> Vec<u8> {
        text.chars().map(|c| if (c as u32) < 256 { c as u8 } else { b'?' }).collect()
    };
    assert_eq!(name(latin(&text)), "Körper & α");
    // Declared, there is nothing to note; otherwise letters may be wrong.
    for (declared, noted) in
        [("", true), (" encoding=\"ISO-8859-1\"", false), (" encoding='Shift_JIS'", true)]
    {
        let text = text.replace("version=\"1.0\"", &format!("version=\"1.0\"{declared}"));
        let import = read_dae(latin(&text)).expect("readable");
        assert_eq!(
            import.report.to_string().contains("letters of names may be wrong"),
            noted,
            "{}",
            import.report
        );
    }
}

/// Quads and triangles with uvs and normals on some faces, colours, materials and an isolated vertex.
fn sample() -> Mesh {
    let positions =
        (0..8).map(|i| Vec3::new((i % 3) as f32 / 3.0, (i / 3) as f32, -0.1 * i as f32)).collect();
    let faces: [&[u32]; 4] = [&[0, 1, 4, 3], &[1, 2, 5], &[1, 5, 4], &[3, 4, 6]];
    let mut soup = PolygonSoup::new(positions, &faces);
    // Of the second face one corner has no texture coordinates.
    let uv = |i: usize| if i < 6 { Vec2::new(i as f32 / 7.0, 0.5) } else { Vec2::NAN };
    soup.corner_columns.push(Column::with_values(keys::CORNER_UV, (0..13).map(uv).collect()));
    let normal = |i: usize| if i >= 4 { Vec3::Z } else { Vec3::NAN };
    soup.corner_columns.push(Column::with_values(keys::CORNER_NORMAL, (0..13).map(normal).collect()));
    let material = Column::with_values(keys::FACE_MATERIAL, vec![0, 1, halfedge::NONE, 0]);
    soup.face_columns
        .push(Column { labels: vec!["red & <\"wood\">".to_owned(), "b".to_owned()], ..material });
    let colors = [Color([1, 2, 3]), Color([77, 0, 255]), Color([9, 9, 9]), Color([4, 5, 6])];
    soup.face_columns.push(Column::with_values(keys::FACE_COLOR, colors.to_vec()));
    Mesh::build(soup).expect("small").mesh
}

#[test]
fn attributes_and_objects_round_trip() {
    let sample = sample();
    let mut plain = Mesh::build(sample.to_soup()).expect("small").mesh;
    plain.insert_column(Element::Face, Column::with_values(keys::FACE_COLOR, vec![Color::UNPAINTED; 4]));
    let empty = Mesh::new();
    let given = [("one & only", &sample), ("two", &plain), ("empty", &empty)];
    let import =
        read(&formats::write(by_code("dae"), &model("x", &given)).expect("small")).expect("readable");
    assert!(import.report.is_clean(), "{}", import.report);
    assert_eq!(import.model.objects.len(), 3);
    for (back, (name, mesh)) in import.model.objects.iter().zip(given) {
        assert_eq!(back.name, name);
        back.mesh.validate().expect("valid");
        assert!(*back.mesh == *mesh, "{name}");
    }
}

fn shared_models_round_trip() {
    for path in fixtures::shared_files("models/common", "obj") {
        let original = read(&[load(&path)]).expect("readable");
        let original = original.model.objects[0].mesh.as_ref();
        let files = formats::write(by_code("dae"), &model("x", &[("m", original)])).expect("small");
        let import = read(&files).expect("readable");
        let back = mesh(&import);
        assert!(import.report.is_clean(), "{}", import.report);
        // Identical, where the format has a place for all there is.
        if formats::losses(by_code("dae"), &model("", &[("m", original)])).is_empty() {
            assert!(back == original, "{}", path.display());
        }
        assert!(back.positions() == original.positions());
        let corners = |mesh: &Mesh| mesh.to_soup().corners;
        assert!(corners(back) == corners(original), "{}", path.display());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn damaged_documents_never_panic(
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>(), any::<u8>(), 0u8..5), 1..6),
        wide in any::<bool>(),
    ) {
        let sample = sample();
        let files = formats::write(by_code("dae"), &model("x", &[("a", &sample)])).expect("small");
        let mut bytes = files[0].bytes.clone();
        for (at, other, value, kind) in edits {
            if bytes.is_empty() {
                break;
            }
            let (at, other) = (at.index(bytes.len()), other.index(bytes.len()));
            match kind {
                0 => bytes[at] = value,
                1 => bytes.truncate(at),
                2 => { bytes.remove(at); }
                3 => bytes.insert(at, b"0123456789 -.<>/\"#e"[usize::from(value) % 19]),
                _ => {
                    let part = bytes[at.min(other)..at.max(other).min(at.min(other) + 200)].to_vec();
                    bytes.splice(at..at, part);
                }
            }
        }
        if wide {
            bytes = String::from_utf8_lossy(&bytes).encode_utf16().flat_map(u16::to_le_bytes).collect();
        }
        if let Ok(import) = read(&[NamedBytes::new("a.dae", bytes)]) {
            for object in &import.model.objects {
                object.mesh.validate().expect("valid");
            }
        }
    }
}
