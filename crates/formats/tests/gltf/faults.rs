//! Faulty and hostile documents: what can be read is read, and the rest is named.

use super::build::Doc;
use super::common::{case_file, mesh, read};
use formats::{Import, NamedBytes};
use glam::Vec3;
use halfedge::keys;
use serde_json::{Value, json};

fn open(doc: &Doc) -> Import {
    let import = read(&[doc.file()]).unwrap_or_else(|error| panic!("{error}"));
    for object in &import.model.objects {
        object.mesh.validate().expect("a valid mesh");
    }
    import
}

fn refusal(doc: &Doc) -> String {
    read(&[doc.file()]).expect_err("nothing to show").to_string()
}

/// Two nodes, each with the square; the second one's document is changed by `change`.
fn beside_a_good_one(change: impl Fn(&mut Doc)) -> Import {
    let mut doc = Doc::square();
    doc.push("meshes", doc.json["meshes"][0].clone());
    doc.json["meshes"][1]["name"] = json!("other");
    doc.push("nodes", json!({ "mesh": 1, "name": "second" }));
    change(&mut doc);
    open(&doc)
}

#[test]
fn a_fault_in_a_node_costs_no_other() {
    for (node, says) in [
        (json!({ "mesh": 1, "matrix": [1, 0, 0] }), "its \"matrix\" is not 16 numbers"),
        (json!({ "mesh": 1, "translation": ["x", 0, 0] }), "its \"translation\" is not 3 numbers"),
        (json!({ "mesh": 1, "scale": [1e300, 1, 1], "name": "huge" }), ""),
        (json!({ "mesh": 7, "name": "lost" }), "what node \"lost\" shows: mesh 7 doesn't exist"),
        (json!({ "mesh": -1 }), "its \"mesh\" is not a whole number"),
        (json!({ "children": [1] , "name": "round"}), "node \"round\" where it is in the scene again"),
        (json!({ "children": [9] }), "node 9 doesn't exist"),
    ] {
        let import = beside_a_good_one(|doc| {
            doc.json["nodes"][1] = node.clone();
            doc.json["scenes"] = json!([{ "nodes": [0, 1] }]);
        });
        let first = &import.model.objects[0].mesh;
        assert_eq!((first.vertex_count(), first.face_count()), (4, 2), "{node}");
        assert!(import.report.to_string().contains(says), "{} instead of {says}", import.report);
        assert!(says.is_empty() || !import.report.is_clean());
    }
}

#[test]
fn a_fault_in_a_primitive_costs_no_other() {
    for (primitive, says) in [
        (json!({ "attributes": {} }), "it has no positions"),
        (json!({ "attributes": { "POSITION": 9 } }), "accessor 9 doesn't exist"),
        (json!({ "attributes": { "POSITION": 0 }, "indices": "x" }), "its \"indices\" is not a whole number"),
        (json!({ "attributes": { "POSITION": 0 }, "mode": 7 }), "its mode 7 is unknown"),
        (json!({ "attributes": { "POSITION": 2 } }), "accessor 2, its component type 99 is unknown"),
        (json!({ "attributes": { "POSITION": 3 } }), "accessor 3, its type is none of"),
        (json!({ "attributes": { "POSITION": 4 } }), "in accessor 4, its data lies outside its buffer"),
        (json!({ "attributes": { "POSITION": 5 } }), "accessor 5, buffer view 50 doesn't exist"),
        (json!({ "attributes": { "POSITION": 6 } }), "accessor 6, its sparse \"indices\" are missing"),
        (json!({ "attributes": { "POSITION": 7 } }), "accessor 7, its rows overlap"),
        (json!({ "attributes": { "POSITION": 8 } }), "buffer 1: which was not given"),
        (json!(7), "it has no positions"),
        (json!({ "attributes": { "POSITION": 0 }, "mode": 3 }), "1 set of lines"),
    ] {
        let import = beside_a_good_one(|doc| {
            let vec3 = |rest: Value| {
                let mut accessor =
                    json!({ "bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3" });
                accessor.as_object_mut().expect("one").extend(rest.as_object().expect("one").clone());
                accessor
            };
            doc.push("accessors", vec3(json!({ "componentType": 99 })));
            doc.push("accessors", vec3(json!({ "type": "MAT3" })));
            doc.push("accessors", vec3(json!({ "byteOffset": 1e6 })));
            doc.push("accessors", vec3(json!({ "bufferView": 50 })));
            doc.push("accessors", vec3(json!({ "sparse": { "count": 1 } })));
            let narrow = json!({ "buffer": 0, "byteLength": 48, "byteStride": 4 });
            let narrow = doc.push("bufferViews", narrow);
            doc.push("accessors", vec3(json!({ "bufferView": narrow })));
            let elsewhere = doc.push("bufferViews", json!({ "buffer": 1, "byteLength": 48 }));
            doc.push("accessors", vec3(json!({ "bufferView": elsewhere })));
            let list = doc.json["meshes"][1]["primitives"].as_array_mut().expect("a list");
            list.push(primitive.clone());
        });
        assert_eq!(import.model.objects.len(), 2);
        for object in &import.model.objects {
            assert_eq!((object.mesh.vertex_count(), object.mesh.face_count()), (4, 2), "{primitive}");
        }
        let expected = says.split_once("buffer 1: ").map_or(says, |_| "buffer 1 doesn't exist");
        assert!(import.report.to_string().contains(expected), "{} instead of {says}", import.report);
    }
}

#[test]
fn a_fault_in_an_attribute_costs_that_alone() {
    for (name, accessor, says) in [
        ("NORMAL", json!(99), "NORMAL left out (accessor 99 doesn't exist)"),
        ("TEXCOORD_0", json!("x"), "its \"TEXCOORD_0\" is not a whole number"),
        ("COLOR_0", json!(2), "COLOR_0 left out (in accessor 2, its data lies outside its buffer)"),
    ] {
        let mut doc = Doc::square();
        doc.push(
            "accessors",
            json!({ "bufferView": 0, "byteOffset": 999, "componentType": 5126, "count": 4, "type": "VEC3" }),
        );
        doc.json["meshes"][0]["primitives"][0]["attributes"][name] = accessor;
        let import = open(&doc);
        assert_eq!(mesh(&import).face_count(), 2, "{name}");
        assert!(import.report.to_string().contains(says), "{} instead of {says}", import.report);
    }
    // Rows that are missing at the end leave their corners without a value.
    let mut doc = Doc::square();
    let uvs = doc.floats("VEC2", &[0.0, 0.0, 1.0, 0.0, 1.0, 1.0]);
    doc.json["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = json!(uvs);
    let import = open(&doc);
    let uvs = mesh(&import).attribute(keys::CORNER_UV).expect("uvs");
    let without = mesh(&import).halfedges().filter(|&h| !mesh(&import).is_boundary_halfedge(h));
    assert_eq!(without.filter(|h| uvs[h.index()].is_nan()).count(), 1);
}

#[test]
fn what_reaches_beyond_the_data_is_left_out() {
    let mut doc = Doc::square();
    doc.json["accessors"][0]["count"] = json!(3);
    let import = open(&doc);
    assert_eq!((mesh(&import).vertex_count(), mesh(&import).face_count()), (3, 1));
    let says = "mesh \"square\": 1 triangle refers to others than its 3 vertices";
    assert!(import.report.to_string().contains(says), "{}", import.report);
    // Counts that the data is too short for.
    let mut doc = Doc::square();
    doc.json["accessors"][1]["count"] = json!(4_000_000_000_000u64);
    doc.json["bufferViews"][1]["byteLength"] = json!(10);
    let import = open(&doc);
    assert_eq!(mesh(&import).face_count(), 1);
    assert!(import.report.to_string().contains("indices lie outside their buffer"), "{}", import.report);
    // A binary file that was cut off.
    let mut doc = Doc::square();
    let spare = doc.view(&[0; 100]);
    let files = formats::write(super::by_code("glb"), &open(&doc).model).expect("small");
    let whole = &files[0].bytes;
    let import = read(&[NamedBytes::new("a.glb", &whole[..whole.len() - 12])]).expect("readable");
    assert_eq!(mesh(&import).face_count(), 1, "{spare}");
    assert!(import.report.to_string().contains("the last 12 bytes of its data"), "{}", import.report);
}

#[test]
fn what_cannot_be_read_at_all_says_why() {
    let change = |change: &dyn Fn(&mut Value)| {
        let mut doc = Doc::square();
        change(&mut doc.json);
        refusal(&doc)
    };
    for (error, says) in [
        (change(&|json| json["accessors"][0]["bufferView"] = json!(7)), "buffer view 7 doesn't exist"),
        (change(&|json| json["bufferViews"][0]["buffer"] = json!(7)), "buffer 7 doesn't exist"),
        (change(&|json| json["meshes"] = json!([])), "what node 0 shows: mesh 0 doesn't exist"),
        (change(&|json| json["meshes"] = json!(3)), "mesh 0 doesn't exist"),
        (change(&|json| json["meshes"][0]["primitives"] = json!([])), "it has no primitives"),
        (
            change(&|json| {
                json["accessors"][0] = json!({ "componentType": 5126, "type": "VEC3", "count": 5e9 })
            }),
            "promises more",
        ),
        (change(&|json| json["asset"]["version"] = json!("1.1")), "glTF 1.1. Meshwright reads version 2"),
        (change(&|json| json["asset"] = json!({ "version": "3.0" })), "glTF 3.0. Meshwright reads version 2"),
        (change(&|json| json["asset"] = json!({ "version": 1.0 })), "glTF 1.0. Meshwright reads version 2"),
    ] {
        assert!(error.contains(says), "{error} instead of {says}");
    }
    let refused =
        |name: &str, bytes: &[u8]| read(&[NamedBytes::new(name, bytes)]).expect_err("no glTF").to_string();
    let text = String::from_utf8(Doc::square().file().bytes).expect("JSON");
    for (text, says) in [
        (text.replace("base64,", "base65,"), "not in base64"),
        (
            text.replace("\"data:", "\"x/some%20data.bin\",\"z\":\""),
            "Could not open a.gltf. Open it together with x/some data.bin, which holds its data and was not given.",
        ),
        (text[..text.len() / 2].to_owned(), "JSON can't be read"),
        (format!("{{\"asset\":{}", "[".repeat(100_000)), "JSON can't be read"),
        ("[]".to_owned(), "It is not a glTF file: "),
    ] {
        let error = refused("a.gltf", text.as_bytes());
        assert!(error.contains(says), "{error} instead of {says}");
    }
    assert!(refused("a.glb", b"glTF\x01\0\0\0").contains("glTF 1.0. Meshwright reads version 2"));
    assert!(refused("a.glb", b"glTF\x02\0").contains("ends in its header"));
    assert!(refused("a.glb", b"glTF\x02\0\0\0\x10\0\0\0").contains("has no JSON chunk"));
}

#[test]
fn text_may_be_utf_16_or_padded() {
    let text = String::from_utf8(Doc::square().file().bytes).expect("JSON");
    let utf16: Vec<u8> = text.encode_utf16().flat_map(u16::to_le_bytes).collect();
    let marked = [b"\xff\xfe".as_slice(), &utf16].concat();
    for bytes in [utf16, marked, format!("\u{feff}{text}").into_bytes(), format!("{text} \0\0").into_bytes()]
    {
        let import = read(&[NamedBytes::new("a", bytes)]).expect("readable");
        assert_eq!(mesh(&import).face_count(), 2);
        assert!(import.report.is_clean(), "{}", import.report);
    }
}

#[test]
fn meshes_repeated_without_end_stop_at_some_number() {
    let mut doc = Doc::square();
    let big = doc.json["accessors"].as_array().expect("a list").len();
    doc.push("accessors", json!({ "componentType": 5126, "type": "VEC3", "count": 1_000_000 }));
    doc.json["meshes"][0]["primitives"][0] = json!({ "attributes": { "POSITION": big }, "mode": 0 });
    for _ in 0..20 {
        doc.push("nodes", json!({ "mesh": 0 }));
    }
    let import = open(&doc);
    assert!(import.model.objects.len() < 10, "{}", import.model.objects.len());
    assert!(import.report.to_string().contains("repeats its meshes too many times"), "{}", import.report);
}

#[test]
fn unknown_required_extensions_are_named() {
    let mut doc = Doc::square();
    doc.json["extensionsRequired"] =
        json!(["ACME_shapes", "KHR_materials_clearcoat", "KHR_mesh_quantization"]);
    doc.json["extensionsUsed"] = json!(["ACME_shapes", "ACME_notes", "KHR_materials_clearcoat"]);
    let import = open(&doc);
    assert_eq!(mesh(&import).face_count(), 2);
    let warnings: Vec<&str> = import.report.warnings().collect();
    assert!(warnings.len() == 1 && warnings[0].contains("ACME_shapes"), "{warnings:?}");
    let kept = "The content of extensions is not kept: ACME_notes, KHR_materials_clearcoat";
    assert!(import.report.to_string().contains(kept), "{}", import.report);
}

#[test]
fn damaged_compressed_data_is_named() {
    for (name, says) in [
        ("gltf-meshopt.glb", "compressed data can't be read"),
        ("gltf-draco.glb", "its Draco data can't be read"),
    ] {
        let mut file = case_file(name);
        let end = file.bytes.len();
        file.bytes[end - 360..].fill(0xff);
        let error = read(&[file]).map_or_else(|error| error.to_string(), |import| import.report.to_string());
        assert!(error.contains(says), "{name}: {error}");
    }
}

#[test]
fn positions_that_are_no_numbers_are_named() {
    let mut doc = Doc::square();
    doc.bin[12..16].copy_from_slice(&f32::NAN.to_le_bytes());
    let import = open(&doc);
    assert!(!import.report.is_clean(), "{}", import.report);
    assert!(mesh(&import).positions().iter().all(|position: &Vec3| position.is_finite()));
}
