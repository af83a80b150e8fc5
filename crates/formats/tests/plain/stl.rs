//! STL.

use super::back;
use super::common::{by_code, case_file, mesh, model, read, write};
use formats::{Import, NamedBytes};
use glam::Vec3;
use halfedge::{Color, Element, Mesh, PolygonSoup, keys};

#[test]
fn triangles_round_trip_through_stl_with_vertices_merged() {
    let cube = PolygonSoup::new(
        (0..8).map(|i| Vec3::new((i & 1) as f32, (i >> 1 & 1) as f32, (i >> 2) as f32 * 0.1)).collect(),
        &[[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]],
    );
    let cube = Mesh::build(cube).expect("small").mesh;
    for format in [by_code("stl"), by_code("stl-text")] {
        let back = back(format, &cube);
        assert_eq!((back.vertex_count(), back.face_count()), (8, 12));
        assert!(back.boundary_loops().is_empty());
        let again = self::back(format, &back);
        assert!(again == back, "{format:?}: triangles keep their order and so do vertices");
    }
    assert_eq!(formats::losses(by_code("stl"), &model("a", &[("a", &cube)])).len(), 1);
}

#[test]
fn an_stl_that_does_not_say_how_many_triangles_it_has_is_read_whole() {
    let positions = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z].to_vec();
    let faces = [[0u32, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    let mesh = Mesh::build(PolygonSoup::new(positions, &faces)).expect("small").mesh;
    let mut files = formats::write(by_code("stl"), &model("a", &[("a", &mesh)])).expect("small");
    let whole = read(&files).expect("readable").model.objects.remove(0).mesh;
    for count in [0, u32::MAX] {
        files[0].bytes[80..84].copy_from_slice(&count.to_le_bytes());
        let import = read(&files).expect("readable");
        assert!(import.model.objects[0].mesh == whole, "{count}");
        assert!(import.report.to_string().contains("does not say how many triangles"), "{}", import.report);
    }
}

#[test]
fn stl_says_that_vertices_at_one_place_become_one() {
    let positions = [Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::X, Vec3::ONE, Vec3::Y].to_vec();
    let seam = Mesh::build(PolygonSoup::new(positions, &[[0u32, 1, 2], [3, 4, 5]])).expect("small").mesh;
    for format in [by_code("stl"), by_code("stl-text")] {
        let losses = formats::losses(format, &model("", &[("a", &seam)])).join("\n");
        assert!(losses.contains("2 vertices at the same place as another will be one with it"), "{losses}");
        assert_eq!(back(format, &seam).vertex_count(), 4);
        // Of two objects all.
        let both = formats::losses(format, &model("", &[("a", &seam), ("b", &seam)])).join("\n");
        assert!(both.contains("8 vertices at the same place"), "{both}");
    }
}

#[test]
fn text_stl_in_capitals_is_read() {
    let text = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1e0 0\nendloop\nendfacet\nendsolid a\n";
    for text in [text.to_owned(), text.to_uppercase(), text.replace("endfacet", "EndFacet")] {
        for name in ["pasted", "a.stl"] {
            let import = read(&[NamedBytes::new(name, text.as_str())]).expect("readable");
            assert!(import.report.is_clean(), "{}", import.report);
            assert_eq!((mesh(&import).vertex_count(), mesh(&import).face_count()), (3, 1), "{text}");
        }
    }
}

fn read_stl(bytes: impl Into<Vec<u8>>) -> Result<Import, String> {
    read(&[NamedBytes::new("a.stl", bytes)]).map_err(|error| error.to_string())
}

fn case(name: &str) -> Import {
    read(&[case_file(name)]).unwrap_or_else(|error| panic!("{error}"))
}

/// The name of each face's group.
fn groups(mesh: &Mesh) -> Vec<&str> {
    let labels = mesh.column(Element::Face, "group").map_or(&[][..], |column| &column.labels);
    let group = |f: halfedge::FaceId| mesh.get(keys::FACE_GROUP, f.index());
    mesh.faces().map(|f| labels.get(group(f) as usize).map_or("", String::as_str)).collect()
}

#[test]
fn words_are_read_as_programs_spell_them() {
    let import = case("stl-end-loop-two-words.stl");
    let mesh_of = |import: &Import| mesh(import).clone();
    assert_eq!((mesh(&import).vertex_count(), mesh(&import).face_count()), (4, 4));
    assert!(mesh(&import).boundary_loops().is_empty() && import.report.is_clean(), "{}", import.report);
    let text = String::from_utf8(case_file("stl-end-loop-two-words.stl").bytes).expect("text");
    for other in [
        text.replace("end ", "end_"),
        text.replace("end loop\n", "").replace("outer loop\n", ""),
        text.replace("end facet\n", ""),
        text.replace("end loop\nend facet\n", ""),
        text.replace("end solid", ""),
        text.replace('\n', " "),
        text.replace('\n', "\r"),
        text.replace("solid MOULD", "solid MOULD of a facet normal to 3 things"),
    ] {
        let is_whole = ["end solid", "end_solid"].iter().any(|end| other.contains(end));
        let other = read_stl(other.as_str()).unwrap_or_else(|error| panic!("{error}\n{other}"));
        assert_eq!(other.report.is_clean(), is_whole, "{}", other.report);
        assert!(mesh_of(&other).to_soup().corners == mesh_of(&import).to_soup().corners, "{}", other.report);
    }
    // Polygons are read, although the format has none.
    let quad = "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n";
    assert_eq!(mesh(&read_stl(quad).expect("readable")).face_degree(halfedge::FaceId::new(0)), 4);
}

#[test]
fn solids_become_groups_and_back() {
    let import = case("stl-two-named-solids.stl");
    let name = "Inlet - 300K_can-1 vertex 3";
    assert_eq!(groups(mesh(&import)), [&[""; 4][..], &[name; 4]].concat());
    assert_eq!(mesh(&import).components().1, 2);
    let files = formats::write(by_code("stl-text"), &import.model).expect("small");
    let back = read(&files).expect("its own");
    assert!(mesh(&back) == mesh(&import));
    assert_eq!(formats::losses(by_code("stl-text"), &import.model), [""; 0]);
    let lost = formats::losses(by_code("stl"), &import.model);
    assert_eq!(lost, ["STL holds no face groups: those of 4 faces are lost"]);
    let obj = formats::write(by_code("obj"), &import.model).expect("small");
    assert!(String::from_utf8_lossy(&obj[0].bytes).contains(&format!("g {name}\n")));
    // The only solid is named by the file, or is a group.
    let one = |name: &str| {
        format!("solid {name}\nfacet\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendfacet\nendsolid\n")
    };
    let group = |text: String| groups(mesh(&read_stl(text).expect("readable")))[0].to_owned();
    assert_eq!([group(one("a")), group(one("")), group(one("part 7"))], ["", "", "part 7"]);
    let report = read_stl(one("") + &one("")).expect("readable").report.to_string();
    assert!(report.contains("2 solids have no name and are not told apart"), "{report}");
}

#[test]
fn several_objects_are_several_solids() {
    let triangle = |x: f32| {
        let corners = [Vec3::ZERO, Vec3::X, Vec3::Y].map(|corner| corner + Vec3::Z * x);
        Mesh::build(PolygonSoup::new(corners.to_vec(), &[[0u32, 1, 2]])).expect("small").mesh
    };
    let both = model("both", &[("left", &triangle(0.0)), ("a\nb", &triangle(1.0))]);
    let back = read(&formats::write(by_code("stl-text"), &both).expect("small")).expect("its own");
    assert_eq!(groups(mesh(&back)), ["left", "a b"]);
    assert_eq!(formats::losses(by_code("stl-text"), &both), [""; 0]);
    assert_eq!(formats::losses(by_code("stl"), &both), ["STL holds one mesh: 2 objects become one"]);
}

#[test]
fn colours_of_both_conventions_are_read() {
    let (red, green, blue) = (Color([255, 0, 0]), Color([0, 255, 0]), Color([0, 0, 255]));
    for (name, last, header) in [
        (
            "stl-colours-magics.stl",
            Color([10, 20, 200]),
            "The material in its header (MATERIAL=) is left out",
        ),
        ("stl-colours-viscam.stl", Color::UNPAINTED, "The text in its header is left out: viscam export"),
    ] {
        let import = case(name);
        let colors = mesh(&import).attribute(keys::FACE_COLOR).expect("colours");
        assert_eq!(colors, [red, green, blue, last], "{name}");
        assert!(import.report.is_clean() && import.report.to_string().contains(header), "{}", import.report);
        let obj = formats::write(by_code("obj"), &import.model).expect("small");
        assert!(String::from_utf8_lossy(&obj[1].bytes).contains("Kd 1 0 0\n"), "{name}");
    }
}

#[test]
fn colours_are_written_in_five_bits() {
    let mut mesh = super::common::tetrahedron();
    for h in mesh.halfedges().collect::<Vec<_>>() {
        mesh.set(keys::CORNER_UV, h.index(), glam::Vec2::NAN);
        mesh.set(keys::CORNER_NORMAL, h.index(), Vec3::NAN);
    }
    mesh.set(keys::FACE_COLOR, 1, Color([255, 0, 132]));
    mesh.set(keys::FACE_COLOR, 2, Color([8, 16, 25]));
    let import = read(&write(by_code("stl"), &mesh)).expect("its own");
    let colors = super::common::mesh(&import).attribute(keys::FACE_COLOR).expect("colours");
    assert_eq!(colors, mesh.attribute(keys::FACE_COLOR).expect("colours"));
    let losses = |mesh: &Mesh| formats::losses(by_code("stl"), &model("a", &[("a", mesh)]));
    assert_eq!(losses(&mesh), [""; 0]);
    mesh.set(keys::FACE_COLOR, 3, Color([1, 2, 3]));
    assert_eq!(losses(&mesh), ["STL holds 5 bits for a channel of a colour: those of 1 face are rounded"]);
    let text = formats::losses(by_code("stl-text"), &model("a", &[("a", &mesh)]));
    assert_eq!(text, ["STL (text) holds no face colours: those of 3 faces are lost"]);
}

#[test]
fn colours_in_text_are_read() {
    let facet = |x: u8| format!("facet\nvertex {x} 0 0\nvertex 1 9 0\nvertex 0 1 7\nendfacet\n");
    let text = format!(
        "solid a\ncolor 1 0 0.5\n{}color 0 255 0\n{}endsolid\nsolid a\n{}",
        facet(2),
        facet(3),
        facet(4)
    );
    let import = read_stl(text).expect("readable");
    let colors = mesh(&import).attribute(keys::FACE_COLOR).expect("colours");
    assert_eq!(colors, [Color([255, 0, 128]), Color([0, 255, 0]), Color::UNPAINTED]);
}

#[test]
fn bytes_that_are_no_colours_are_named() {
    let mut bytes = write(by_code("stl"), &super::common::tetrahedron()).remove(0).bytes;
    bytes[84 + 48] = 7;
    let report = read_stl(bytes).expect("readable").report.to_string();
    assert!(report.contains("The attribute bytes of 1 triangle are left out"), "{report}");
}

#[test]
fn numbers_are_read_or_the_cause_is_named() {
    let text =
        |vertex: &str| format!("solid a, b\nfacet normal 0 0 1\n{}endfacet\nendsolid\n", vertex.repeat(3));
    let commas = "solid a, b\nfacet normal 0,0 0,0 1,0\nvertex 0,0 0,0 0,0\nvertex 1,5 0,0 0,0\nvertex 0,0 1,5 0,0\nendfacet\n";
    let import = read_stl(commas).expect("readable");
    assert_eq!(mesh(&import).positions()[1], Vec3::X * 1.5);
    assert!(import.report.to_string().contains("read as decimal commas"), "{}", import.report);
    assert_eq!(groups(mesh(&import)), ["a, b"]);
    let error = read_stl(text("vertex 1,000 1,000 1,000\n")).expect_err("thousands?");
    assert!(error.contains("decimal commas or separators"), "{error}");
    for vertex in ["vertex a b c\n", "vertx 0 0 0\n", ""] {
        let error = read_stl(text(vertex)).expect_err("no triangle");
        assert!(error.contains("none of its triangles"), "{error}");
    }
}
