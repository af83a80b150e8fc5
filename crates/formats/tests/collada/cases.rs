//! Files made after faults that users reported of other programs.

use super::common::{case_file, mesh, read};
use formats::Import;
use glam::{Mat3, Vec3};
use halfedge::keys;

fn case(name: &str) -> Import {
    let import = read(&[case_file(name)]).expect(name);
    for object in &import.model.objects {
        object.mesh.validate().expect("a valid mesh");
    }
    import
}

fn positions(import: &Import) -> Vec<Vec3> {
    mesh(import).positions().to_vec()
}

const TRIANGLE: [Vec3; 3] = [Vec3::ZERO, Vec3::X, Vec3::Y];

#[test]
fn an_accessor_chooses_its_numbers() {
    let import = case("dae-accessor-offset.dae");
    assert_eq!(positions(&import), TRIANGLE);
    assert!(import.report.is_clean(), "{}", import.report);
}

#[test]
fn a_skin_has_its_bind_shape_and_pose() {
    let import = case("dae-bind-shape.dae");
    assert!(positions(&import).iter().all(|p| p.z == 10.0), "{:?}", positions(&import));
    assert!(import.report.to_string().contains("\"n\" has the pose of its skeleton"), "{}", import.report);
}

#[test]
fn a_morphed_geometry_is_shown_where_its_node_is() {
    let import = case("dae-morph-controller.dae");
    let first = |object: usize| import.model.objects[object].mesh.positions()[0];
    assert_eq!((import.model.objects.len(), first(0), first(1)), (2, Vec3::X * 3.0, Vec3::Z * 5.0));
    assert!(import.report.to_string().contains("its morph targets are not kept: thing"), "{}", import.report);
}

#[test]
fn vertices_have_colours() {
    let import = case("dae-vertex-colours.dae");
    let colors: Vec<Vec3> = (0..3).map(|v| mesh(&import).get(keys::VERTEX_COLOR, v)).collect();
    assert_eq!(colors, [Vec3::X; 3], "red");
    assert!(import.report.is_clean(), "{}", import.report);
}

#[test]
fn nodes_may_be_nested_deeply() {
    assert!(positions(&case("dae-80-nested-nodes.dae")).iter().all(|p| p.z == 80.0));
}

#[test]
fn decimal_commas_are_read_where_nothing_else_fits() {
    let import = case("dae-decimal-commas.dae");
    let moved = Vec3::new(-7.5, -14.25, 0.0);
    assert_eq!(positions(&import), TRIANGLE.map(|p| p + moved));
    assert!(import.report.to_string().contains("read as decimal commas"), "{}", import.report);
}

#[test]
fn a_skew_slants() {
    let slanted = Mat3::from_cols(Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::Z);
    let found = positions(&case("dae-skew.dae"));
    assert!(found.iter().zip(TRIANGLE).all(|(p, given)| p.distance(slanted * given) < 1e-6), "{found:?}");
}

#[test]
fn a_missing_texture_coordinate_affects_one_corner() {
    let import = case("dae-texcoord-out-of-range.dae");
    let mesh = mesh(&import);
    let face = mesh.faces().next().expect("a face");
    let missing = mesh.face_halfedges(face).filter(|h| mesh.get(keys::CORNER_UV, h.index()).is_nan()).count();
    assert_eq!((mesh.face_count(), missing), (1, 1));
    assert!(import.report.to_string().contains("1 corner without texture coordinates"), "{}", import.report);
}

#[test]
fn a_fault_in_one_node_leaves_the_other() {
    let import = case("dae-matrix-of-15.dae");
    assert_eq!(positions(&import), TRIANGLE.map(|p| p + Vec3::Z * 5.0));
    assert!(
        import.report.to_string().contains("node \"n\" with what is in it: its <matrix> has 15 numbers"),
        "{}",
        import.report
    );
    let import = case("dae-geometry-elsewhere.dae");
    assert_eq!((positions(&import), import.model.objects[0].name.as_str()), (TRIANGLE.to_vec(), "m"));
    assert!(
        import.report.to_string().contains("what node \"n\" shows: \"other.dae#h\" is in another file"),
        "{}",
        import.report
    );
}
