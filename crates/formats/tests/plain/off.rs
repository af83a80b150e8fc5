//! OFF.

use super::common::{case_file, mesh, read};
use formats::{Import, NamedBytes};
use glam::{Vec2, Vec3};
use halfedge::{Color, Mesh, keys};

#[test]
fn off_of_other_writers() {
    for text in [
        "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 3 1.0 0 0 0.5 # red too\n",
        "# first\nOFF4 2 5\n0 0 0 1 0 0\n\n1 1 0\n0 1 0\n3 0 1 2 255 0 0 255\n3 0 2 3 1. 0. 0.",
        "NOFF 4 2 5\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n3  0 1 2  255 0 0\r\n3 0 2 3 255 0 0\r\n",
        "COFF\n4 2 0\n0 0 0 255 255 255 255\n1 0 0 9 9 9 255\n1 1 0 0 0 0 0\n0 1 0 1 1 1 1\n3 0 1 2 255 0 0\n3 0 2 3 255 0 0\n",
    ] {
        let import = read(&[NamedBytes::new("a", text)]).expect("readable");
        assert!(import.report.is_clean(), "{}", import.report);
        let mesh = mesh(&import);
        assert_eq!((mesh.vertex_count(), mesh.face_count()), (4, 2), "{text}");
        assert_eq!(mesh.attribute(keys::FACE_COLOR), Some(&[Color([255, 0, 0]); 2][..]), "{text}");
    }
}

fn read_off(text: impl Into<Vec<u8>>) -> Result<Import, String> {
    read(&[NamedBytes::new("a.off", text)]).map_err(|error| error.to_string())
}

fn case(name: &str) -> Import {
    read(&[case_file(name)]).unwrap_or_else(|error| panic!("{error}"))
}

/// The normal and the texture coordinate of a corner of the first face.
fn at(mesh: &Mesh, corner: usize) -> (Vec3, Vec2) {
    let h = mesh.face_halfedges(halfedge::FaceId::new(0)).nth(corner).expect("a triangle").index();
    (mesh.get(keys::CORNER_NORMAL, h), mesh.get(keys::CORNER_UV, h))
}

fn vertex_colors(import: &Import) -> Vec<Vec3> {
    mesh(import).attribute(keys::VERTEX_COLOR).unwrap_or_default().to_vec()
}

const RGB: [Vec3; 3] = [Vec3::X, Vec3::Y, Vec3::Z];
const CORNERS: [Vec3; 3] = [Vec3::ZERO, Vec3::X, Vec3::Y];

#[test]
fn normals_and_texture_coordinates_of_vertices_are_read() {
    let off = "STNOFF 3 1 0\n0 0 0 0 0 1 .5 1\n1 0 0 0 0 0 0 .25\n0 1 0 0 1 0 1 0\n3 0 1 2\n";
    assert_eq!(at(mesh(&read_off(off).expect("readable")), 2), (Vec3::Y, Vec2::X));
    // Colours with and without opacity.
    let off = "STCOFF 3 1 0\n0 0 0 1 0 0 .5 1\n1 0 0 1 0 0 1 0 .25\n0 1 0 1 0 0 1 1 0\n3 0 1 2\n";
    let import = read_off(off).expect("readable");
    assert_eq!(
        [0, 1, 2].map(|c| at(mesh(&import), c).1),
        [Vec2::new(0.5, 1.0), Vec2::new(0.0, 0.25), Vec2::X]
    );
    assert_eq!(vertex_colors(&import), [Vec3::X; 3]);
}

#[test]
fn meshlab_and_geomview_order_colours_and_normals_differently() {
    let import = case("off-ncoff.off");
    assert!(import.report.is_clean(), "{}", import.report);
    assert_eq!(mesh(&import).positions(), CORNERS);
    assert_eq!(vertex_colors(&import), RGB);
    assert_eq!(at(mesh(&import), 1).0, Vec3::Z);
    let (normals, colors, uvs) = ("0 0 1", ["1 0 0 1", "0 1 0 1", "0 0 1 1"], ".5 .25");
    let positions = ["0 0 0", "1 0 0", "0 1 0"];
    for (word, color_first, has_uvs) in [
        ("CNOFF", false, false),
        ("NCOFF", true, false),
        ("STCNOFF", false, true),
        ("NCSTOFF", true, true),
        ("CNSTOFF", false, true),
        // The numbers tell more than the word: colours that are no normals.
        ("CNOFF", true, false),
        ("NCOFF", false, false),
    ] {
        let is_telling = (word.find('N') < word.find('C')) != color_first;
        let line = |i: usize| {
            let color = if is_telling { "0.5 0.5 0.5 1" } else { colors[i] };
            let (a, b) = if color_first { (color, normals) } else { (normals, color) };
            format!("{} {a} {b} {}\n", positions[i], if has_uvs { uvs } else { "" })
        };
        let text = format!("{word}\n3 1 0\n{}{}{}3 0 1 2\n", line(0), line(1), line(2));
        let import = read_off(text.as_str()).expect("readable");
        assert!(import.report.is_clean(), "{text}{}", import.report);
        let expected = if is_telling { [Vec3::splat(0.5); 3] } else { RGB };
        assert_eq!(vertex_colors(&import), expected, "{text}");
        let (normal, uv) = at(mesh(&import), 0);
        assert_eq!(normal, Vec3::Z, "{text}");
        assert_eq!(uv == Vec2::new(0.5, 0.25), has_uvs, "{text}");
    }
}

#[test]
fn numbers_that_the_header_does_not_tell_of_are_colours() {
    let import = case("off-plain-with-colours.off");
    assert_eq!((mesh(&import).positions(), vertex_colors(&import)), (&CORNERS[..], RGB.to_vec()));
    let import = read_off("OFF\n3 1 0\n0 0 0 9 8\n1 0 0\n0 1 0\n3 0 1 2\n").expect("readable");
    assert_eq!((mesh(&import).positions(), vertex_colors(&import)), (&CORNERS[..], vec![]));
    assert!(
        import.report.to_string().contains("1 vertex with numbers that have no meaning"),
        "{}",
        import.report
    );
    // Several vertices on a line, and one on several lines, have no such numbers.
    for text in ["OFF 3 1 0\n0 0 0 1 0 0\n0 1 0\n3 0 1 2", "OFF\n3\n1\n0\n0\n0 0 1\n0 0\n0 1 0 3\n0 1 2"] {
        let import = read_off(text).expect("readable");
        assert_eq!((mesh(&import).positions(), mesh(&import).face_count()), (&CORNERS[..], 1), "{text}");
        assert!(import.report.is_clean(), "{text} {}", import.report);
    }
}

#[test]
fn lines_with_less_than_the_header_says_are_positions() {
    let import = case("off-cnoff-bare.off");
    assert_eq!((mesh(&import).positions(), mesh(&import).face_count()), (&CORNERS[..], 1));
    let report = import.report.to_string();
    assert!(report.contains("3 vertices without normal, colour or texture coordinates"), "{report}");
    // Each line stands for itself.
    let import = read_off("NOFF\n3 1 0\n0 0 0 0 0 1\n1 0 0\n0 1 0 0 1 0\n3 0 1 2\n").expect("readable");
    assert_eq!([0, 2].map(|corner| at(mesh(&import), corner).0), [Vec3::Z, Vec3::Y]);
    assert!(at(mesh(&import), 1).0.is_nan());
    assert!(import.report.to_string().contains("(number 1)"), "{}", import.report);
    // Normals on lines of their own are read.
    let import =
        read_off("NOFF\n3 1 0\n0 0 0\n0 0 1\n1 0 0\n0 0 1\n0 1 0\n0 0 1\n3 0 1 2\n").expect("readable");
    assert_eq!((mesh(&import).positions(), at(mesh(&import), 2).0), (&CORNERS[..], Vec3::Z));
}

#[test]
fn more_coordinates_are_divided_by_or_left_out() {
    let import = read_off("4OFF\n3 1 0\n0 0 0 1\n2 0 0 2\n0 .5 0 .5\n3 0 1 2\n").expect("readable");
    assert_eq!(mesh(&import).positions(), CORNERS);
    assert!(
        import.report.to_string().contains("2 vertices with a fourth coordinate (w)"),
        "{}",
        import.report
    );
    let import = read_off("nOFF 2\n3 1 0\n0 0\n1 0\n0 1\n3 0 1 2\n").expect("readable");
    assert_eq!(mesh(&import).positions(), CORNERS);
    let import = read_off("4nOFF 4\n3 1 0\n0 0 0 9 1\n2 0 0 9 2\n0 1 0 9 1\n3 0 1 2\n").expect("readable");
    assert_eq!(mesh(&import).positions(), CORNERS);
    assert!(import.report.to_string().contains("only three are kept"), "{}", import.report);
    assert!(read_off("nOFF 4000000000\n3 1 0\n0 0 0\n").expect_err("too many").contains("dimensions"));
}

#[test]
fn colours_are_read_as_the_whole_file_has_them() {
    let text = "COFF\n3 1\n0 0 0 1 0 0 255\n1 0 0 255 255 255 255\n0 1 0 0 1 1 127\n3 0 1 2 7\n";
    let import = read_off(text).expect("readable");
    assert_eq!(vertex_colors(&import), [Vec3::X / 255.0, Vec3::ONE, Vec3::new(0.0, 1.0, 1.0) / 255.0]);
    let report = import.report.to_string();
    assert!(report.contains("1 opacity left out"), "{report}");
    assert!(report.contains("1 colour left out: a place in a table of colours"), "{report}");
    let faces = "3 0 1 2 0.5 0 1\n3 0 3 1 1 0 0\n3 1 3 2 255 0 0 128\n3 2 3 0 1 2\n";
    let import = read_off(format!("OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n{faces}")).expect("readable");
    let colors = mesh(&import).attribute(keys::FACE_COLOR).expect("colours");
    let red = Color([255, 0, 0]);
    assert_eq!(colors, [Color([128, 0, 255]), red, red, Color::UNPAINTED], "1 is full beside fractions");
    assert!(
        import.report.to_string().contains("1 face with numbers that are no colour"),
        "{}",
        import.report
    );
}

/// A binary OFF of the triangle with these words before it, words for each vertex, and the end of its face.
fn binary(word: &str, extras: &[f32], face_end: &[u32], big: bool) -> Vec<u8> {
    let mut words: Vec<u32> = vec![3, 1, 0];
    for position in CORNERS {
        words.extend(position.to_array().iter().chain(extras).map(|c| c.to_bits()));
    }
    words.extend([3, 0, 1, 2]);
    words.extend(face_end);
    let bytes = |word: u32| if big { word.to_be_bytes() } else { word.to_le_bytes() };
    [format!("{word} BINARY\n").into_bytes(), words.into_iter().flat_map(bytes).collect()].concat()
}

#[test]
fn binary_files_of_both_byte_orders_are_read() {
    let import = case("off-binary.off");
    assert_eq!((mesh(&import).positions(), mesh(&import).face_count()), (&CORNERS[..], 1));
    let [half, one] = [0.5f32, 1.0].map(f32::to_bits);
    for big in [false, true] {
        for face_end in [&[][..], &[0], &[4, one, half, 0, one], &[3, one, half, 0]] {
            let import = read_off(binary("OFF", &[], face_end, big)).expect("readable");
            assert!(import.report.is_clean(), "{}", import.report);
            assert_eq!(
                (mesh(&import).positions(), mesh(&import).face_count()),
                (&CORNERS[..], 1),
                "{face_end:?}"
            );
            let color = (face_end.len() > 1).then_some([Color([255, 128, 0])]);
            assert_eq!(
                mesh(&import).attribute(keys::FACE_COLOR),
                color.as_ref().map(|c| &c[..]),
                "{face_end:?}"
            );
        }
        let import = read_off(binary("STCNOFF", &[0.0, 0.0, 1.0, 1.0, 0.5, 0.0, 1.0, 0.5, 0.25], &[0], big));
        let import = import.expect("readable");
        assert_eq!(at(mesh(&import), 1), (Vec3::Z, Vec2::new(0.5, 0.25)));
        assert_eq!(vertex_colors(&import), [Vec3::new(1.0, 0.5, 0.0); 3]);
        let whole = binary("OFF", &[], &[], big);
        let import = read_off(&whole[..whole.len() - 5]).expect("readable");
        assert!(
            import.report.to_string().contains("ends early: 3 of 3 vertices and 0 of 1 faces"),
            "{}",
            import.report
        );
    }
    assert!(read_off(*b"OFF BINARY\n\0\0\0\x09\0\0").expect_err("too short").contains("neither as Geomview"));
}

#[test]
fn numbers_are_read_or_the_cause_is_named() {
    let text = |vertices: &str| format!("OFF\n3 1 0\n{vertices}3 0 1 2\n");
    let import = read_off(text("0,0 0,0 0,0 # a, b\n1,0 0 0\n0 1,0 0\n")).expect("readable");
    assert_eq!(mesh(&import).positions(), CORNERS);
    assert!(import.report.to_string().contains("read as decimal commas"), "{}", import.report);
    let import = read_off(text("0, 0, 0\n1, 0, 0\n0, 1, 0\n")).expect("readable");
    assert_eq!(mesh(&import).positions(), CORNERS);
    let error =
        read_off(text("1,000 1,000 1,000\n2,000 1,000 1,000\n1,000 2,000 1,000\n")).expect_err("thousands?");
    assert!(error.contains("decimal commas or separators"), "{error}");
    let error = read_off(text("a b c\na b c\na b c\n")).expect_err("no number");
    assert!(error.contains("none of its vertices"), "{error}");
    // One bad line costs one vertex.
    let import = read_off(text("0 0 0\n1 0\n0 1 0\n")).expect("readable");
    assert_eq!(mesh(&import).positions(), [Vec3::ZERO, Vec3::ZERO, Vec3::Y]);
    assert!(import.report.to_string().contains("1 vertex put at the origin: not three numbers (number 1)"));
}
