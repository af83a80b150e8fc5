//! PLY, STL and OFF: what is written reads back, what others write reads, damage never panics.

mod common;

use common::{by_code, load, mesh, model, read, write};
use formats::{Format, NamedBytes};
use glam::{Vec2, Vec3};
use halfedge::attribute::{Column, keys};
use halfedge::{Color, Element, Mesh, PolygonSoup, VertexId};
use proptest::prelude::*;

fixtures::shared_tests!(shared_models_round_trip);

const POLYGONS: [&str; 3] = ["ply", "ply-text", "off"];
const ALL: [&str; 5] = ["ply", "ply-text", "off", "stl", "stl-text"];

/// Two quads and a triangle, a vertex in no face, and positions hard to print.
fn sample() -> Mesh {
    let positions = [
        [0.0, 0.0, 0.0],
        [1.0, -0.0, 1e-30],
        [1.1, 1.0 / 3.0, 0.1],
        [0.0, 1.0, 16_777_217.0],
        [9.0, 9.0, 9.0],
        [-1.0, 2.0, f32::MIN_POSITIVE],
        [-3.0, 1.0, 3.4e38],
        [-2.0, 0.1, 0.0],
    ];
    let faces: [&[u32]; 3] = [&[0, 1, 2, 3], &[3, 5, 0], &[0, 5, 6, 7]];
    let soup = PolygonSoup::new(positions.map(Vec3::from_array).to_vec(), &faces);
    Mesh::build(soup).expect("small").mesh
}

fn painted() -> Mesh {
    let mut mesh = sample();
    let colors = vec![Color([1, 2, 3]), Color::UNPAINTED, Color([255, 0, 128])];
    mesh.insert_column(Element::Face, Column::with_values(keys::FACE_COLOR, colors));
    let colors = (0..8u8).map(|i| Vec3::new(f32::from(i * 30) / 255.0, 1.0, 0.2)).collect();
    mesh.insert_column(Element::Vertex, Column::with_values(keys::VERTEX_COLOR, colors));
    mesh
}

/// The corner positions of every face, to the bit.
fn faces(mesh: &Mesh) -> Vec<Vec<[u32; 3]>> {
    mesh.faces()
        .map(|f| mesh.face_vertices(f).map(|v| mesh.position(v).to_array().map(f32::to_bits)).collect())
        .collect()
}

fn back(format: Format, mesh: &Mesh) -> Mesh {
    let import = read(&write(format, mesh)).unwrap_or_else(|error| panic!("{format:?}: {error}"));
    assert!(import.report.is_clean(), "{format:?}: {}", import.report);
    common::mesh(&import).clone()
}

#[test]
fn polygons_and_colours_round_trip() {
    for format in POLYGONS.map(by_code) {
        assert!(back(format, &sample()) == sample(), "{format:?}");
        assert!(back(format, &painted()) == painted(), "{format:?}");
        assert!(back(format, &Mesh::new()) == Mesh::new(), "{format:?}");
    }
}

/// [`painted`] with texture coordinates and normals at corners, which agree at vertices or don't.
fn dressed(normals: Option<bool>, uvs: Option<bool>) -> Mesh {
    let mut mesh = painted();
    for h in mesh.halfedges().filter(|&h| !mesh.is_boundary_halfedge(h)).collect::<Vec<_>>() {
        let (v, corner) = (mesh.from(h).index() as f32, h.index() as f32);
        if let Some(agree) = normals {
            let normal = if agree { Vec3::new(v, 1.0, -0.5) } else { Vec3::new(0.0, corner, 0.7) };
            mesh.set(keys::CORNER_NORMAL, h.index(), normal);
        }
        if let Some(agree) = uvs {
            let uv = if agree { Vec2::new(v, 0.1) } else { Vec2::new(0.3, corner / 7.0) };
            mesh.set(keys::CORNER_UV, h.index(), uv);
        }
    }
    mesh
}

#[test]
fn normals_and_texture_coordinates_round_trip_where_there_is_a_place_for_them() {
    for format in POLYGONS.map(by_code) {
        let same = dressed(Some(true), Some(true));
        assert!(back(format, &same) == same, "{format:?}");
        assert_eq!(formats::losses(format, &model("", &[("a", &same)])), [""; 0], "{format:?}");
        let split = dressed(Some(false), Some(false));
        let lost = formats::losses(format, &model("", &[("a", &split)])).join("\n");
        assert!(lost.contains("holds one normal for each vertex: those of 11 corners are lost"), "{lost}");
        assert_eq!(lost.contains("one texture coordinate"), format == by_code("off"), "{lost}");
        let kept = dressed(None, (format != by_code("off")).then_some(false));
        assert!(back(format, &split) == kept, "{format:?}");
    }
    // Faces without texture coordinates among others.
    let mut some = dressed(Some(true), Some(false));
    for h in some.face_halfedges(halfedge::FaceId::new(1)).collect::<Vec<_>>() {
        some.set(keys::CORNER_UV, h.index(), Vec2::NAN);
    }
    for format in [by_code("ply"), by_code("ply-text")] {
        assert!(back(format, &some) == some, "{format:?}");
    }
    // More corners than a byte counts numbers for.
    let ring: Vec<Vec3> =
        (0..200).map(|i| Vec3::new((i as f32 * 0.03).cos(), (i as f32 * 0.03).sin(), 0.0)).collect();
    let mut large =
        Mesh::build(PolygonSoup::new(ring, &[(0..200).collect::<Vec<u32>>()])).expect("small").mesh;
    for h in large.face_halfedges(halfedge::FaceId::new(0)).collect::<Vec<_>>() {
        large.set(keys::CORNER_UV, h.index(), Vec2::splat(h.index() as f32));
    }
    for format in [by_code("ply"), by_code("ply-text")] {
        assert!(back(format, &large) == large, "{format:?}");
    }
}

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
    assert_eq!(formats::losses(by_code("stl"), &model("", &[("a", &cube)])).len(), 1);
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
fn several_objects_are_written_as_one_mesh() {
    let (a, b) = (sample(), painted());
    for format in POLYGONS.map(by_code) {
        let files = formats::write(format, &model("x", &[("a", &a), ("b", &b)])).expect("small");
        let import = read(&files).expect("readable");
        let both = mesh(&import);
        assert_eq!((both.vertex_count(), both.face_count()), (16, 6));
        assert_eq!(faces(both)[3..], faces(&b));
        assert_eq!(both.get(keys::FACE_COLOR, 5), Color([255, 0, 128]));
    }
}

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
        assert!(
            import.report.to_string().contains("left out: nx, flags, all of \"edge\""),
            "{}",
            import.report
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
    // What a face says counts for more; one of the wrong length says nothing.
    let names = format!("{normals}property float s\nproperty float t\n");
    let list = "property list uchar float texcoord\n";
    let of = |face: &str| {
        let import = read(&[NamedBytes::new("a.ply", ply(&names, list, face))]).expect("readable");
        at(mesh(&import), 1).1
    };
    assert_eq!(of(" 6 9 9 8 8 7 7"), Vec2::splat(8.0));
    assert_eq!(of(" 4 9 9 8 8"), Vec2::new(0.0, 0.25));
    let off = "STNOFF 3 1 0\n0 0 0 0 0 1 .5 1\n1 0 0 0 0 0 0 .25\n0 1 0 0 1 0 1 0\n3 0 1 2\n";
    let import = read(&[NamedBytes::new("a", off)]).expect("readable");
    assert_eq!(at(mesh(&import), 2), (Vec3::Y, Vec2::X));
    let off = "STCOFF 3 1 0\n0 0 0 1 0 0 .5 1\n1 0 0 1 0 0 1 0 .25\n0 1 0 1 0 0 1 1 0\n3 0 1 2\n";
    let import = read(&[NamedBytes::new("a", off)]).expect("readable");
    assert_eq!(
        [0, 1, 2].map(|c| at(mesh(&import), c).1),
        [Vec2::new(0.5, 1.0), Vec2::new(0.0, 0.25), Vec2::X]
    );
    assert_eq!(mesh(&import).get(keys::VERTEX_COLOR, 2), Vec3::X);
}

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

#[test]
fn vertices_in_no_face_are_counted_in_the_report() {
    let loose = "6 vertices in no face, kept as single points (numbers 1, 2, 4, 5, 6, 7)";
    for (name, text) in [
        (
            "a.obj",
            "v 0 0 0\nv 9 0 0\nv 9 1 0\nv 1 0 0\nv 9 2 0\nv 9 3 0\nv 9 4 0\nv 9 5 0\nv 0 1 0\nf 1 4 9\n",
        ),
        ("a.off", "OFF 9 1 0\n0 0 0\n9 0 0\n9 1 0\n1 0 0\n9 2 0\n9 3 0\n9 4 0\n9 5 0\n0 1 0\n3 0 3 8\n"),
    ] {
        let import = read(&[NamedBytes::new(name, text)]).expect("readable");
        let notes = import.report.to_string();
        assert_eq!(notes.matches("in no face").count(), 1, "{notes}");
        assert!(notes.contains(loose), "{notes}");
        assert!(import.report.is_clean(), "kept as they were: nothing to warn of");
        assert_eq!(mesh(&import).vertex_count(), 9);
        // Written in a format that keeps them, they are counted again.
        let again = read(&write(by_code("ply"), mesh(&import))).expect("its own").report.to_string();
        assert!(again.contains(loose), "{again}");
    }
    let one = read(&[NamedBytes::new("a.obj", "v 0 0 0\n")]).expect("readable").report.to_string();
    assert!(one.contains("1 vertex in no face, kept as single points (number 0)"), "{one}");
    let none = read(&write(by_code("ply"), &Mesh::new())).expect("its own").report.to_string();
    assert!(!none.contains("in no face"), "{none}");
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

#[test]
fn early_ends_and_nonsense_are_told() {
    let report = |name: &str, bytes: &[u8]| match read(&[NamedBytes::new(name, bytes)]) {
        Ok(import) => {
            mesh(&import);
            import.report.to_string()
        }
        Err(error) => error.to_string(),
    };
    let ply = write(by_code("ply"), &sample()).remove(0).bytes;
    assert!(report("a.ply", &ply[..ply.len() - 20]).contains("The file ends early: 2 of 3 rows"));
    assert!(
        report("a.ply", b"ply\nformat ascii 1.0\nelement vertex 4000000000\nend_header\n")
            .contains("Read 0 vertices")
    );
    assert!(
        report(
            "a.ply",
            b"ply\nformat ascii 1.0\nelement vertex 99999999999\nproperty int x\nend_header\n1 2"
        )
        .contains("ends early: 2 of 99999999999")
    );
    assert!(
        report("a.ply", b"ply\nformat ebcdic 1.0\n").contains("line 2 of the head: the format is none of")
    );
    assert!(report("a.ply", b"hello").contains("first line is not \"ply\""));
    assert!(report("a.stl", b"hello").contains("shorter than the head"));
    assert!(report("a.stl", &[b'x'; 84]).contains("none of its 2021161080 triangles"));
    assert!(
        report("a.stl", b"solid\nfacet\nvertex 1 2 3\nendfacet\nvertex 1").contains("1 triangle left out")
    );
    assert!(report("a.off", b"OFF BINARY\n").contains("binary OFF"));
    assert!(report("a.off", b"OFF\nx").contains("don't come first"));
    assert!(
        report("a.off", b"OFF 2000000000 4000000000 1\n0 0 0")
            .contains("1 of 2000000000 vertices and 0 of 4000000000")
    );
    assert!(report("a.off", b"OFF 3 1 1\n0 0 0 1 0 0 0 1 0\n4000000000 0 1 2").contains("1 face left out"));
}

fn shared_models_round_trip() {
    for path in fixtures::shared_files("models/common", "obj") {
        let original = read(&[load(&path)]).expect("readable");
        let original = original.model.objects[0].mesh.as_ref();
        for format in POLYGONS.map(by_code) {
            let back = back(format, original);
            // Identical, where the format has a place for all there is.
            if formats::losses(format, &model("", &[("", original)])).is_empty() {
                assert!(back == *original, "{format:?} {}", path.display());
            }
            assert!(back.positions() == original.positions(), "{format:?} {}", path.display());
            assert_eq!(faces(&back), faces(original), "{format:?} {}", path.display());
        }
        if formats::losses(by_code("stl"), &model("", &[("", original)]))
            .iter()
            .any(|l| l.contains("polygon"))
        {
            continue;
        }
        for format in [by_code("stl"), by_code("stl-text")] {
            // Vertices that repairs made from one are one again, and a triangle may have had corners
            // at one place: what is compared then is which places the triangles join.
            let import = read(&write(format, original)).expect("readable");
            let places = |mesh: &Mesh| -> Vec<Vec<[u32; 3]>> {
                let place = |v| (mesh.position(v) + Vec3::ZERO).to_array().map(f32::to_bits);
                mesh.faces().map(|f| mesh.face_vertices(f).map(place).collect()).collect()
            };
            let (mut ours, mut theirs) = (places(mesh(&import)), places(original));
            if !import.report.is_clean() {
                for list in [&mut ours, &mut theirs] {
                    for face in list.iter_mut() {
                        face.sort_unstable();
                        face.dedup();
                    }
                    list.retain(|face| face.len() == 3);
                    list.sort_unstable();
                    list.dedup();
                }
            }
            assert!(ours == theirs, "{format:?} {}: {}", path.display(), import.report);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(600))]

    #[test]
    fn damaged_files_never_panic(
        format in prop::sample::select(ALL.map(by_code).to_vec()),
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0u8..4), 1..8),
    ) {
        let mut bytes = write(format, &painted()).remove(0).bytes;
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
        for name in ["a", "a.ply", "a.stl", "a.off"] {
            if let Ok(import) = read(&[NamedBytes::new(name, bytes.clone())]) {
                mesh(&import);
            }
        }
    }
}
