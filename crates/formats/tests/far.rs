//! Models far from the origin: coordinates keep their digits through every format, once and again.

mod common;

use common::{by_code, mesh, read, renamed};
use formats::{Import, NamedBytes};
use glam::DVec3;

/// A roof in map coordinates, some two meters wide, with millimeters.
const ROOF: [[f64; 3]; 5] = [
    [4_458_321.123, 5_412_000.004, 12.125],
    [4_458_323.125, 5_412_000.011, 12.13],
    [4_458_323.119, 5_412_002.008, 12.121],
    [4_458_321.127, 5_412_002.002, 12.127],
    [4_458_322.12, 5_412_001.006, 13.75],
];

fn obj() -> String {
    let vertices: String = ROOF.iter().map(|[x, y, z]| format!("v {x} {y} {z}\n")).collect();
    format!("{vertices}f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\nf 4 3 2 1\n")
}

fn read_text(name: &str, text: impl Into<Vec<u8>>) -> Import {
    let import = read(&[NamedBytes::new(name, text)]).unwrap_or_else(|error| panic!("{error}"));
    mesh(&import);
    import
}

/// The coordinates as they are in the file, faces' corners one after the other.
fn corners(import: &Import) -> Vec<DVec3> {
    let mesh = mesh(import);
    mesh.faces()
        .flat_map(|f| {
            mesh.face_vertices(f)
                .map(|v| mesh.position(v).as_dvec3() + import.model.offset)
                .collect::<Vec<_>>()
        })
        .collect()
}

fn expected() -> Vec<DVec3> {
    [[0, 1, 4].as_slice(), &[1, 2, 4], &[2, 3, 4], &[3, 0, 4], &[3, 2, 1, 0]]
        .concat()
        .into_iter()
        .map(|v| DVec3::from(ROOF[v]))
        .collect()
}

fn check(import: &Import, what: &str) {
    for (at, is) in corners(import).iter().zip(expected()) {
        assert!(at.distance(is) < 3e-7, "{what}: {at} is {is}");
    }
    assert!(import.report.to_string().contains("far from the origin"), "{what}: {}", import.report);
}

#[test]
fn digits_survive_reading_and_writing_in_every_format() {
    let import = read_text("roof.obj", obj());
    assert_eq!(import.model.offset.fract(), DVec3::ZERO);
    assert_eq!(import.model.offset.z, 0.0, "12 is not far for two meters");
    check(&import, "OBJ");
    for format in [by_code("obj"), by_code("ply"), by_code("ply-text"), by_code("off"), by_code("dae")] {
        let files = formats::write(format, &renamed(&import, "roof")).expect("small");
        let back = read(&files).expect("its own");
        check(&back, format.name());
        assert_eq!(back.model.offset, import.model.offset, "{format:?}");
        assert!(mesh(&back) == mesh(&import), "{format:?}: to the bit");
    }
    // Formats of triangles.
    for format in [by_code("glb"), by_code("gltf"), by_code("stl-text")] {
        let files = formats::write(format, &renamed(&import, "roof")).expect("small");
        let back = read(&files).expect("its own");
        assert_eq!((back.model.offset, mesh(&back).vertex_count()), (import.model.offset, 5), "{format:?}");
        let places = |import: &Import| {
            let mut places: Vec<[u32; 3]> =
                mesh(import).positions().iter().map(|p| p.to_array().map(f32::to_bits)).collect();
            places.sort_unstable();
            places
        };
        assert_eq!(places(&back), places(&import), "{format:?}");
    }
    let lost = formats::losses(by_code("stl"), &import.model).join("\n");
    assert!(lost.contains("positions so far from the origin are rounded"), "{lost}");
    let files = formats::write(by_code("stl"), &renamed(&import, "roof")).expect("small");
    let back = read(&files).expect("its own");
    assert_ne!(back.model.offset, DVec3::ZERO, "32 bits have no more digits to keep, but edits do");
    let json = formats::write(by_code("json"), &renamed(&import, "roof")).expect("small").remove(0);
    let value: serde_json::Value = serde_json::from_slice(&json.bytes).expect("JSON");
    let x = value["positions"][0][0].as_f64().expect("a number");
    assert!((x - ROOF[0][0]).abs() < 3e-7, "{x}");
}

#[test]
fn what_32_bits_hold_is_kept_exactly_and_leaves_room_for_edits() {
    // Far away, but whole numbers: there are digits for what an edit adds.
    let import = read_text("a.obj", "v 5000000 0 0\nv 5000001 0 0\nv 5000000 1 0\nf 1 2 3\n");
    let x = |import: &Import, v: usize| f64::from(mesh(import).positions()[v].x) + import.model.offset.x;
    assert_eq!((x(&import, 0), x(&import, 1)), (5_000_000.0, 5_000_001.0));
    let spacing = mesh(&import).positions().iter().map(|p| p.x.next_up() - p.x).fold(0.0, f32::max);
    assert!(spacing < 1e-6, "{spacing}");
    // A map of a hundred kilometers.
    let map = "v 5000000 0 0\nv 5100000 0 0\nv 5000000 1000 0\nf 1 2 3\n";
    let import = read_text("map.obj", map);
    assert_eq!((x(&import, 0), x(&import, 1)), (5_000_000.0, 5_100_000.0));
    // A vertex that no face uses would lose digits by an offset, and faces gain none by it.
    let import = read_text("a.obj", "v 5000000 0 0\nv 5000001 0 0\nv 5000000 1 0\nv 0.1 0 0\nf 1 2 3\n");
    assert_eq!(import.model.offset, DVec3::ZERO);
    assert_eq!(mesh(&import).positions()[3].x, 0.1);
    // Near, whatever the digits.
    let import = read_text("a.obj", "v 0.1 0 0\nv 1.1 0 0\nv 0.1 1 0\nf 1 2 3\n");
    assert_eq!(import.model.offset, DVec3::ZERO);
    // A vertex that no face uses does not count.
    let import = read_text("a.obj", format!("{}v 0 0 0\n", obj()));
    assert_ne!(import.model.offset, DVec3::ZERO);
}

#[test]
fn a_node_far_away_keeps_the_digits_of_its_mesh() {
    let dae = |translate: &str| {
        format!(
            "<COLLADA><library_geometries><geometry id=\"g\"><mesh><source id=\"p\"><float_array id=\"a\" count=\"9\">\
             0 0 0 0.125 0 0 0 0.0625 0</float_array><technique_common><accessor source=\"#a\" count=\"3\" \
             stride=\"3\"/></technique_common></source><vertices id=\"v\"><input semantic=\"POSITION\" \
             source=\"#p\"/></vertices><polylist count=\"1\"><input semantic=\"VERTEX\" source=\"#v\" \
             offset=\"0\"/><vcount>3</vcount><p>0 1 2</p></polylist></mesh></geometry></library_geometries>\
             <library_visual_scenes><visual_scene id=\"s\"><node>{translate}<instance_geometry url=\"#g\"/></node>\
             </visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>"
        )
    };
    let near = read_text("a.dae", dae(""));
    let far = read_text("a.dae", dae("<translate>4000000.5 0 0</translate>"));
    assert_eq!(near.model.offset, DVec3::ZERO);
    assert_ne!(far.model.offset, DVec3::ZERO);
    for (a, b) in corners(&near).iter().zip(corners(&far)) {
        assert!((*a + DVec3::new(4_000_000.5, 0.0, 0.0)).distance(b) < 1e-9, "{a} {b}");
    }
}

#[test]
fn files_opened_together_share_an_offset() {
    let moved = obj().replace("4458", "4459");
    let import = read(&[NamedBytes::new("a.obj", obj()), NamedBytes::new("b.obj", moved)]).expect("readable");
    assert_eq!(import.model.objects.len(), 2);
    // A kilometer apart, but kept with more digits than they would have there.
    let x =
        |object: usize| f64::from(import.model.objects[object].mesh.positions()[0].x) + import.model.offset.x;
    assert!((x(1) - x(0) - 1000.0).abs() < 1e-4, "{} {}", x(0), x(1));
}

#[test]
fn control_points_share_the_offset_and_get_it_back() {
    let text = |z: &str| -> String {
        (0..16)
            .map(|i| format!("{} {}{z}\n", 5_000_000.125 + f64::from(i % 4), -3.5 + f64::from(i / 4)))
            .collect()
    };
    for (name, count, z) in [("a.bez", 1, " 0.5"), ("a.bzc", 16, ""), ("a.bzc", 16, " 0.5")] {
        let text = format!("{count}\n{}", text(z));
        let import = read(&[NamedBytes::new(name, text.as_str())]).expect("readable");
        let offset = import.model.offset;
        assert!(offset.x > 4e6 && (offset.y, offset.z) == (0.0, 0.0), "{offset}");
        let format = formats::Format::from_name(name).expect("a format");
        let written = formats::write(format, &import.model).expect("control points").remove(0);
        let numbers = |text: &str| -> Vec<f64> {
            text.split_whitespace().map(|word| word.parse().expect("a number")).collect()
        };
        assert_eq!(numbers(common::text(&written)), numbers(&text), "{name}");
    }
    // With a mesh that lies there, too.
    let curve = "2\n4458321.125 5412000.5\n4458322.25 5412001.75\n";
    let import =
        read(&[NamedBytes::new("roof.obj", obj()), NamedBytes::new("a.bzc", curve)]).expect("readable");
    assert_ne!(import.model.offset, DVec3::ZERO);
    let written = formats::write(by_code("bzc"), &import.model).expect("a curve").remove(0);
    assert_eq!(common::text(&written), curve);
}

/// Far enough away, all corners round to the same place, and the faces go.
#[test]
fn a_model_that_rounding_makes_a_point_is_far_away_too() {
    let at = |x: f64, y: f64| format!("vertex {} {} -70000000\n", 5e7 + x, 6e7 + y);
    let corners = [at(0.0, 0.0), at(1.0, 0.0), at(0.0, 0.5)].concat();
    let text = format!("solid\nfacet normal 0 0 1\nouter loop\n{corners}endloop\nendfacet\nendsolid\n");
    let import = read(&[NamedBytes::new("a.stl", text)]).expect("readable");
    let mut places: Vec<[f64; 3]> = mesh(&import)
        .positions()
        .iter()
        .map(|position| (position.as_dvec3() + import.model.offset - DVec3::new(5e7, 6e7, -7e7)).to_array())
        .collect();
    places.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
    assert_eq!(places, [[0.0, 0.0, 0.0], [0.0, 0.5, 0.0], [1.0, 0.0, 0.0]]);
    assert_eq!(mesh(&import).face_count(), 1);
}
