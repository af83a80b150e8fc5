//! PLY.

use super::common::{by_code, case_file, mesh, read, text, write};
use formats::{Import, NamedBytes};
use glam::{Vec2, Vec3};
use halfedge::{Element, Mesh, PolygonSoup, VertexId, keys};

#[test]
fn ply_of_other_writers() {
    let head = "comment x\nelement vertex 4\nproperty double x\nproperty double y\nproperty double z\nproperty float nx\nproperty ushort red\nproperty ushort green\nproperty ushort blue\nelement face 1\nproperty uchar flags\nproperty list uchar ushort vertex_index\nelement edge 1\nproperty int v\nend_header\n";
    let rows = [[0.0f64, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let mut files = vec![
        format!(
            "ply\nformat ascii 1.0\n{head}{}7 4 0 1 2 3\n5\n",
            rows.map(|[x, y]| format!("{x} {y} 0.5 1 65535 0 0\n")).concat()
        )
        .into_bytes(),
    ];
    for big in [false, true] {
        let mut bytes = format!(
            "ply\r\nformat binary_{}_endian 1.0\r\n{}",
            if big { "big" } else { "little" },
            head.replace('\n', "\r\n")
        )
        .into_bytes();
        let mut put = |le: &[u8]| if big { bytes.extend(le.iter().rev()) } else { bytes.extend(le) };
        for [x, y] in rows {
            for c in [x, y, 0.5] {
                put(&c.to_le_bytes());
            }
            put(&1f32.to_le_bytes());
            for c in [65535u16, 0, 0] {
                put(&c.to_le_bytes());
            }
        }
        put(&[7]);
        put(&[4]);
        (0..4u16).for_each(|v| put(&v.to_le_bytes()));
        put(&5i32.to_le_bytes());
        files.push(bytes);
    }
    for bytes in files {
        let import = read(&[NamedBytes::new("a.ply", bytes)]).expect("readable");
        let mesh = mesh(&import);
        assert!(import.report.is_clean(), "{}", import.report);
        let report = import.report.to_string();
        assert!(
            report.contains("left out: all of \"edge\"") && report.contains("kept, in 32 bits: nx\n"),
            "{report}"
        );
        assert_eq!((mesh.vertex_count(), mesh.face_count()), (4, 1));
        assert_eq!(mesh.position(VertexId::new(2)), Vec3::new(1.0, 1.0, 0.5));
        assert_eq!(mesh.attribute(keys::VERTEX_COLOR).map(|c| c[3]), Some(Vec3::X));
    }
    let strips = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n9 0 1 2 3 -1 2 3 4 4\n";
    let import = read(&[NamedBytes::new("strips", strips)]).expect("readable");
    assert!(import.report.is_clean(), "{}", import.report);
    assert_eq!(mesh(&import).face_count(), 3);
}

#[test]
fn normals_and_texture_coordinates_of_other_writers() {
    let ply = |names: &str, list: &str, face: &str| {
        format!(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n{names}\
             element face 1\nproperty list uchar int vertex_indices\n{list}end_header\n0 0 0 0 0 1 .5 1\n\
             1 0 0 0 0 0 0 .25\n0 1 0 0 1 0 1 0\n3 0 1 2{face}\n"
        )
    };
    let normals = "property float nx\nproperty float ny\nproperty float nz\n";
    let at = |mesh: &Mesh, corner: usize| {
        let h = mesh.face_halfedges(halfedge::FaceId::new(0)).nth(corner).expect("a triangle").index();
        (mesh.get(keys::CORNER_NORMAL, h), mesh.get(keys::CORNER_UV, h))
    };
    for (uv, other) in [("s", "t"), ("u", "v"), ("texture_u", "texture_v"), ("s0", "t0")] {
        let names = format!("{normals}property float {uv}\nproperty float {other}\n");
        let import = read(&[NamedBytes::new("a.ply", ply(&names, "", ""))]).expect("readable");
        let mesh = mesh(&import);
        assert!(!import.report.to_string().contains("left out"), "{}", import.report);
        assert_eq!(at(mesh, 0), (Vec3::Z, Vec2::new(0.5, 1.0)), "{uv}");
        assert!(at(mesh, 1).0.is_nan(), "a normal of no length is none");
        assert_eq!(at(mesh, 2), (Vec3::Y, Vec2::X));
    }
    // What a face says counts for more; one of the wrong length says nothing, which is reported.
    let names = format!("{normals}property float s\nproperty float t\n");
    let list = "property list uchar float texcoord\n";
    let of = |face: &str| {
        let import = read(&[NamedBytes::new("a.ply", ply(&names, list, face))]).expect("readable");
        (
            at(mesh(&import), 1).1,
            import.report.to_string().contains("1 face without its own texture coordinates"),
        )
    };
    assert_eq!(of(" 6 9 9 8 8 7 7"), (Vec2::splat(8.0), false));
    assert_eq!(of(" 4 9 9 8 8"), (Vec2::new(0.0, 0.25), true));
}

fn read_ply(text: impl Into<Vec<u8>>) -> Result<Import, String> {
    read(&[NamedBytes::new("a.ply", text)]).map_err(|error| error.to_string())
}

/// A triangle with these lines in its header, properties of vertices and faces, and numbers for each.
fn triangle(head: &str, vertex: &str, vertex_values: [&str; 3], face: &str, face_values: &str) -> String {
    let [a, b, c] = vertex_values;
    format!(
        "ply\nformat ascii 1.0\n{head}element vertex 3\nproperty float x\nproperty float y\nproperty float z\n{vertex}\
         element face 1\nproperty list uchar int vertex_indices\n{face}end_header\n0 0 0{a}\n1 0 0{b}\n0 1 0{c}\n\
         3 0 1 2{face_values}\n"
    )
}

#[test]
fn counts_are_bytes_unless_a_face_is_too_large() {
    let polygon = |corners: u32| {
        let ring = (0..corners).map(|i| Vec3::new((i as f32 * 0.02).cos(), (i as f32 * 0.02).sin(), 0.0));
        Mesh::build(PolygonSoup::new(ring.collect(), &[(0..corners).collect::<Vec<_>>()]))
            .expect("small")
            .mesh
    };
    for (corners, count) in [(3, "uchar"), (255, "uchar"), (256, "int")] {
        for format in ["ply", "ply-text"].map(by_code) {
            let files = write(format, &polygon(corners));
            let head = String::from_utf8_lossy(&files[0].bytes).into_owned();
            assert!(head.contains(&format!("property list {count} int vertex_indices\n")), "{head}");
            assert!(*mesh(&read(&files).expect("its own")) == polygon(corners), "{format:?} {corners}");
        }
    }
}

#[test]
fn other_properties_are_kept_and_written_again() {
    let text = triangle(
        "",
        "property float quality\nproperty uchar alpha\nproperty int id\nproperty list uchar int ring\nproperty short depth\n",
        [" 0.5 255 70000 2 7 8 -3", " 1.5 0 1 0 4", " -2 7 2 1 1 5"],
        "property uint part\nproperty float color\n",
        " 300 1",
    );
    let import = read_ply(text).expect("readable");
    let report = import.report.to_string();
    assert!(import.report.is_clean(), "{report}");
    assert!(report.contains("left out: ring, color\n"), "{report}");
    assert!(report.contains("kept, in 32 bits: quality, alpha, id, depth\n"), "{report}");
    let original = mesh(&import);
    let names = |element| -> Vec<&str> {
        original.columns().of(element).iter().map(|column| column.name.as_str()).collect()
    };
    assert_eq!(
        (names(Element::Vertex), names(Element::Face)),
        (vec!["quality", "alpha", "id", "depth"], vec!["part"])
    );
    for format in ["ply", "ply-text"].map(by_code) {
        let files = formats::write(format, &import.model).expect("small");
        let head = String::from_utf8_lossy(&files[0].bytes).into_owned();
        for property in ["float quality", "uchar alpha", "uint id", "float depth", "ushort part"] {
            assert!(head.contains(&format!("property {property}\n")), "{head}");
        }
        let back = read(&files).expect("its own");
        assert!(back.model.objects[0].mesh == import.model.objects[0].mesh, "{format:?}");
        assert_eq!(formats::losses(format, &import.model), [""; 0]);
    }
    let others =
        |format: &formats::Format| format.can_write() && !format.is_bezier() && format.extension() != "ply";
    for format in formats::Format::all().filter(others) {
        let losses = formats::losses(format, &import.model).join("\n");
        assert!(
            losses.contains("no attributes of other programs: 5 attributes are lost"),
            "{format:?} {losses}"
        );
    }
}

#[test]
fn values_that_are_not_kept_as_they_are_are_named() {
    let vertex = "property double time\nproperty int a\nproperty int64 b\n";
    let binary = |rows: [(f64, i32, i64); 3]| {
        let head = format!(
            "ply\nformat binary_big_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\n{vertex}end_header\n"
        );
        let mut bytes = head.into_bytes();
        for (time, a, b) in rows {
            bytes.extend([[0, 0, 0, 0]; 2].concat());
            bytes.extend(time.to_be_bytes());
            bytes.extend(a.to_be_bytes());
            bytes.extend(b.to_be_bytes());
        }
        read_ply(bytes).expect("readable").report.to_string()
    };
    let report = binary([(0.5, -1, 9), (1.0, 2, 8), (2.0, 3, 7)]);
    assert!(!report.contains("rounded") && report.contains("Vertices have no z, which is 0"), "{report}");
    let report = binary([(0.1, -1, 9), (1.0, i32::MAX, 8), (2.0, 3, i64::MAX - 1)]);
    assert!(report.contains("rounded to what 32 bits hold: time, a, b"), "{report}");
    let text = triangle("", "property int a\n", [" 1", " x", " 3"], "", "");
    let report = read_ply(text).expect("readable").report.to_string();
    assert!(report.contains("no numbers were read as 0: a"), "{report}");
}

#[test]
fn colours_in_floats_out_of_255_are_scaled() {
    let vertex = "property float red\nproperty float green\nproperty float blue\n";
    let import = read_ply(triangle("", vertex, [" 255 0 51", " 0 0 0", " 1 0 0"], "", "")).expect("readable");
    assert_eq!(mesh(&import).get(keys::VERTEX_COLOR, 0), Vec3::new(1.0, 0.0, 0.2));
    let import = read_ply(triangle("", vertex, [" 1 0 0.2", " 0 0 0", " 0 0 0"], "", "")).expect("readable");
    assert_eq!(mesh(&import).get(keys::VERTEX_COLOR, 0), Vec3::new(1.0, 0.0, 0.2));
}

#[test]
fn images_come_and_go_with_their_files() {
    let ply = case_file("ply-texture-file.ply");
    assert_eq!(formats::companions(&ply), ["skin.png"]);
    let png = NamedBytes::new("skin.png", *b"\x89PNG...");
    let import = read(&[ply.clone(), png.clone()]).expect("readable");
    assert!(import.report.is_clean() && !import.report.to_string().contains("left out"), "{}", import.report);
    let materials = &import.model.materials;
    assert_eq!(materials.list.iter().map(|material| material.name.as_str()).collect::<Vec<_>>(), ["skin"]);
    for format in ["ply", "ply-text"].map(by_code) {
        let files = formats::write(format, &import.model).expect("small");
        assert!(String::from_utf8_lossy(&files[0].bytes).contains("comment TextureFile skin.png\n"));
        assert!(files[1] == png, "{format:?}");
        let back = read(&files).expect("its own");
        assert!(back.model.objects[0].mesh == import.model.objects[0].mesh, "{format:?}");
        assert!(back.model.materials == *materials);
        assert_eq!(
            formats::losses(format, &import.model),
            [format!("{} holds no material names: those of 2 faces are lost", format.name())]
        );
    }
    let files = formats::write(by_code("obj"), &import.model).expect("small");
    assert!(text(&files[1]).contains("newmtl skin\nmap_Kd skin.png\n"), "{}", text(&files[1]));
    assert!(files[2] == png);
    // Without the image, its name stays.
    let import = read(&[ply]).expect("readable");
    assert!(import.report.is_clean(), "{}", import.report);
    let files = formats::write(by_code("ply"), &import.model).expect("small");
    assert!(
        files.len() == 1
            && String::from_utf8_lossy(&files[0].bytes).contains("comment TextureFile skin.png\n")
    );
}

#[test]
fn each_face_shows_the_image_of_its_number() {
    let head = "comment TextureFile a/x.png\ncomment texturefile b/x.png\ncomment TextureFile c.png\n";
    let text = |numbers: [&str; 3]| {
        let [a, b, c] = numbers;
        format!(
            "ply\nformat ascii 1.0\n{head}element vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
             element face 3\nproperty list uchar int vertex_indices\nproperty int texnumber\nend_header\n\
             0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2 {a}\n3 0 3 1 {b}\n3 1 3 2 {c}\n"
        )
    };
    let import = read_ply(text(["1", "0", "-1"])).expect("readable");
    let report = import.report.to_string();
    assert!(report.contains("1 image that no face shows left out: c.png"), "{report}");
    let labels =
        |import: &Import| mesh(import).column(Element::Face, "material").expect("materials").labels.clone();
    assert_eq!(labels(&import), ["b/x.png", "a/x.png"]);
    let files = write_model(&import, "ply-text");
    let back = read(&files).expect("its own");
    assert_eq!(mesh(&back).attribute(keys::FACE_MATERIAL), mesh(&import).attribute(keys::FACE_MATERIAL));
    assert_eq!(labels(&back), labels(&import));
    // Without numbers all show the first; without images, the numbers are kept.
    let import = read_ply(triangle(head, "", [""; 3], "", "")).expect("readable");
    assert_eq!(labels(&import), ["a/x.png"]);
    let import = read_ply(triangle("", "", [""; 3], "property int texnumber\n", " 4")).expect("readable");
    assert_eq!(mesh(&import).columns().of(Element::Face)[0].name, "texnumber");
}

fn write_model(import: &Import, code: &str) -> Vec<NamedBytes> {
    formats::write(by_code(code), &import.model).expect("small")
}

#[test]
fn odd_headers_are_read() {
    let import = read(&[case_file("ply-stray-header-line.ply")]).expect("readable");
    assert_eq!((mesh(&import).vertex_count(), mesh(&import).face_count()), (3, 1));
    assert!(import.report.is_clean(), "{}", import.report);
    let stray = "1 line of the header has no meaning and was left out (line 3)";
    assert!(import.report.to_string().contains(stray), "{}", import.report);
    let head = "obj_info num_cols 512\nobj_info num_rows 400\ncomment TextureFile\nproperty float early\n";
    let text = triangle(head, "property half weight\nproperty int\n", [" 0.5 1"; 3], "", "");
    let import = read_ply(text.replace("format ascii 1.0\n", "")).expect("readable");
    let report = import.report.to_string();
    for expected in [
        "Remarks (obj_info) left out: num_cols 512, num_rows 400\n",
        "1 line of the header has no meaning and was left out (line 5)",
        "1 property of a type that is none of the format's, read as numbers (line 10)",
        "doesn't say the format of what follows",
        "kept, in 32 bits: weight\n",
        "left out: one without a name\n",
    ] {
        assert!(report.contains(expected), "{expected}\n{report}");
    }
    let binary = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty half x\nend_header\n\0\0";
    assert!(
        read_ply(binary)
            .expect_err("no size")
            .contains("1 property is of a type that is none of the format's")
    );
}

#[test]
fn numbers_are_read_or_the_cause_is_named() {
    let comma = |text: String| read_ply(text.replace("0 1 0\n", "0,5 1,25 0\n"));
    let import = comma(triangle("comment a, b\n", "", [""; 3], "", "")).expect("readable");
    assert_eq!(mesh(&import).position(VertexId::new(2)), Vec3::new(0.5, 1.25, 0.0));
    assert!(import.report.to_string().contains("read as decimal commas"), "{}", import.report);
    // Beside decimal points they are not.
    let import = comma(triangle("", "", [".", "", ""], "", "")).expect("readable");
    assert!(import.report.to_string().contains("1 vertex with a coordinate that is no number"));
    let ambiguous =
        triangle("", "", [""; 3], "", "").replace("0 0 0\n1 0 0\n0 1 0", "1,000 1 1\n2,000 1 1\n3,500 1 1");
    assert!(read_ply(ambiguous).expect_err("several readings").contains("decimal commas or separators"));
    for text in [
        triangle("", "", [""; 3], "", "").replace("0 0 0\n1 0 0\n0 1 0", "a b c\na b c\na b c"),
        triangle("", "", [""; 3], "", "")
            .replace("float x", "float a")
            .replace("float y", "float b")
            .replace("float z", "float c"),
    ] {
        let error = read_ply(text).expect_err("no position");
        assert!(error.contains("None of the PLY's vertices has a position"), "{error}");
    }
}

#[test]
fn what_a_face_or_a_colour_loses_is_named() {
    let vertex = "property float red\nproperty float green\nproperty float blue\n";
    let mut import =
        read_ply(triangle("", vertex, [" 0.3 0 0", " 1 1 1", " 0 0 0"], "", "")).expect("readable");
    let mesh = std::sync::Arc::make_mut(&mut import.model.objects[0].mesh);
    let corner = mesh.face_halfedges(halfedge::FaceId::new(0)).next().expect("a corner");
    mesh.set(keys::CORNER_UV, corner.index(), Vec2::ONE);
    assert_eq!(
        formats::losses(by_code("ply"), &import.model),
        [
            "PLY holds 8 bits for a channel of a colour: those of 1 vertex are rounded",
            "PLY holds texture coordinates of all corners of a face or none: those of 1 corner are lost",
        ]
    );
}
