//! Files that are too large are refused before they are read, or while they are, and in words.

use formats::{NamedBytes, Repairs, Room, read_within, refusal};
use std::ops::ControlFlow;

const ROOM: Room = Room { file_bytes: 10_000, corners: 300 };

fn stl(triangles: u32) -> Vec<u8> {
    let mut bytes = [&[0; 80][..], &triangles.to_le_bytes()].concat();
    for at in 0..triangles {
        let at = at as f32;
        let floats = [0.0, 0.0, 1.0, at, 0.0, 0.0, at + 1.0, 0.0, 0.0, at, 1.0, 0.0];
        floats.iter().for_each(|float: &f32| bytes.extend(float.to_le_bytes()));
        bytes.extend([0; 2]);
    }
    bytes
}

fn ply(faces: usize) -> String {
    let rows = "3 0 1 2\n".repeat(faces);
    format!(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face \
         {faces}\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n{rows}"
    )
}

/// Triangles apart from each other.
fn obj(triangles: usize) -> String {
    let corner = |at: usize| format!("v {at} 0 0\nv {at} 1 0\nv {at} 0 1\n");
    let face = |at: usize| format!("f {} {} {}\n", 3 * at + 1, 3 * at + 2, 3 * at + 3);
    (0..triangles).map(corner).chain((0..triangles).map(face)).collect()
}

fn read(name: &str, bytes: &[u8]) -> Result<usize, String> {
    let room = Room { file_bytes: u64::MAX, ..ROOM };
    let files = [NamedBytes::new(name, bytes.to_vec())];
    read_within(&files, &Repairs::default(), &room, &mut |_| ControlFlow::Continue(()))
        .map(|import| import.model.objects.iter().map(|object| object.mesh.face_count()).sum())
        .map_err(|error| error.to_string())
}

#[test]
fn the_beginning_of_a_file_tells_that_it_does_not_fit() {
    let too_large = |bytes: &[u8], all: usize| refusal(&ROOM, &bytes[..bytes.len().min(400)], all as u64);
    assert_eq!(too_large(&stl(100), 84 + 50 * 100), None);
    let refused = too_large(&stl(101), 84 + 50 * 101).expect("too many");
    assert!(
        refused.starts_with("its faces have as many corners as 101 triangles, and at most 100 triangles"),
        "{refused}"
    );
    assert!(refused.contains("meshwright apply"), "{refused}");
    assert_eq!(too_large(&stl(101), 84 + 50 * 102), None, "no binary STL has this size");
    assert_eq!(too_large(ply(100).as_bytes(), 5000), None);
    assert!(too_large(ply(101).as_bytes(), 5000).is_some());
    assert_eq!(refusal(&ROOM, &ply(101).as_bytes()[..60], 5000), None, "the header goes on");
    assert!(too_large(b"v 0 0 0", 10_001).expect("too large").contains("MB"));
    assert_eq!(refusal(&Room::UNLIMITED, &stl(101), u64::MAX), None);
}

#[test]
fn corners_are_counted_while_reading() {
    assert_eq!(read("a.obj", obj(100).as_bytes()), Ok(100));
    let refused = read("a.obj", obj(101).as_bytes()).expect_err("too many");
    assert!(
        refused.starts_with("Could not open a.obj. Its faces have as many corners as 101 triangles"),
        "{refused}"
    );
    for (name, bytes) in [("a.stl", stl(101)), ("a.ply", ply(101).into_bytes())] {
        let refused = read(name, &bytes).expect_err("too many");
        assert!(refused.contains("at most 100 triangles can be opened in a browser"), "{refused}");
    }
}

#[test]
fn the_corners_of_all_objects_count() {
    // Two objects share a mesh of 60 triangles.
    let triangles = 60;
    let positions: String = (0..3 * triangles).map(|at| format!("{} {} {} ", at, at % 2, at % 3)).collect();
    let indices: String = (0..3 * triangles).map(|at| format!("{at} ")).collect();
    let node = |name: &str| format!("<node id=\"{name}\"><instance_geometry url=\"#g\"/></node>");
    let dae = |nodes: &str| {
        format!(
            "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">\
             <library_geometries><geometry id=\"g\"><mesh><source id=\"p\"><float_array id=\"pa\" count=\"{}\">{positions}\
             </float_array><technique_common><accessor source=\"#pa\" count=\"{}\" stride=\"3\"/></technique_common>\
             </source><vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices><triangles \
             count=\"{triangles}\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>{indices}</p></triangles>\
             </mesh></geometry></library_geometries><library_visual_scenes><visual_scene id=\"s\">{nodes}\
             </visual_scene></library_visual_scenes><scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>",
            9 * triangles,
            3 * triangles
        )
    };
    assert_eq!(read("a.dae", dae(&node("one")).as_bytes()), Ok(60));
    let refused = read("a.dae", dae(&(node("one") + &node("two"))).as_bytes()).expect_err("too many");
    assert!(refused.contains("as many corners as 120 triangles"), "{refused}");
}
