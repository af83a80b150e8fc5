//! glTF and GLB: what is written reads back, files of other writers, hostile input.

#[path = "../common/mod.rs"]
mod common;

mod build;
mod cases;
mod content;
mod faults;
mod materials;
mod poses;

use common::{by_code, load, mesh, model, read};
use formats::{Format, NamedBytes};
use glam::{Vec2, Vec3};
use halfedge::attribute::{Column, keys};
use halfedge::{Color, Element, Mesh, PolygonSoup, VertexId};
use proptest::prelude::*;

fixtures::shared_tests!(shared_triangle_models_round_trip);

fn both() -> [Format; 2] {
    ["glb", "gltf"].map(by_code)
}

/// An octahedron with a uv and a normal at each corner, so that files split its vertices.
fn octahedron() -> Mesh {
    let positions = [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::X, -Vec3::Y, -Vec3::Z].to_vec();
    let faces = [[0u32, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]];
    let mut soup = PolygonSoup::new(positions, &faces);
    let uv = |i: usize| Vec2::new(i as f32 / 32.0, (i % 3) as f32 / 4.0);
    soup.corner_columns.push(Column::with_values(keys::CORNER_UV, (0..24).map(uv).collect()));
    let normal = |i: usize| if (i / 3).is_multiple_of(2) { Vec3::X } else { Vec3::Y };
    soup.corner_columns.push(Column::with_values(keys::CORNER_NORMAL, (0..24).map(normal).collect()));
    Mesh::build(soup).expect("small").mesh
}

#[test]
fn split_vertices_become_one_again() {
    let mesh_in = octahedron();
    for format in both() {
        let files =
            formats::write(format, &model("two", &[("a", &mesh_in), ("b", &mesh_in)])).expect("small");
        let import = read(&files).expect("readable");
        assert!(import.report.is_clean(), "{}", import.report);
        assert_eq!(import.model.objects.iter().map(|o| o.name.as_str()).collect::<Vec<_>>(), ["a", "b"]);
        for object in &import.model.objects {
            object.mesh.validate().expect("valid");
            let (back, given) = (object.mesh.to_soup(), mesh_in.to_soup());
            assert!(back.positions == given.positions && back.corners == given.corners, "{format:?}");
            for name in ["uv", "normal"] {
                let column =
                    |soup: &PolygonSoup| soup.corner_columns.iter().find(|c| c.name == name).cloned();
                assert!(column(&back) == column(&given), "{name}");
            }
        }
    }
}

#[test]
fn a_model_alone_opens_by_itself() {
    let mesh_in = octahedron();
    for format in both().into_iter().chain([by_code("obj")]) {
        let files = formats::write(format, &model("two", &[("a", &mesh_in)])).expect("small");
        let alone = formats::single_file(files).expect("there is one");
        let import = read(&[alone]).expect("readable");
        assert_eq!(import.model.objects[0].mesh.face_count(), 8, "{format:?}");
    }
    let empty = formats::write(by_code("gltf"), &model("none", &[])).expect("small");
    assert!(formats::single_file(empty).is_some() && formats::single_file(Vec::new()).is_none());
}

/// Two squares side by side whose border vertices are at the same places but not the same, and a vertex
/// in no face at one of those places.
fn seam() -> Mesh {
    let corner = |x: f32, y: f32| Vec3::new(x, y, 0.0);
    let left = [corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0)];
    let right = [corner(1.0, 0.0), corner(2.0, 0.0), corner(1.0, 1.0)];
    let loose = [corner(1.0, -0.0), corner(5.0, 5.0)];
    let positions = [&left[..], &loose[..], &right[..]].concat();
    Mesh::build(PolygonSoup::new(positions, &[[0, 1, 2], [5, 6, 7]])).expect("small").mesh
}

#[test]
fn vertices_at_one_place_and_in_no_face_stay_as_they_are() {
    for format in both() {
        assert_eq!(formats::losses(format, &model("", &[("a", &seam())])), [""; 0]);
        let import = read(&common::write(format, &seam())).expect("readable");
        assert!(import.report.is_clean(), "{}", import.report);
        assert!(mesh(&import) == &seam(), "{format:?}");
    }
    // Only files that need it have the attribute, and in ways that the format allows.
    let json = |mesh: &Mesh| common::text(&common::write(by_code("gltf"), mesh)[0]).to_owned();
    assert!(!json(&octahedron()).contains("_VERTEX_ID"));
    assert!(
        json(&seam()).contains("{\"bufferView\":1,\"componentType\":5121,\"count\":8,\"type\":\"VEC4\"}")
    );
    // Of another kind it is somebody else's and tells nothing.
    let other = json(&seam()).replace("\"_VERTEX_ID\":1", "\"_VERTEX_ID\":0");
    let mut files = common::write(by_code("gltf"), &seam());
    files[0].bytes = other.into_bytes();
    assert_eq!(mesh(&read(&files).expect("readable")).vertex_count(), 5);
}

#[test]
fn empty_meshes_and_points_alone_come_back() {
    let points = Mesh::build(PolygonSoup::new(vec![Vec3::X, Vec3::Y], &[[0u32; 0]; 0])).expect("small").mesh;
    for format in both() {
        for one in [&Mesh::new(), &points] {
            let import = read(&common::write(format, one)).expect("readable");
            assert!(import.report.is_clean(), "{}", import.report);
            assert!(mesh(&import) == one, "{format:?}");
        }
        let (full, empty) = (octahedron(), Mesh::new());
        let objects = [("full", &full), ("empty", &empty), ("points", &points)];
        let import = read(&formats::write(format, &model("x", &objects)).expect("small")).expect("readable");
        let found: Vec<_> =
            import.model.objects.iter().map(|o| (o.name.as_str(), o.mesh.vertex_count())).collect();
        assert_eq!(found, [("full", 6), ("empty", 0), ("points", 2)]);
    }
    // Points of other writers are vertices too; a scene of nothing but cameras is no model.
    let import = read(&[NamedBytes::new("a.gltf", document("", ",\"mode\":0"))]).expect("readable");
    assert_eq!((mesh(&import).vertex_count(), import.report.is_clean()), (4, true));
    let cameras = "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"camera\":0}]}";
    let error = read(&[NamedBytes::new("a.gltf", cameras)]).expect_err("nothing").to_string();
    assert!(error.contains("holds no mesh"), "{error}");
}

#[test]
fn colours_and_materials_come_back_by_face() {
    let mut mesh_in = octahedron();
    let colors: Vec<Color> =
        (0..8u8).map(|i| if i == 3 { Color::UNPAINTED } else { Color([i * 36, 255 - i, 128]) }).collect();
    let material =
        Column::with_values(keys::FACE_MATERIAL, vec![0, 0, 0, halfedge::NONE, 1, 1, halfedge::NONE, 0]);
    mesh_in
        .insert_column(Element::Face, Column { labels: vec!["wood".into(), "tin \"x\"".into()], ..material });
    mesh_in.insert_column(Element::Face, Column::with_values(keys::FACE_COLOR, colors));
    for format in both() {
        let files = formats::write(format, &model("x", &[("a", &mesh_in)])).expect("small");
        let import = read(&files).expect("readable");
        let back = mesh(&import);
        // Faces are grouped by material: compare by the places of their corners.
        let list = |mesh: &Mesh| {
            let labels = &mesh.column(Element::Face, "material").expect("kept").labels;
            let mut faces: Vec<_> = mesh
                .faces()
                .map(|f| {
                    let corners: Vec<_> = mesh
                        .face_vertices(f)
                        .map(|v| mesh.position(v).to_array().map(f32::to_bits))
                        .collect();
                    let label = labels.get(mesh.get(keys::FACE_MATERIAL, f.index()) as usize).cloned();
                    (corners, mesh.get(keys::FACE_COLOR, f.index()).0, label)
                })
                .collect();
            faces.sort();
            faces
        };
        assert_eq!(list(back), list(&mesh_in), "{format:?}");
    }
}

#[test]
fn every_colour_survives_linear_light() {
    let positions = (0..300).map(|i| Vec3::new(i as f32, (i % 2) as f32, 0.0)).collect();
    let faces: Vec<[u32; 3]> =
        (0..256).map(|i| if i % 2 == 0 { [i, i + 1, i + 2] } else { [i + 1, i, i + 2] }).collect();
    let mut mesh_in = Mesh::build(PolygonSoup::new(positions, &faces)).expect("small").mesh;
    let colors: Vec<Color> = (0..=255u8).map(|i| Color([i, 255 - i, i / 2])).collect();
    mesh_in.insert_column(Element::Face, Column::with_values(keys::FACE_COLOR, colors.clone()));
    let files = formats::write(by_code("glb"), &model("x", &[("a", &mesh_in)])).expect("small");
    let import = read(&files).expect("readable");
    assert_eq!(mesh(&import).attribute(keys::FACE_COLOR), Some(&colors[..]));
    assert_eq!(mesh(&import).attribute(keys::FACE_MATERIAL), None);
}

/// A square of two triangles in a data address, 16-bit indices, with this scene.
fn document(scene: &str, mode: &str) -> String {
    let mut bin = Vec::new();
    for position in [[0f32, 0., 0.], [1., 0., 0.], [0., 1., 0.], [1., 1., 0.]] {
        position.iter().for_each(|c| bin.extend(c.to_le_bytes()));
    }
    [0u16, 1, 2, 2, 1, 3].iter().for_each(|i| bin.extend(i.to_le_bytes()));
    use base64::Engine;
    let data = base64::engine::general_purpose::STANDARD.encode(&bin);
    format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},\"buffers\":[{{\"byteLength\":60,\"uri\":\"data:application/octet-stream;base64,{data}\"}}],\
         \"bufferViews\":[{{\"buffer\":0,\"byteLength\":48}},{{\"buffer\":0,\"byteOffset\":48,\"byteLength\":12}}],\
         \"accessors\":[{{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"}},{{\"bufferView\":1,\"componentType\":5123,\"count\":6,\"type\":\"SCALAR\"}}],\
         \"meshes\":[{{\"primitives\":[{{\"attributes\":{{\"POSITION\":0}}{mode}}}]}}]{scene}}}"
    )
}

#[test]
fn nodes_place_meshes_and_modes_are_read() {
    let scene = ",\"scene\":0,\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"name\":\"up\",\"translation\":[0,0,5],\"rotation\":[0,0,0.7071067811865476,0.7071067811865476],\"children\":[1,2]},{\"mesh\":0,\"scale\":[2,2,2]},{\"mesh\":0,\"name\":\"m\",\"matrix\":[1,0,0,0,0,1,0,0,0,0,1,0,1,2,3,1]}]";
    let import = read(&[NamedBytes::new("a", document(scene, ",\"indices\":1"))]).expect("readable");
    assert_eq!(import.model.objects.iter().map(|o| o.name.as_str()).collect::<Vec<_>>(), ["mesh 0", "m"]);
    let at = |object: usize| import.model.objects[object].mesh.position(VertexId::new(1));
    assert!(at(0).distance(Vec3::new(0.0, 2.0, 5.0)) < 1e-6, "{}", at(0));
    assert!(at(1).distance(Vec3::new(-2.0, 2.0, 8.0)) < 1e-6, "{}", at(1));
    for (mode, faces) in [("", 1), (",\"indices\":1", 2), (",\"mode\":5", 2), (",\"mode\":6", 2)] {
        let import = read(&[NamedBytes::new("a.gltf", document("", mode))]).expect("readable");
        assert_eq!(mesh(&import).face_count(), faces, "{mode}");
        assert!(import.report.is_clean(), "{}", import.report);
    }
}

#[test]
fn nodes_that_mirror_turn_faces_round() {
    let text = |nodes: &str| {
        let mut files = common::write(by_code("gltf"), &common::tetrahedron());
        let mut json: serde_json::Value = serde_json::from_slice(&files[0].bytes).expect("JSON");
        json["asset"] = serde_json::json!({ "version": "2.0" });
        json["nodes"] = serde_json::from_str(nodes).expect("JSON");
        files[0].bytes = json.to_string().into_bytes();
        read(&files).expect("readable").model.objects.remove(0).mesh
    };
    for (nodes, sign) in [
        (r#"[{"mesh":0,"scale":[-1,1,1]}]"#, Vec3::new(-1.0, 1.0, 1.0)),
        (r#"[{"mesh":0,"scale":[-1,-1,1]}]"#, Vec3::new(-1.0, -1.0, 1.0)),
        (r#"[{"mesh":0,"matrix":[1,0,0,0, 0,1,0,0, 0,0,-1,0, 0,0,0,1]}]"#, Vec3::new(1.0, 1.0, -1.0)),
        // In a node, and mirrored again in it.
        (r#"[{"children":[1],"scale":[1,-1,1]},{"mesh":0}]"#, Vec3::new(1.0, -1.0, 1.0)),
        (r#"[{"children":[1],"scale":[1,-1,1]},{"mesh":0,"scale":[-1,1,1]}]"#, Vec3::new(-1.0, -1.0, 1.0)),
    ] {
        common::check_tetrahedron(&text(nodes), |p| p * sign);
    }
}

#[test]
fn colours_of_vertices_come_back_to_the_bit() {
    let positions = (0..256).map(|i| Vec3::new(i as f32, (i * i) as f32, 0.0)).collect();
    let faces: Vec<[u32; 3]> = (0..254).map(|i| [i, i + 1, i + 2]).collect();
    let mut mesh_in = Mesh::build(PolygonSoup::new(positions, &faces)).expect("small").mesh;
    let colors: Vec<Vec3> =
        (0..=255u8).map(|i| Vec3::new(f32::from(i), f32::from(255 - i), f32::from(i / 2)) / 255.0).collect();
    mesh_in.insert_column(Element::Vertex, Column::with_values(keys::VERTEX_COLOR, colors.clone()));
    for format in both() {
        let import = read(&common::write(format, &mesh_in)).expect("readable");
        assert_eq!(mesh(&import).attribute(keys::VERTEX_COLOR), Some(&colors[..]), "{format:?}");
    }
}

fn shared_triangle_models_round_trip() {
    for path in fixtures::shared_files("models/common", "obj") {
        let original = read(&[load(&path)]).expect("readable");
        let original = &original.model.objects[0].mesh;
        let lost = formats::losses(by_code("glb"), &model("", &[("", original)])).join("");
        if lost.contains("polygon")
            || lost.contains("vertices without faces")
            || original.attribute(keys::FACE_MATERIAL).is_some()
        {
            continue;
        }
        let files = formats::write(by_code("glb"), &model("x", &[("m", original)])).expect("small");
        let import = read(&files).expect("readable");
        let places = |mesh: &Mesh| -> Vec<Vec<[u32; 3]>> {
            let place = |v| (mesh.position(v) + Vec3::ZERO).to_array().map(f32::to_bits);
            mesh.faces().map(|f| mesh.face_vertices(f).map(place).collect()).collect()
        };
        if import.report.is_clean() {
            assert!(places(mesh(&import)) == places(original), "{}", path.display());
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn damaged_data_never_panics(
        is_draco in any::<bool>(),
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..8),
    ) {
        let mut file = common::case_file(if is_draco { "gltf-draco.glb" } else { "gltf-meshopt.glb" });
        // The JSON stays as it is, so that damaged data is decoded.
        let json = u32::from_le_bytes(*file.bytes[12..].first_chunk().expect("a length")) as usize;
        for (at, value) in edits {
            let data = &mut file.bytes[28 + json..];
            let at = at.index(data.len());
            data[at] = value;
        }
        if let Ok(import) = read(&[file]) {
            mesh(&import);
        }
    }

    #[test]
    fn damaged_files_never_panic(
        binary in any::<bool>(),
        edits in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>(), 0u8..4), 1..6),
    ) {
        let mesh_in = octahedron();
        let mut bytes = if binary {
            formats::write(by_code("glb"), &model("x", &[("a", &mesh_in)])).expect("small").remove(0).bytes
        } else {
            document(",\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}]", ",\"indices\":1").into_bytes()
        };
        for (at, value, kind) in edits {
            if bytes.is_empty() {
                break;
            }
            let at = at.index(bytes.len());
            match kind {
                0 => bytes[at] = value,
                1 => bytes[at] = b"0123456789-.e\"{}[],:"[usize::from(value) % 20],
                2 => { bytes.remove(at); }
                _ => bytes.insert(at, b"0123456789-.e\"{}[],:"[usize::from(value) % 20]),
            }
        }
        for name in ["a.gltf", "a.glb"] {
            if let Ok(import) = read(&[NamedBytes::new(name, bytes.clone())]) {
                for object in &import.model.objects {
                    object.mesh.validate().expect("valid");
                }
            }
        }
    }
}
