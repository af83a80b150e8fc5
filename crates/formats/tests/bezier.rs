//! Bezier curves and surfaces: course files have the counts that they state, written files read back to the
//! bit, and errors name their line.

mod common;

use common::{bezier, by_code, load, read};
use formats::{Bezier, Format, Import, Model, NamedBytes, NamedMesh};
use glam::Vec3;
use halfedge::{Mesh, PolygonSoup};
use proptest::prelude::*;

fixtures::shared_tests!(course_files_read_and_round_trip);

fn controls(import: &Import) -> &Bezier {
    assert_eq!(import.model.objects.len(), 1);
    assert_eq!(*import.model.objects[0].mesh, Mesh::new());
    import.model.objects[0].bezier.as_deref().expect("control points")
}

fn read_text(name: &str, text: &str) -> Import {
    read(&[NamedBytes::new(name, text)]).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

fn error(name: &str, text: &str) -> String {
    read(&[NamedBytes::new(name, text)]).expect_err("not a Bezier file").to_string()
}

fn write(format: Format, controls: &Bezier) -> Vec<NamedBytes> {
    let objects = vec![bezier("x", controls)];
    let model = Model { name: "test".to_owned(), objects, ..Model::default() };
    formats::write(format, &model).expect("what the format holds")
}

fn curve(points: Vec<Vec3>) -> Bezier {
    Bezier::from_points(true, points)
}

/// A surface of `count` patches with points that are all different.
fn surface(count: usize) -> Bezier {
    let mut next = 0.0f32;
    let mut point = || {
        next += 0.1;
        Vec3::new(next, -next / 3.0, next * 1e-20)
    };
    Bezier::from_points(false, (0..count * 16).map(|_| point()).collect())
}

#[test]
fn a_curve_is_a_count_and_pairs_or_triples() {
    let plane = read_text("a.bzc", "3\n0 1  2 3\r\n\n4.5e0 -5");
    assert_eq!(
        controls(&plane),
        &curve(vec![Vec3::new(0.0, 1.0, 0.0), Vec3::new(2.0, 3.0, 0.0), Vec3::new(4.5, -5.0, 0.0)])
    );
    assert_eq!(plane.report.to_string(), "Read a Bezier curve of 3 control points as BZC\n");
    let space = read_text("a.bzc", "2 1 2 3 4 5 6");
    assert_eq!(controls(&space), &curve(vec![Vec3::new(1.0, 2.0, 3.0), Vec3::new(4.0, 5.0, 6.0)]));
    assert_eq!(controls(&read_text("a.bzc", "1 7 8")), &curve(vec![Vec3::new(7.0, 8.0, 0.0)]));
}

#[test]
fn content_tells_curves_and_surfaces_apart_whatever_the_name() {
    let curve = "4\n0 0 1 1 2 1 3 0";
    let surface = String::from_utf8(write(by_code("bez"), &surface(2))[0].bytes.clone()).expect("ASCII");
    for name in ["pasted", "a.bez", "a.bzc", "a.txt"] {
        assert!(controls(&read_text(name, curve)).curve().is_some(), "{name}");
        assert!(controls(&read_text(name, &surface)).curve().is_none(), "{name}");
    }
    // Numbers alone are not enough.
    assert!(error("pasted", "4\n0 0 1 1 2 1 3").contains("holds no model"));
    assert!(error("pasted", "4 x 1").contains("holds no model"));
}

#[test]
fn errors_name_their_line() {
    assert!(error("a.bzc", "#\n").contains("only comments; a Bezier curve begins with the number of its"));
    assert!(error("a.bez", " \n\n#").contains("only comments; a Bezier surface begins"));
    assert!(error("a.bzc", "\n\ntwo 1 2").contains("Line 3: a Bezier curve begins"));
    assert!(error("a.bzc", "0").contains("Line 1: "));
    assert!(error("a.bez", "-3 1 2 3").contains("1 or more, not with “-3”"));
    assert!(error("a.bez", "99999999999999999999 1").contains("1 or more"));
    assert!(error("a.bzc", "3\n1 2\n3 x4\n5 6").contains("Line 3: “x4” is not a number"));
    assert!(error("a.bzc", "2\n1 2\n3 nan").contains("Line 3: “nan”"));
    assert!(
        error("a.bzc", "2\n0,5 1\n2 3").contains("Line 2: “0,5” has a comma; numbers need decimal points")
    );
    assert!(error("a.bez", "1\n1 2 1e99").contains("Line 2: “1e99”"));
    assert_eq!(
        error("a.bzc", "# four\n4\n1 2 3 4 5 6 7"),
        "Could not open a.bzc. Line 2: 4 control points take 8 numbers in the plane or 12 in space, but 7 follow."
    );
    assert!(error("a.bez", "2\n1 2 3").contains("Line 1: a patch takes 48 numbers"));
    assert!(error("a.bzc", "4000000000\n1 2 3").contains("but 3 follow"));
    assert!(error("a.bez", "4000000000\n1 2 3").contains("only 3 follow"));
}

#[test]
fn numbers_before_an_unreadable_word_are_read() {
    let points = "0 1\n2 3\n4 5\n";
    let import = read_text("a.bzc", &format!("3\n{points}end\n6 7"));
    assert_eq!(controls(&import).points().len(), 3);
    let warnings: Vec<&str> = import.report.warnings().collect();
    assert_eq!(warnings, ["Everything from there on is left out: line 5: “end” is not a number that fits"]);
    // Six readable numbers are two points in space here, not three in the plane.
    assert!(error("a.bzc", "3\n1 2 3\n4 5 6\nx 8 9").contains("Line 4: “x” is not a number"));
    let text = String::from_utf8(write(by_code("bez"), &surface(2))[0].bytes.clone()).expect("ASCII");
    let broken = text.trim_end().rsplit_once(' ').expect("numbers").0.to_owned() + " ?";
    let import = read_text("a.bez", &broken);
    assert_eq!(controls(&import), &surface(1));
    assert!(import.report.to_string().contains("1 of 2 patches are there"), "{}", import.report);
    assert!(import.report.to_string().contains("“?” is not a number"), "{}", import.report);
}

#[test]
fn utf_16_is_read() {
    let text = String::from_utf8(write(by_code("bez"), &surface(2))[0].bytes.clone()).expect("ASCII");
    for mark in [&b"\xff\xfe"[..], b""] {
        let wide = [mark, &text.encode_utf16().flat_map(u16::to_le_bytes).collect::<Vec<u8>>()].concat();
        let import = read(&[NamedBytes::new("pasted", wide)]).expect("detected");
        assert_eq!(controls(&import), &surface(2));
    }
}

#[test]
fn a_curve_may_have_any_number_of_control_points() {
    let text: String = (0..30_000).map(|i| format!("\n{i} {}", i % 7)).collect();
    let import = read_text("a.bzc", &format!("30000{text}"));
    assert!(import.report.is_clean());
    assert_eq!(controls(&import).points().len(), 30_000);
    assert_eq!(controls(&import).points()[29_999], Vec3::new(29_999.0, 4.0, 0.0));
    assert_eq!(
        controls(&read(&write(by_code("bzc"), controls(&import))).expect("its own")),
        controls(&import)
    );
}

#[test]
fn leftover_numbers_are_reported() {
    let plane = curve(vec![Vec3::ZERO, Vec3::new(1.0, 1.0, 0.0)]);
    for (text, said) in
        [("2\n0 0\n1 1\n2 2\n", "2 numbers"), ("2\n0 0\n1 1 # x\n\n2 2\n3 3\n4 4", "6 numbers")]
    {
        let import = read_text("a.bzc", text);
        assert_eq!(controls(&import), &plane);
        let warnings: Vec<&str> = import.report.warnings().collect();
        assert_eq!(warnings, [format!("{said} after the last of the 2 control points left out")]);
    }
    let import = read_text("a.bzc", "1\n0 0 1\n2 2 2");
    assert_eq!(controls(&import), &curve(vec![Vec3::Z]));
    assert!(import.report.to_string().contains("3 numbers after the last of the 1 control point left out"));
    // As many as the count says in space, and no lines that say otherwise: nothing is left out.
    let import = read_text("a.bzc", "2\n0 0 1 1 2 2");
    assert_eq!(controls(&import), &curve(vec![Vec3::Z, Vec3::new(1.0, 2.0, 2.0)]));
    assert!(import.report.is_clean());
    assert!(import.report.to_string().contains("in space: there are three numbers"), "{}", import.report);
    // Neither: nothing tells which are meant.
    assert!(error("a.bzc", "2\n0 0 1 1 2").contains("but 5 follow"));
}

#[test]
fn a_surface_by_name_that_is_read_as_a_curve_says_so() {
    let import = read_text("s.bez", "1\n0 0 0\n");
    assert!(controls(&import).curve().is_some());
    let warnings: Vec<&str> = import.report.warnings().collect();
    assert!(warnings.len() == 1 && warnings[0].contains("it ends early: 3 numbers follow"), "{warnings:?}");
    assert!(read_text("s.bzc", "1\n0 0 0\n").report.is_clean());
}

#[test]
fn early_ends_keep_whole_patches() {
    let whole = write(by_code("bez"), &surface(3)).remove(0).bytes;
    let mut text = String::from_utf8(whole).expect("ASCII");
    text.push_str("7 8");
    let import = read_text("a.bez", &text);
    assert!(import.report.to_string().contains("2 numbers after the last of the 3 patches left out"));
    assert_eq!(controls(&import), &surface(3));
    let half = text.trim_end().rsplitn(4, '\n').last().expect("lines");
    let import = read_text("a.bez", half);
    assert!(import.report.to_string().contains("The file ends early: 2 of 3 patches are there"));
    assert_eq!(controls(&import), &surface(2));
}

fn course_files_read_and_round_trip() {
    for path in fixtures::shared_files("models/cs184", "bzc") {
        let file = load(&path);
        let import = read(std::slice::from_ref(&file)).expect("a curve");
        assert!(import.report.is_clean());
        let points = controls(&import).points().len();
        assert_eq!(points, if file.name == "curve1.bzc" { 4 } else { 5 });
        let written = write(by_code("bzc"), controls(&import));
        assert_eq!(controls(&read(&written).expect("its own")), controls(&import));
        let numbers = |bytes: &[u8]| -> Vec<f32> {
            String::from_utf8_lossy(bytes).split_whitespace().map(|w| w.parse().expect("a number")).collect()
        };
        assert_eq!(numbers(&written[0].bytes), numbers(&file.bytes));
    }
    for path in fixtures::shared_files("models/cs184", "bez") {
        let import = read(&[load(&path)]).expect("a surface");
        assert!(import.report.is_clean());
        let Bezier::Surface(patches) = controls(&import) else { panic!("a surface") };
        assert_eq!(patches.len(), 32);
        assert_eq!(patches[0].rows[0][1], Vec3::new(1.4, -0.784, 2.4));
        let written = write(by_code("bez"), controls(&import));
        assert_eq!(controls(&read(&written).expect("its own")), controls(&import));
    }
}

#[test]
fn losses_name_what_a_format_cannot_hold() {
    let triangle =
        Mesh::build(PolygonSoup::new(vec![Vec3::ZERO, Vec3::X, Vec3::Y], &[[0, 1, 2]])).expect("small").mesh;
    let shown = NamedMesh { mesh: triangle.clone().into(), ..bezier("surface", &surface(1)) };
    let objects = [NamedMesh::new("mesh", triangle), bezier("curve", &curve(vec![Vec3::X])), shown];
    let model =
        |objects: &[NamedMesh]| Model { name: "x".to_owned(), objects: objects.to_vec(), ..Model::default() };
    assert_eq!(
        formats::losses(by_code("bez"), &model(&objects)),
        [
            "BEZ holds only Bezier surfaces: mesh is left out",
            "BEZ holds only Bezier surfaces: curve is left out",
            "BEZ names a single object after its file: the name \"surface\" is lost",
        ]
    );
    assert_eq!(
        formats::losses(by_code("obj"), &model(&objects)),
        [
            "OBJ holds no Bezier curves: curve is left out",
            "OBJ holds no control points: surface is written as the mesh of 1 face that shows it"
        ]
    );
    let refused = |format, objects: &[NamedMesh]| {
        formats::write(format, &model(objects)).expect_err("nothing to write").message
    };
    assert!(refused(by_code("obj"), &objects[1..2]).contains("save it as BZC"));
    assert!(refused(by_code("bzc"), &objects[..1]).contains("no Bezier curve"));
    assert!(refused(by_code("bez"), &objects[..2]).contains("no Bezier surface"));
    // Two curves are two files, each of which reads.
    let both = model(&[objects[1].clone(), objects[1].clone()]);
    let names: Vec<String> =
        formats::write(by_code("bzc"), &both).expect("curves").into_iter().map(|f| f.name).collect();
    assert_eq!(names, ["x.bzc", "x-2.bzc"]);
    assert_eq!(formats::losses(by_code("bzc"), &both), ["BZC holds one curve: 2 curves go to 2 files"]);
    let import = read(&formats::write(by_code("obj"), &model(&objects)).expect("meshes")).expect("its own");
    assert_eq!(import.model.objects[0].mesh.face_count(), 2);
}

fn coordinates() -> impl Strategy<Value = Vec3> {
    let number = || any::<u32>().prop_map(f32::from_bits).prop_filter("finite", |x| x.is_finite());
    (number(), number(), number()).prop_map(Vec3::from)
}

fn bits(controls: &Bezier) -> Vec<[u32; 3]> {
    controls.points().iter().map(|p| p.to_array().map(f32::to_bits)).collect()
}

proptest! {
    #[test]
    fn written_curves_and_surfaces_read_back(points in prop::collection::vec(coordinates(), 1..70), plane: bool) {
        let flat = |p: &Vec3| if plane { Vec3::new(p.x, p.y, 0.0) } else { *p };
        let curve = curve(points.iter().map(flat).collect());
        let back = read(&write(by_code("bzc"), &curve)).expect("its own");
        prop_assert_eq!(bits(controls(&back)), bits(&curve));
        let surface = Bezier::from_points(false, points);
        if !surface.points().is_empty() {
            let back = read(&write(by_code("bez"), &surface)).expect("its own");
            prop_assert_eq!(bits(controls(&back)), bits(&surface));
        }
    }

    #[test]
    fn damaged_files_never_panic(
        of_surface: bool,
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0u8..4), 1..8),
    ) {
        let (format, sample) = if of_surface {
            (by_code("bez"), surface(2))
        } else {
            (by_code("bzc"), curve(surface(1).points()))
        };
        let mut bytes = write(format, &sample).remove(0).bytes;
        for (at, value, kind) in edits {
            if bytes.is_empty() {
                break;
            }
            let at = at.index(bytes.len());
            match kind {
                0 => bytes[at] = value,
                1 => bytes.truncate(at),
                2 => { bytes.remove(at); }
                _ => bytes.insert(at, value),
            }
        }
        for name in ["a", "a.bez", "a.bzc"] {
            if let Ok(import) = read(&[NamedBytes::new(name, bytes.clone())])
                && let Some(controls) = &import.model.objects[0].bezier
            {
                prop_assert!(controls.points().iter().all(|p| p.is_finite()));
            }
        }
    }
}
