//! PLY, STL and OFF: what is written reads back, what other programs write is read, and damage never panics. The
//! modules hold the formats' own tests and those of damaged files.

#[path = "../common/mod.rs"]
mod common;

mod damage;
mod off;
mod ply;
mod stl;

use common::{by_code, load, mesh, model, read, write};
use formats::{Format, NamedBytes};
use glam::{Vec2, Vec3};
use halfedge::attribute::{Column, keys};
use halfedge::{Color, Element, Mesh, PolygonSoup};

fixtures::shared_tests!(shared_models_round_trip);

const POLYGONS: [&str; 3] = ["ply", "ply-text", "off"];

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
        assert_eq!(formats::losses(format, &model("a", &[("a", &same)])), [""; 0], "{format:?}");
        let split = dressed(Some(false), Some(false));
        let lost = formats::losses(format, &model("a", &[("a", &split)])).join("\n");
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
