//! Further contents of documents: scenes, types of numbers, colours, compression, and content that is not
//! kept.

use super::build::{Doc, SQUARE};
use super::common::{by_code, mesh, read};
use formats::Import;
use glam::Vec3;
use halfedge::keys;
use meshoptimizer_rs::Workspace;
use meshoptimizer_rs::codec::{
    IndexEncoding, VertexEncoding, encode_index_buffer, encode_index_sequence, encode_vertex_buffer,
};
use serde_json::json;

fn open(doc: &Doc) -> Import {
    let import = read(&[doc.file()]).unwrap_or_else(|error| panic!("{error}"));
    for object in &import.model.objects {
        object.mesh.validate().expect("a valid mesh");
    }
    import
}

fn names(import: &Import) -> Vec<&str> {
    import.model.objects.iter().map(|object| object.name.as_str()).collect()
}

#[test]
fn the_scene_decides_what_is_shown() {
    let mut doc = Doc::square();
    doc.json["nodes"] =
        json!([{ "mesh": 0, "name": "a" }, { "name": "group", "children": [2] }, { "mesh": 0, "name": "b" }]);
    assert_eq!(names(&open(&doc)), ["a", "b"], "no scene: all nodes");
    doc.json["scenes"] = json!([{ "nodes": [0] }, { "nodes": [1], "name": "second" }]);
    let import = open(&doc);
    assert_eq!(names(&import), ["a"]);
    let report = import.report.to_string();
    assert!(report.contains("1 scene besides the one shown: scene \"second\""), "{report}");
    doc.json["scene"] = json!(1);
    doc.push("meshes", doc.json["meshes"][0].clone());
    doc.json["meshes"][1]["name"] = json!("unused");
    let import = open(&doc);
    assert_eq!(names(&import), ["b"]);
    let report = import.report.to_string();
    assert!(report.contains("mesh \"unused\", which the scene doesn't show"), "{report}");
    assert!(report.contains("1 node of the scene without a mesh not kept"), "{report}");
    // Nothing shown: the meshes as they are.
    doc.json["scenes"] = json!([{ "nodes": [] }]);
    let import = open(&doc);
    assert_eq!(names(&import), ["square", "unused"]);
    assert!(import.report.to_string().contains("the meshes are taken as they are"), "{}", import.report);
}

#[test]
fn what_is_not_kept_is_named() {
    let mut doc = Doc::square();
    doc.json["animations"] = json!([{}, {}]);
    doc.json["cameras"] = json!([{}]);
    doc.json["extensions"] = json!({ "KHR_lights_punctual": { "lights": [{}, {}, {}] } });
    doc.json["extensionsUsed"] = json!(["KHR_lights_punctual"]);
    let rows = doc.floats("VEC4", &[0.0; 16]);
    let attributes = &mut doc.json["meshes"][0]["primitives"][0]["attributes"];
    for name in ["TANGENT", "_TEMPERATURE", "COLOR_1"] {
        attributes[name] = json!(rows);
    }
    let report = open(&doc).report.to_string();
    for says in [
        "Not kept: 2 animations, 1 camera, 3 lights",
        "Tangents are not kept",
        "mesh \"square\": COLOR_1, _TEMPERATURE left out",
    ] {
        assert!(report.contains(says), "{report} instead of {says}");
    }
    assert!(!report.contains("KHR_lights_punctual"), "{report}");
}

#[test]
fn lines_alone_leave_their_vertices() {
    let mut doc = Doc::square();
    doc.json["meshes"][0]["primitives"][0]["mode"] = json!(1);
    let import = open(&doc);
    assert_eq!((mesh(&import).vertex_count(), mesh(&import).face_count()), (4, 0));
    let says = "mesh \"square\": 1 set of lines, whose vertices are kept; only faces are edited here";
    assert!(import.report.to_string().contains(says), "{}", import.report);
    // Beside faces they are left out.
    doc.push("accessors", doc.json["accessors"][0].clone());
    let faces = json!({ "attributes": { "POSITION": 2 }, "indices": 1 });
    doc.json["meshes"][0]["primitives"].as_array_mut().expect("a list").push(faces);
    let import = open(&doc);
    assert_eq!((mesh(&import).vertex_count(), mesh(&import).face_count()), (4, 2));
    assert!(import.report.to_string().contains("1 set of lines; only faces"), "{}", import.report);
}

#[test]
fn every_type_of_numbers_is_read() {
    // Twice the square's coordinates in each type, and normalised ones.
    for (component, size, full) in [
        (5120, 1, 127.0),
        (5121, 1, 255.0),
        (5122, 2, 32_767.0),
        (5123, 2, 65_535.0),
        (5124, 4, 2_147_483_647.0),
        (5125, 4, 4_294_967_295.0),
        (5126, 4, 1.0),
        (5130, 8, 1.0),
    ] {
        for is_normalized in [false, true] {
            let value = |coordinate: f32| {
                if is_normalized { f64::from(coordinate) * full } else { f64::from(coordinate) * 2.0 }
            };
            let bytes: Vec<u8> = SQUARE
                .as_flattened()
                .iter()
                .flat_map(|&coordinate| {
                    let value = value(coordinate);
                    match component {
                        5126 => (value as f32).to_le_bytes().to_vec(),
                        5130 => value.to_le_bytes().to_vec(),
                        _ => (value as u64).to_le_bytes()[..size].to_vec(),
                    }
                })
                .collect();
            let mut doc = Doc::square();
            let view = doc.view(&bytes);
            doc.json["accessors"][0] = json!({ "bufferView": view, "componentType": component, "normalized": is_normalized, "count": 4, "type": "VEC3" });
            let factor = if is_normalized { 1.0 } else { 2.0 };
            let expected = SQUARE.map(|position| Vec3::from(position) * factor);
            assert_eq!(mesh(&open(&doc)).positions(), expected, "{component}");
        }
    }
}

#[test]
fn interleaved_rows_are_read() {
    let mut doc = Doc::square();
    let rows: Vec<u8> =
        SQUARE.iter().flat_map(|p| [p[0], p[1], p[2], 9.0, 9.0]).flat_map(f32::to_le_bytes).collect();
    let view = doc.view(&rows);
    doc.json["bufferViews"][view]["byteStride"] = json!(20);
    doc.json["accessors"][0]["bufferView"] = json!(view);
    assert_eq!(mesh(&open(&doc)).positions(), SQUARE.map(Vec3::from));
}

/// The square as two triangles with vertices of their own, with these colours of the six.
fn colored(colors: &[f32], kind: &str) -> Import {
    let mut doc = Doc::new();
    let corners: Vec<f32> =
        super::build::SQUARE_INDICES.iter().flat_map(|&i| SQUARE[usize::from(i)]).collect();
    let (positions, colors) = (doc.floats("VEC3", &corners), doc.floats(kind, colors));
    doc.push("meshes", json!({ "name": "m", "primitives": [{ "attributes": { "POSITION": positions, "COLOR_0": colors } }] }));
    open(&doc)
}

#[test]
fn colours_of_corners_become_those_of_vertices_or_faces() {
    let rgb = |colors: [f32; 6]| colored(&colors.map(|c| [c; 3]).concat(), "VEC3");
    // Vertices 0 and 2 are in both triangles.
    let import = rgb([0.0, 1.0, 0.0, 0.0, 0.0, 1.0]);
    assert_eq!(mesh(&import).vertex_count(), 4, "one vertex for each place");
    let expected = [0.0, 1.0, 0.0, 1.0].map(Vec3::splat);
    assert_eq!(mesh(&import).attribute(keys::VERTEX_COLOR), Some(&expected[..]));
    assert!(import.report.is_clean(), "{}", import.report);
    let import = rgb([0.0, 0.0, 0.0, 1.0, 1.0, 1.0]);
    assert_eq!(mesh(&import).vertex_count(), 4);
    let colors = mesh(&import).attribute(keys::FACE_COLOR).expect("colours of faces");
    assert_eq!(colors.iter().map(|color| color.0[0]).collect::<Vec<_>>(), [0, 255]);
    assert!(import.report.is_clean(), "{}", import.report);
    let import = rgb([0.0, 0.0, 1.0, 1.0, 0.0, 0.0]);
    let expected = [0.5, 0.0, 0.5, 0.0].map(Vec3::splat);
    assert_eq!(mesh(&import).attribute(keys::VERTEX_COLOR), Some(&expected[..]));
    assert!(
        import
            .report
            .to_string()
            .contains("mesh \"m\": vertices whose corners have different colours have the mean"),
        "{}",
        import.report
    );
    let import = colored(&[1.0, 1.0, 1.0, 0.5].repeat(6), "VEC4");
    assert!(
        import.report.to_string().contains("mesh \"m\": the alpha of colours is left out"),
        "{}",
        import.report
    );
}

/// The square with its views compressed by both versions of the codec.
fn compressed(extension: &str, version: u8) -> Doc {
    let mut workspace = Workspace::default();
    let mut doc = Doc::square();
    let positions: Vec<u8> = SQUARE.as_flattened().iter().flat_map(|c| c.to_le_bytes()).collect();
    let vertices = VertexEncoding::new(version, 2).expect("a version");
    let positions = encode_vertex_buffer(&positions, 4, 12, vertices, &mut workspace).expect("small");
    let indices: [u32; 6] = super::build::SQUARE_INDICES.map(u32::from);
    let indices = if version == 0 {
        ("TRIANGLES", encode_index_buffer(&indices, IndexEncoding::DEFAULT, &mut workspace).expect("small"))
    } else {
        ("INDICES", encode_index_sequence(&indices, IndexEncoding::DEFAULT, &mut workspace).expect("small"))
    };
    let views = [("ATTRIBUTES", positions, 12, 4), (indices.0, indices.1, 2, 6)];
    for (i, (mode, bytes, stride, count)) in views.into_iter().enumerate() {
        let view = doc.view(&bytes);
        let place = doc.json["bufferViews"][view].clone();
        doc.json["bufferViews"][i] = json!({
            "buffer": 1, "byteLength": stride * count,
            "extensions": { extension: {
                "buffer": 0, "byteOffset": place["byteOffset"], "byteLength": place["byteLength"],
                "byteStride": stride, "count": count, "mode": mode,
            } },
        });
    }
    doc
}

#[test]
fn views_compressed_by_meshoptimizer_are_decoded() {
    for (version, extension) in [(0, "EXT_meshopt_compression"), (1, "KHR_meshopt_compression")] {
        let import = open(&compressed(extension, version));
        assert_eq!(mesh(&import).positions(), SQUARE.map(Vec3::from), "{extension}");
        assert_eq!(mesh(&import).face_count(), 2, "{extension}");
        assert!(import.report.is_clean(), "{}", import.report);
        for (key, value, says) in [
            ("mode", json!("FAST"), "its compression \"FAST\" is unknown"),
            ("filter", json!("BLUR"), "its compression filter \"BLUR\" is unknown"),
            ("count", json!(400), "its compressed data can't be read"),
            ("count", json!(4_000_000_000u32), "its compressed data can't be read"),
            ("byteStride", json!(13), "its compressed data can't be read"),
        ] {
            let mut doc = compressed(extension, version);
            doc.json["bufferViews"][0]["extensions"][extension][key] = value;
            let error = read(&[doc.file()]).expect_err("nothing to show").to_string();
            assert!(error.contains(says), "{error} instead of {says}");
        }
    }
}

#[test]
fn an_uncompressed_copy_is_read_where_the_compressed_data_cannot_be() {
    let mut doc = compressed("EXT_meshopt_compression", 0);
    for view in 0..2 {
        let plain = Doc::square().json["bufferViews"][view].clone();
        let extension = &mut doc.json["bufferViews"][view];
        extension["buffer"] = json!(0);
        extension["byteOffset"] = plain["byteOffset"].clone();
        extension["extensions"]["EXT_meshopt_compression"]["mode"] = json!("FAST");
    }
    assert_eq!(mesh(&open(&doc)).face_count(), 2);
    let mut doc = Doc::square();
    let junk = doc.view(b"DRACO");
    doc.json["meshes"][0]["primitives"][0]["extensions"] =
        json!({ "KHR_draco_mesh_compression": { "bufferView": junk, "attributes": { "POSITION": 0 } } });
    let import = open(&doc);
    assert_eq!(mesh(&import).face_count(), 2);
    assert!(import.report.to_string().contains("an uncompressed copy was read"), "{}", import.report);
}

#[test]
fn normals_of_some_corners_are_lost_and_named() {
    let mut doc = Doc::square();
    let normals = doc.floats("VEC3", &[0.0, 0.0, 1.0].repeat(3));
    doc.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = json!(normals);
    let import = open(&doc);
    let lost = "glTF holds normals of all corners of a mesh or of none: those of 5 corners are lost";
    assert_eq!(formats::losses(by_code("glb"), &import.model), [lost]);
    let back = read(&formats::write(by_code("glb"), &import.model).expect("small")).expect("readable");
    assert_eq!(mesh(&back).attribute(keys::CORNER_NORMAL), None);
}

#[test]
fn several_primitives_share_vertices() {
    let mut doc = Doc::square();
    let first = doc.shorts("SCALAR", &[0, 1, 2]);
    let second = doc.shorts("SCALAR", &[0, 2, 3]);
    let primitive = |indices: usize| json!({ "attributes": { "POSITION": 0 }, "indices": indices });
    doc.json["meshes"][0]["primitives"] = json!([primitive(first), primitive(second)]);
    let import = open(&doc);
    assert_eq!((mesh(&import).vertex_count(), mesh(&import).face_count()), (4, 2));
    let back = read(&formats::write(by_code("glb"), &import.model).expect("small")).expect("readable");
    assert!(mesh(&back) == mesh(&import));
}
