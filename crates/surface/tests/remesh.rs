//! Remeshing: regular triangles on the same surface.

mod common;

use common::*;
use glam::{DVec3, Vec2};
use halfedge::attribute::keys;
use halfedge::{Color, Mesh};
use proptest::prelude::*;
use std::ops::ControlFlow;
use surface::measure::*;
use surface::*;

fn run(mesh: &Mesh, options: &Remesh) -> Mesh {
    let result = remesh(mesh, options, &mut go_on).expect("in range");
    result.validate().expect("valid");
    assert!(result.faces().all(|f| result.face_degree(f) == 3));
    result
}

fn shape(name: &str) -> Mesh {
    Shape::named(name).expect("listed").build().expect("fits")
}

/// The smallest angle of all triangles, and the mean of each triangle's smallest, in degrees.
fn angles(mesh: &Mesh) -> (f64, f64) {
    let (mut least, mut sum) = (180.0f64, 0.0);
    for f in mesh.faces() {
        let p: Vec<DVec3> = mesh.face_vertices(f).map(|v| mesh.position(v).as_dvec3()).collect();
        let smallest = (0..3)
            .map(|i| (p[(i + 1) % 3] - p[i]).angle_between(p[(i + 2) % 3] - p[i]).to_degrees())
            .fold(180.0, f64::min);
        least = least.min(smallest);
        sum += smallest;
    }
    (least, sum / mesh.face_count() as f64)
}

#[test]
fn a_sphere_gets_regular_triangles_of_the_length_asked_for() {
    let sphere = shape("uv-sphere");
    let options = Remesh { edge_length: Some(0.1), iterations: 10, ..Remesh::default() };
    let result = run(&sphere, &options);
    assert_eq!(result.euler_characteristic(), 2);
    let (least, mean) = angles(&result);
    assert!(least > 25.0 && mean > 45.0, "{least} {mean}");
    let six = result.vertices().filter(|&v| result.valence(v) == 6).count();
    assert!(six * 10 > result.vertex_count() * 7, "{six} of {}", result.vertex_count());
    assert!((mean_edge_length(&result) / 0.1 - 1.0).abs() < 0.15);
    assert!(result.edges().all(|e| edge_length(&result, e) < 0.15));
    let tree = FaceTree::new(&sphere);
    for v in result.vertices() {
        let distance = tree.closest_point(&sphere, result.position(v)).expect("has faces").distance;
        assert!(distance < 1e-5, "{v} is {distance} off");
    }
    assert_eq!(run(&sphere, &options), result, "the same every time");
}

#[test]
fn a_cube_keeps_its_edges_and_corners() {
    let cube = shape("cube");
    let result = run(&cube, &Remesh { edge_length: Some(0.2), iterations: 6, ..Remesh::default() });
    assert_eq!(result.euler_characteristic(), 2);
    assert!((volume(&result) - 8.0).abs() < 1e-5);
    assert!((surface_area(&result) - 24.0).abs() < 1e-5);
    for v in cube.vertices() {
        assert!(result.positions().contains(&cube.position(v)));
    }
}

#[test]
fn an_open_grid_keeps_its_outline_and_its_charts() {
    let mut mesh = grid(8);
    for f in mesh.faces().collect::<Vec<_>>() {
        let right = face_center(&mesh, f).x > 4.0;
        if right {
            mesh.set(keys::FACE_COLOR, f.index(), Color([0, 0, 255]));
        }
        for h in mesh.face_halfedges(f).collect::<Vec<_>>() {
            let p = mesh.position(mesh.from(h));
            mesh.set(keys::CORNER_UV, h.index(), Vec2::new(p.x + if right { 50.0 } else { 0.0 }, p.y));
        }
    }
    for v in mesh.vertices().collect::<Vec<_>>() {
        mesh.set(keys::VERTEX_COLOR, v.index(), mesh.position(v));
    }
    for length in [0.4, 1.0, 2.5] {
        let result = run(&mesh, &Remesh { edge_length: Some(length), ..Remesh::default() });
        assert!((surface_area(&result) - 64.0).abs() < 1e-3, "{}", surface_area(&result));
        assert_eq!(result.boundary_loops().len(), 1);
        for f in result.faces() {
            let right = face_center(&result, f).x > 4.0;
            assert_eq!(result.get(keys::FACE_COLOR, f.index()) == Color([0, 0, 255]), right);
            for h in result.face_halfedges(f) {
                let uv = result.get(keys::CORNER_UV, h.index());
                assert_eq!(uv.x > 25.0, right, "{uv}");
            }
        }
    }
}

#[test]
fn refuses_what_makes_no_sense_and_stops_when_told() {
    let cube = cube();
    let bad = |options: Remesh| remesh(&cube, &options, &mut go_on).expect_err("refused").to_string();
    assert_eq!(
        bad(Remesh { edge_length: Some(0.0), ..Remesh::default() }),
        "edge_length must be a finite number above 0"
    );
    assert_eq!(
        bad(Remesh { feature_angle: 0.0, ..Remesh::default() }),
        "feature_angle must be above 0 and at most 180 degrees"
    );
    let tiny = remesh(&cube, &Remesh { edge_length: Some(1e-6), ..Remesh::default() }, &mut go_on);
    assert!(matches!(tiny, Err(SurfaceError::TooManyFaces { .. })));
    let mut stop = |done: f32| if done > 0.3 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
    assert_eq!(remesh(&cube, &Remesh::default(), &mut stop), Err(SurfaceError::Cancelled));
    assert_eq!(run(&Mesh::new(), &Remesh::default()), Mesh::new());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn any_mesh_keeps_its_topology_and_outline(
        mesh in random_mesh(false),
        length in 0.4f64..3.0,
        project in any::<bool>(),
    ) {
        let options = Remesh { edge_length: Some(length), iterations: 3, project, ..Remesh::default() };
        let result = run(&mesh, &options);
        let isolated = mesh.vertices().filter(|&v| mesh.halfedge_from(v).is_none()).count();
        prop_assert_eq!(result.components().1, mesh.components().1 - isolated);
        prop_assert_eq!(result.euler_characteristic(), mesh.euler_characteristic() - isolated as i64);
        prop_assert_eq!(result.boundary_loops().len(), mesh.boundary_loops().len());
        prop_assert!(result.positions().iter().all(|p| p.is_finite() && p.abs().max_element() < 20.0));
        let length_of = |mesh: &Mesh| -> f64 {
            mesh.edges().filter(|&e| mesh.is_boundary_edge(e)).map(|e| edge_length(mesh, e)).sum()
        };
        prop_assert!(length_of(&result) <= length_of(&mesh) * (1.0 + 1e-5) + 1e-5, "no boundary grows");
    }
}
