//! Faults in an OBJ, and files that other programs write or stumbled over.

use super::common::{case_file, mesh, read, read_obj};
use super::{SQUARE, assert_round_trip, corners, labels, some};
use formats::{Import, NamedBytes};
use glam::Vec3;
use halfedge::attribute::keys;
use halfedge::{Mesh, VertexId};

#[test]
fn damage_is_named_by_line_and_the_rest_loads() {
    let import = read_obj(&format!(
        "{SQUARE}v 1 x 2\nv 1 2\nvt a\nvn 1 2\nf 1 2 3\nf 1 2\nf 1 2 seven\nf 1 3 9\nf 0 1 2\nf -9 1 2\nf 1/7 3//2 4\nblah 1\nl 1 2\np 1\nv 1 2 3 4 5\nf 1 2 3.5\nf 1 3 4x\ns many\ncurv 0 1 1 2\nvp 0\nvp 1\ncurv2 1 2\nvt 0 1 0\nvt 0 1 2\n"
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
        "4 statements left out: free-form curves and surfaces and display settings are not used here: curv (1), vp (2), curv2 (1) (lines 23, 24, 25, 26)",
        "1 texture coordinate kept as u, v: the third coordinate (w) is not used (line 28)",
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
        "Could not open a.obj. It is not an OBJ file: it has no line for a vertex (\"v 1 2 3\") or a face (\"f 1 2 3\"). It \
         holds nothing else that Meshwright opens either. Check that it is the right file, or export the model again."
    );
    assert!(error("a.obj", b"# only a comment\n").contains("it has no line for a vertex"));
    assert!(error("a.obj", b"v 1 2 3\nf 1\0 2 3").contains("binary"));
    assert!(error("photo.png", b"\x89PNG").contains("photo.png. It holds no model"));
    assert!(error("a.mtl", b"newmtl a").contains("open it together with the OBJ model"));
    assert!(read(&[]).is_err());
}

fn case(name: &str) -> Import {
    read(&[case_file(name)]).unwrap_or_else(|error| panic!("{error}"))
}

fn error(text: &str) -> String {
    read(&[NamedBytes::new("a.obj", text)])
        .map_or_else(|error| error.to_string(), |import| panic!("{}", import.report))
}

#[test]
fn decimal_commas_are_read_where_they_are_nothing_else() {
    let import = case("obj-decimal-commas.obj");
    let expected = [[0.5, 1.25, -3.0], [1.5, 1.25, -3.0], [0.5, 2.25, -3.0]].map(Vec3::from_array);
    assert_eq!((mesh(&import).positions(), mesh(&import).face_count()), (&expected[..], 1));
    assert!(import.report.is_clean(), "{}", import.report);
    assert!(import.report.to_string().contains("Commas in its numbers were read as decimal commas"));
    let import = read_obj("v 0, 0, 0 # a, b\nv 1, 0, 0\nv 0, 1, 0\ng a, b\nf 1 2 3\n");
    assert_eq!(mesh(&import).positions(), [Vec3::ZERO, Vec3::X, Vec3::Y]);
    assert_eq!(labels(mesh(&import), keys::FACE_GROUP), some(&["a, b"]));
    // Beside decimal points one comma is a mistake.
    let import = read_obj("v 0.5 0 0\nv 1,5 0 0\nv 0 1.5 0\nf 1 2 3\n");
    assert_eq!(mesh(&import).position(VertexId::new(1)), Vec3::ZERO);
    assert!(import.report.to_string().contains("1 vertex put at the origin"), "{}", import.report);
    let message = error("v 1,000 2,000 3,000\nv 2,000 2,000 3,000\nv 1,000 3,000 3,000\nf 1 2 3\n");
    assert!(message.contains("decimal commas or separators"), "{message}");
}

#[test]
fn a_file_without_a_readable_vertex_is_refused() {
    let message = error("v a b c\nv 1 2\nv x\nf 1 2 3\n");
    assert!(message.contains("none of its vertices has three numbers"), "{message}");
    // One is enough, and so is none.
    assert_eq!(mesh(&read_obj("v a b c\nv 1 2 3\n")).vertex_count(), 2);
    assert_eq!(mesh(&read_obj("o nothing\n")).vertex_count(), 0);
}

#[test]
fn solids_that_share_an_edge_stay_closed() {
    let import = case("obj-two-cubes-one-edge.obj");
    let mesh: &Mesh = mesh(&import);
    assert_eq!((mesh.face_count(), mesh.vertex_count()), (12, 16));
    assert!(mesh.boundary_loops().is_empty());
    assert_eq!(mesh.components().1, 2);
    assert!(import.report.to_string().contains("1 edge separated: more than two faces met there"));
    assert_round_trip(mesh);
}
