//! Skins and morph targets.

use super::build::{Doc, SQUARE};
use super::common::{mesh, read};
use formats::Import;
use glam::{Mat4, Vec3};
use halfedge::keys;
use serde_json::json;

fn open(doc: &Doc) -> Import {
    let import = read(&[doc.file()]).unwrap_or_else(|error| panic!("{error}"));
    mesh(&import);
    import
}

/// The square with its left side bound to joint 1 and its right one to joint 2, which is moved by (0, 0, 4)
/// and turned by a quarter round Z in a node above it. `weights` are those of the right side to joint 2.
fn skinned(weight: f32) -> Doc {
    let mut doc = Doc::square();
    let joints = doc.shorts("VEC4", &[0, 1, 0, 0].repeat(4));
    let of = |right: f32| [1.0 - right, right, 0.0, 0.0];
    let weights = [of(0.0), of(weight), of(weight), of(0.0)];
    let weights = doc.floats("VEC4", weights.as_flattened());
    let binds = [Mat4::IDENTITY, Mat4::from_translation(Vec3::new(-1.0, 0.0, 0.0))];
    let binds: Vec<f32> = binds.iter().flat_map(|bind| bind.to_cols_array()).collect();
    let binds = doc.floats("MAT4", &binds);
    let attributes = &mut doc.json["meshes"][0]["primitives"][0]["attributes"];
    attributes["JOINTS_0"] = json!(joints);
    attributes["WEIGHTS_0"] = json!(weights);
    doc.json["nodes"][0] = json!({ "mesh": 0, "skin": 0, "name": "shown", "translation": [9, 9, 9] });
    doc.push("nodes", json!({ "name": "left" }));
    let quarter = std::f64::consts::FRAC_1_SQRT_2;
    doc.push(
        "nodes",
        json!({ "translation": [0, 0, 4], "rotation": [0, 0, quarter, quarter], "children": [3] }),
    );
    doc.push("nodes", json!({ "name": "right", "translation": [0, 1, 0] }));
    doc.json["skins"] = json!([{ "joints": [1, 3], "inverseBindMatrices": binds }]);
    doc
}

fn positions(import: &Import) -> Vec<Vec3> {
    mesh(import).positions().to_vec()
}

#[test]
fn vertices_go_with_their_joints() {
    let import = open(&skinned(1.0));
    // (1, y, 0) is (0, y, 0) from joint 2, (0, y + 1, 0) above it, and (-y - 1, 0, 4) in the world.
    let expected = [Vec3::ZERO, Vec3::new(-1.0, 0.0, 4.0), Vec3::new(-2.0, 0.0, 4.0), Vec3::Y];
    for (position, expected) in positions(&import).iter().zip(expected) {
        assert!(position.distance(expected) < 1e-6, "{position} instead of {expected}");
    }
    let says =
        "\"shown\" has the pose of its skeleton in the scene; the 2 joints and their weights are not kept";
    assert!(import.report.to_string().contains(says), "{}", import.report);
    assert!(import.report.is_clean(), "{}", import.report);
}

#[test]
fn joints_are_mixed_by_weights_of_any_type_and_sum() {
    let half = positions(&open(&skinned(0.5)));
    assert!(half[1].distance(Vec3::new(0.0, 0.0, 2.0)) < 1e-6, "{}", half[1]);
    // The same as bytes that stand for fractions, and as floats of another sum.
    let mut doc = skinned(0.5);
    let bytes = [[255u8, 0, 0, 0], [128, 128, 0, 0], [128, 128, 0, 0], [255, 0, 0, 0]];
    let view = doc.view(bytes.as_flattened());
    let accessor =
        json!({ "bufferView": view, "componentType": 5121, "normalized": true, "count": 4, "type": "VEC4" });
    let bytes = doc.push("accessors", accessor);
    doc.json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] = json!(bytes);
    for (a, b) in positions(&open(&doc)).iter().zip(&half) {
        assert!(a.distance(*b) < 1e-6, "{a} instead of {b}");
    }
    // Vertices without weights go with the joint they name first.
    let mut doc = skinned(1.0);
    let none = doc.floats("VEC4", &[0.0; 16]);
    doc.json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] = json!(none);
    assert_eq!(positions(&open(&doc)), SQUARE.map(Vec3::from));
}

#[test]
fn a_second_set_of_joints_counts() {
    let mut doc = skinned(0.0);
    let attributes = &mut doc.json["meshes"][0]["primitives"][0]["attributes"];
    let joints = attributes["JOINTS_0"].clone();
    attributes["JOINTS_1"] = joints;
    let weights = doc.floats("VEC4", &[[0.0; 4], [0.0, 1.0, 0.0, 0.0], [0.0; 4], [0.0; 4]].concat());
    doc.json["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_1"] = json!(weights);
    // Half of each joint.
    assert!(positions(&open(&doc))[1].distance(Vec3::new(0.0, 0.0, 2.0)) < 1e-6);
}

#[test]
fn a_skin_that_cannot_be_read_leaves_the_mesh_at_its_node() {
    for (skin, says) in [
        (json!({ "joints": [1, 77] }), "its joint node 77 can't be placed"),
        (json!({ "joints": [] }), "it has no joints"),
        (json!({ "joints": [1, 3], "inverseBindMatrices": 88 }), "accessor 88 doesn't exist"),
    ] {
        let mut doc = skinned(1.0);
        doc.json["skins"] = json!([skin]);
        let import = open(&doc);
        let expected = SQUARE.map(|position| Vec3::from(position) + Vec3::splat(9.0));
        assert_eq!(positions(&import), expected);
        assert!(import.report.to_string().contains(says), "{} instead of {says}", import.report);
    }
    let mut doc = skinned(1.0);
    let attributes = &mut doc.json["meshes"][0]["primitives"][0]["attributes"];
    attributes.as_object_mut().expect("an object").remove("JOINTS_0");
    assert!(open(&doc).report.to_string().contains("none of its vertices names a joint"));
    // Joints without a skin are named among the attributes that are not kept.
    let mut doc = skinned(1.0);
    doc.json["nodes"][0] = json!({ "mesh": 0 });
    assert!(open(&doc).report.to_string().contains("JOINTS_0, WEIGHTS_0 left out"));
}

/// The square with two morph targets: the first lifts the right side, the second turns normals.
fn morphed() -> Doc {
    let mut doc = Doc::square();
    let lift = doc.floats("VEC3", &[[0.0; 3], [0.0, 0.0, 2.0], [0.0, 0.0, 2.0], [0.0; 3]].concat());
    let normals = doc.floats("VEC3", &[[0.0, 0.0, 1.0]; 4].concat());
    let turn = doc.floats("VEC3", &[[1.0, 0.0, -1.0]; 4].concat());
    let primitive = &mut doc.json["meshes"][0]["primitives"][0];
    primitive["attributes"]["NORMAL"] = json!(normals);
    primitive["targets"] = json!([{ "POSITION": lift }, { "NORMAL": turn }]);
    doc.json["meshes"][0]["extras"] = json!({ "targetNames": ["lift", "turn"] });
    doc
}

#[test]
fn targets_are_added_by_the_weights_of_the_node_or_the_mesh() {
    let height = |doc: &Doc| positions(&open(doc))[1].z;
    let mut doc = morphed();
    assert_eq!(height(&doc), 0.0, "without weights");
    doc.json["meshes"][0]["weights"] = json!([0.25, 0]);
    assert_eq!(height(&doc), 0.5);
    doc.json["nodes"][0]["weights"] = json!([1.0, 1.0]);
    let import = open(&doc);
    assert_eq!(positions(&import)[1].z, 2.0, "the node's count");
    let normals = mesh(&import).attribute(keys::CORNER_NORMAL).expect("normals");
    let corner =
        mesh(&import).faces().flat_map(|f| mesh(&import).face_halfedges(f)).next().expect("a corner");
    assert_eq!(normals[corner.index()], Vec3::X);
    let says =
        "Mesh \"square\" is blended by its morph weights; its 2 morph targets are not kept: lift, turn";
    assert!(import.report.to_string().contains(says), "{}", import.report);
    assert!(import.report.is_clean(), "{}", import.report);
}

#[test]
fn sparse_targets_without_a_view_move_the_rows_that_they_name() {
    let mut doc = morphed();
    let rows = doc.view(&[2, 0, 0, 0]);
    let values: Vec<u8> = [0.0f32, 0.0, 5.0].iter().flat_map(|value| value.to_le_bytes()).collect();
    let values = doc.view(&values);
    let sparse = doc.push("accessors", json!({
        "componentType": 5126, "count": 4, "type": "VEC3",
        "sparse": { "count": 1, "indices": { "bufferView": rows, "componentType": 5121 }, "values": { "bufferView": values } },
    }));
    doc.json["meshes"][0]["primitives"][0]["targets"][0]["POSITION"] = json!(sparse);
    doc.json["meshes"][0]["weights"] = json!([1, 0]);
    let heights: Vec<f32> = positions(&open(&doc)).iter().map(|position| position.z).collect();
    assert_eq!(heights, [0.0, 0.0, 5.0, 0.0]);
}

#[test]
fn a_target_that_cannot_be_read_is_named() {
    let mut doc = morphed();
    doc.json["meshes"][0]["weights"] = json!([1, 1]);
    doc.json["meshes"][0]["primitives"][0]["targets"][0]["POSITION"] = json!(66);
    let import = open(&doc);
    assert_eq!(positions(&import)[1].z, 0.0);
    assert!(
        import.report.to_string().contains("morph target 0 doesn't count (accessor 66"),
        "{}",
        import.report
    );
}
