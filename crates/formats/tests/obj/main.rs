//! OBJ: what is read, and that what is written reads back. The modules hold materials, faults and models of others.

#[path = "../common/mod.rs"]
mod common;

mod faults;
mod materials;
mod models;

use common::{by_code, mesh, model, read, read_obj, write};
use formats::{NamedBytes, ReadError};
use glam::{Vec2, Vec3};
use halfedge::attribute::keys;
use halfedge::{Element, FaceId, Mesh, PolygonSoup, VertexId};
use std::ops::ControlFlow;

fn corners(mesh: &Mesh, face: usize) -> Vec<u32> {
    mesh.face_vertices(FaceId::new(face)).map(|v| v.raw()).collect()
}

fn labels(mesh: &Mesh, key: halfedge::attribute::Key<u32>) -> Vec<Option<String>> {
    let column = mesh.column(Element::Face, key.name);
    mesh.faces()
        .map(|f| {
            let value = mesh.get(key, f.index());
            column.and_then(|column| column.labels.get(value as usize)).cloned()
        })
        .collect()
}

fn some(names: &[&str]) -> Vec<Option<String>> {
    names.iter().map(|name| (!name.is_empty()).then(|| (*name).to_owned())).collect()
}

/// Written and read again, the same mesh to the bit.
fn assert_round_trip(mesh: &Mesh) {
    let files = write(by_code("obj"), mesh);
    let back = read(&files).expect("what was written reads");
    assert_eq!(back.report.warnings().collect::<Vec<_>>(), [""; 0]);
    assert!(common::mesh(&back) == mesh, "{}", common::text(&files[0]));
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

#[test]
fn all_index_forms_and_negative_indices() {
    for face in [
        "1 2 3 4",
        "1/1 2/2 3/3 4/4",
        "1//1 2//1 3//1 4//1",
        "1/1/1 2/2/1 3/3/1 4/4/1",
        "-4/-4/-1 -3/-3/-1 -2/-2/-1 -1/-1/-1",
    ] {
        let import = read_obj(&format!("{SQUARE}vt 0 0\nvt 1 0\nvt 1 1\nvt 0 .5\nvn 0 0 1\nf {face}\n"));
        let mesh = mesh(&import);
        assert!(import.report.is_clean(), "{face}: {}", import.report);
        assert_eq!(corners(mesh, 0), [0, 1, 2, 3]);
        let last = mesh.face_halfedges(FaceId::new(0)).last().expect("corners").index();
        let has_uv = face.contains('/') && !face.contains("//");
        assert_eq!(
            mesh.attribute(keys::CORNER_UV).map(|uv| uv[last]),
            has_uv.then_some(Vec2::new(0.0, 0.5)),
            "{face}"
        );
        let has_normal = face.matches('/').count() == 8;
        assert_eq!(
            mesh.attribute(keys::CORNER_NORMAL).map(|n| n[last]),
            has_normal.then_some(Vec3::Z),
            "{face}"
        );
        assert_round_trip(mesh);
    }
}

#[test]
fn layout_of_the_text_does_not_matter() {
    let plain = read_obj(&format!("{SQUARE}f 1 2 3 4\n"));
    for text in [
        "v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2 3 4\r\n".to_owned(),
        "v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4\r".to_owned(),
        format!("\u{feff}{SQUARE}f 1 2 3 4"),
        format!("# start\n\n   # indented\n{SQUARE}  f\t1  2 3\t4   # end\n#"),
        "v 0 0 \\\n0\nv 1 \\\r\n 0 0\nv 1 1 0 # corner\nv 0 1 0#\nf 1 2 \\\n3 \\\n\\\n4".to_owned(),
        format!("f 1 2 3 4\n{SQUARE}"),
        format!("# a drawing \\_/ \\\n{SQUARE}# another \\\nf 1 2 3 4"),
        format!("{SQUARE}f +1 +2 03 4"),
    ] {
        let import = read_obj(&text);
        assert!(import.report.is_clean(), "{}", import.report);
        assert!(mesh(&import) == mesh(&plain), "{text:?}");
    }
}

#[test]
fn vertices_keep_their_order_whether_used_or_not() {
    let import = read_obj("v 9 9 9\nv 0 0 0\nv 5 5 5\nv 1 0 0\nv 0 1 0\nf 2 4 5\nv 7 7 7");
    let mesh = mesh(&import);
    assert_eq!(mesh.positions().iter().map(|p| p.x).collect::<Vec<_>>(), [9.0, 0.0, 5.0, 1.0, 0.0, 7.0]);
    assert_eq!(corners(mesh, 0), [1, 3, 4]);
    assert_round_trip(mesh);
}

#[test]
fn fourth_coordinates_and_vertex_colours() {
    let import = read_obj("v 0 0 0 2\nv 1 0 0 1 0.5 0.25\nv 1 1 0 1\nv 0 1 0 0.5 1 0 .125\nf 1 2 3 4");
    let mesh = mesh(&import);
    assert_eq!(mesh.position(VertexId::new(0)), Vec3::ZERO);
    let colors = mesh.attribute(keys::VERTEX_COLOR).expect("colours");
    assert!(colors[0].is_nan() && colors[2].is_nan());
    assert_eq!((colors[1], colors[3]), (Vec3::new(1.0, 0.5, 0.25), Vec3::new(1.0, 0.0, 0.125)));
    assert_eq!(
        import.report.warnings().collect::<Vec<_>>(),
        ["2 vertices kept as x, y, z: the fourth coordinate (w) is not used (lines 1, 4)"]
    );
    assert_round_trip(mesh);
}

#[test]
fn groups_objects_materials_and_smoothing_are_kept() {
    let import = read_obj(&format!(
        "mtllib a.mtl\n{SQUARE}v 2 0 0\nv 2 1 0\nv 3 0 0\nv 3 1 0\nf 1 2 3\no car\nf 1 3 4\ng  wheel   left # comment\ns 3\nusemtl red paint\nf 2 5 6\ng unused\ng\nusemtl Material #25\nf 2 6 3\no\ns off\ng wheel left\nf 5 7 8 6\n"
    ));
    let mesh = mesh(&import);
    assert_eq!(
        labels(mesh, keys::FACE_GROUP),
        some(&["", "o car", "o car; g wheel left", "o car", "wheel left"])
    );
    assert_eq!(mesh.column(Element::Face, "group").map(|c| c.labels.len()), Some(3));
    assert_eq!(
        labels(mesh, keys::FACE_MATERIAL),
        some(&["", "", "red paint", "Material #25", "Material #25"])
    );
    assert_eq!(mesh.attribute(keys::FACE_SMOOTHING), Some(&[0, 0, 3, 3, 0][..]));
    assert_eq!(mesh.attribute(keys::FACE_COLOR), None);
    assert!(import.report.to_string().contains("a.mtl, which was not given"), "{}", import.report);
    let files = write(by_code("obj"), mesh);
    assert_eq!(files.len(), 1, "no colours, so no file that could replace the real materials");
    assert_round_trip(mesh);
}

#[test]
fn several_objects_are_sections() {
    let first = read_obj(&format!("{SQUARE}vt 1 1\nusemtl m\ns 2\ng front\nf 1/1 2/1 3/1\no tail\nf 1 3 4"));
    let second = read_obj("v 5 5 5\nv 6 5 5\nv 5 6 5\nvt .5 .5\nf 1/1 2/1 3/1");
    let (a, b) = (mesh(&first), mesh(&second));
    let files = formats::write(by_code("obj"), &model("both", &[("a", a), ("b\n", b)])).expect("small");
    let back = read(&files).expect("readable");
    let both = mesh(&back);
    assert_eq!((both.vertex_count(), both.face_count()), (7, 3));
    assert_eq!(corners(both, 2), [4, 5, 6]);
    assert_eq!(labels(both, keys::FACE_GROUP), some(&["o a; g front", "o a; g tail", "o b"]));
    assert_eq!(both.attribute(keys::FACE_SMOOTHING), Some(&[2, 2, 0][..]));
    let uv = both.attribute(keys::CORNER_UV).expect("both have some");
    let uv_of = |face: usize| uv[both.halfedge_of(FaceId::new(face)).index()];
    assert_eq!((uv_of(0), uv_of(2)), (Vec2::ONE, Vec2::splat(0.5)));
    assert!(uv_of(1).is_nan());
}

#[test]
fn an_empty_mesh_goes_through() {
    assert_round_trip(&Mesh::new());
    let import = read_obj("o nothing\n");
    assert_eq!(mesh(&import).vertex_count(), 0);
}

#[test]
fn reading_can_be_cancelled_at_any_point() {
    let mut text = String::from("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
    while text.len() < 3 << 20 {
        text.push_str("# a comment that makes the file long\nv 0 0 0\n");
    }
    let files = [NamedBytes::new("long.obj", text)];
    let mut told = Vec::new();
    formats::read(&files, &mut |part| {
        told.push(part);
        ControlFlow::Continue(())
    })
    .expect("readable");
    assert!(
        told.len() >= 4 && told.is_sorted() && told.iter().all(|part| (0.0..=1.0).contains(part)),
        "{told:?}"
    );
    for stop_at in 0..told.len() {
        let mut calls = 0;
        let result = formats::read(&files, &mut |_| {
            calls += 1;
            if calls > stop_at { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        assert_eq!(result, Err(ReadError::Cancelled));
    }
}

#[test]
fn several_files_make_one_document() {
    let model = |x: f32| format!("v {x} 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 9\n");
    let files = [
        NamedBytes::new("one.obj", model(0.0)),
        NamedBytes::new("notes.doc", "?"),
        NamedBytes::new("two", model(2.0)),
    ];
    let import = read(&files).expect("readable");
    assert_eq!(import.model.objects.iter().map(|o| o.name.as_str()).collect::<Vec<_>>(), ["one", "two"]);
    assert_eq!(import.model.objects[1].mesh.position(VertexId::new(0)).x, 2.0);
    let warnings: Vec<_> = import.report.warnings().collect();
    assert_eq!(warnings.len(), 3);
    assert!(warnings[0].starts_with("one.obj: 1 face left out") && warnings[1].starts_with("two: "));
    assert!(warnings[2].starts_with("notes.doc was left out"));
    assert_eq!(import.model.objects.len(), 2);
}

#[test]
fn ids_with_gaps_are_written_without() {
    let positions = (0..6).map(|i| Vec3::new(i as f32, (i * i) as f32, 0.5)).collect();
    let mut mesh =
        Mesh::build(PolygonSoup::new(positions, &[[0, 1, 2], [0, 2, 3], [3, 4, 5]])).expect("small").mesh;
    let removed = halfedge::edit::delete_faces(&mut mesh, &[FaceId::new(1)]);
    assert!(removed.is_ok() && !mesh.is_compact());
    let back = read(&write(by_code("obj"), &mesh)).expect("readable");
    assert!(back.model.objects[0].mesh.to_soup() == mesh.to_soup());
}

#[test]
fn colours_in_comments_are_read() {
    let text = format!("#MRGB ff0000ffffff8000\n{SQUARE}#MRGB ff00ff00ff\nf 1 2 3 4\n");
    let import = read_obj(&text);
    let colors = mesh(&import).attribute(keys::VERTEX_COLOR).expect("colours");
    assert_eq!(colors[..3], [Vec3::Z, Vec3::new(1.0, 128.0 / 255.0, 0.0), Vec3::Y]);
    assert!(colors[3].is_nan());
    // Colours of the vertices themselves count for more.
    let import = read_obj(&format!("{text}v 0 0 1 1 0 0\n"));
    assert_eq!(mesh(&import).get(keys::VERTEX_COLOR, 4), Vec3::X);
    assert!(mesh(&import).get(keys::VERTEX_COLOR, 0).is_nan());
}

#[test]
fn older_faces_are_read() {
    let import = read_obj(&format!("{SQUARE}fo 1 2 3 4\n"));
    assert!(import.report.is_clean(), "{}", import.report);
    assert_eq!(corners(mesh(&import), 0), [0, 1, 2, 3]);
}
