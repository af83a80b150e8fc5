//! Files made after faults that users reported of other programs.

use super::common::{by_code, case_file, mesh, read};
use formats::Import;
use glam::Vec3;
use halfedge::keys;

fn case(name: &str) -> Import {
    let import = read(&[case_file(name)]).unwrap_or_else(|error| panic!("{name}: {error}"));
    for object in &import.model.objects {
        object.mesh.validate().expect("a valid mesh");
    }
    import
}

fn positions(import: &Import) -> Vec<Vec3> {
    mesh(import).positions().to_vec()
}

const SQUARE: [Vec3; 4] = [Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::Y];

#[test]
fn sparse_accessors_replace_rows() {
    let import = case("gltf-sparse-positions.gltf");
    assert_eq!(positions(&import), [Vec3::ZERO, Vec3::X, Vec3::new(5.0, 6.0, 7.0), Vec3::Y]);
    assert!(import.report.is_clean(), "{}", import.report);
}

#[test]
fn accessors_without_a_view_are_zeros() {
    let import = case("gltf-accessor-without-view.gltf");
    assert_eq!(positions(&import), SQUARE);
    let normals = mesh(&import).attribute(keys::CORNER_NORMAL).expect("normals");
    let mesh = mesh(&import);
    assert!(
        mesh.halfedges().filter(|&h| !mesh.is_boundary_halfedge(h)).all(|h| normals[h.index()] == Vec3::ZERO)
    );
}

#[test]
fn joints_place_a_skinned_node() {
    let import = case("gltf-skinned-under-transform.gltf");
    assert_eq!(positions(&import), SQUARE);
    assert!(import.report.to_string().contains("has the pose of its skeleton"), "{}", import.report);
    assert!(import.report.is_clean(), "{}", import.report);
}

#[test]
fn default_weights_apply_to_morph_targets() {
    let import = case("gltf-morph-weight.gltf");
    assert!(positions(&import).iter().all(|position| position.z == 0.5), "{:?}", positions(&import));
    assert!(import.report.to_string().contains("1 morph target is not kept"), "{}", import.report);
}

#[test]
fn version_1_is_refused_by_name() {
    let error = read(&[case_file("gltf-version-1.gltf")]).expect_err("another version").to_string();
    assert!(error.contains("glTF 1.0. Meshwright reads version 2"), "{error}");
}

#[test]
fn compressed_meshes_are_decoded() {
    for name in ["gltf-meshopt.glb", "gltf-draco.glb"] {
        let import = case(name);
        let mesh = mesh(&import);
        assert_eq!((mesh.vertex_count(), mesh.face_count()), (18, 36), "{name}");
        assert_eq!(mesh.euler_characteristic(), 0, "{name}: a torus");
        assert_eq!(mesh.boundary_loops().len(), 0, "{name}: closed");
        assert!(import.report.is_clean(), "{}", import.report);
        // Both are quantised: near the sizes that the file states.
        let size = mesh.positions().iter().fold(Vec3::ZERO, |size, position| size.max(position.abs()));
        assert!(size.distance(Vec3::new(0.541_266, 0.216_506, 0.625)) < 1e-4, "{name}: {size}");
        let has_uvs = mesh.attribute(keys::CORNER_UV).expect("uvs").iter().all(|uv| uv.is_finite());
        let normals = mesh.attribute(keys::CORNER_NORMAL).expect("normals");
        assert!(has_uvs && normals.iter().all(|normal| (normal.length() - 1.0).abs() < 1e-2), "{name}");
    }
}

#[test]
fn whole_numbers_may_have_a_fraction_of_zero() {
    let import = case("gltf-integers-as-floats.gltf");
    assert_eq!(positions(&import), [Vec3::ZERO, Vec3::X, Vec3::Y]);
    assert!(import.report.is_clean(), "{}", import.report);
}

#[test]
fn a_missing_image_is_named() {
    let import = case("gltf-webp-texture-missing.gltf");
    assert_eq!(positions(&import), [Vec3::ZERO, Vec3::X, Vec3::Y]);
    assert!(import.report.to_string().contains("were not given: gone.webp"), "{}", import.report);
    // It is still referred to in what is saved.
    for code in ["glb", "gltf"] {
        let back = read(&formats::write(by_code(code), &import.model).expect("small")).expect("readable");
        assert_eq!(back.model.materials, import.model.materials, "{code}");
    }
}
