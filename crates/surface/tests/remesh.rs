//! Remeshing: regular triangles on the same surface.

mod common;

use common::*;
use glam::{DVec3, Vec2};
use halfedge::attribute::keys;
use halfedge::{Color, Mesh, PolygonSoup};
use proptest::prelude::*;
use std::f64::consts::TAU;
use std::ops::ControlFlow;
use surface::measure::*;
use surface::*;

fixtures::shared_tests!(
    a_scan_becomes_regular_and_stays_where_it_was,
    models_with_features_holes_and_components_keep_their_topology
);

fn run(mesh: &Mesh, options: &Remesh) -> Mesh {
    let result = remesh(mesh, options, &mut never_cancel).expect("in range");
    result.validate().expect("valid");
    assert!(result.faces().all(|f| result.face_degree(f) == 3));
    result
}

fn shape(name: &str) -> Mesh {
    Shape::named(name).expect("listed").build().expect("fits")
}

/// The smallest angle of all triangles, and the mean of the triangles' smallest angles, in degrees.
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

/// Concave polygons give folded ears, where close points could be projected onto the same edge.
#[test]
fn no_two_vertices_coincide() {
    let mesh = load(&fixtures::fixture("models/spot_control_mesh.obj"));
    for feature_angle in [45.0, 180.0] {
        let result = run(&mesh, &Remesh { edge_length: Some(0.0512), feature_angle, ..Remesh::default() });
        let areas = result.faces().map(|f| face_area(&result, f));
        assert!(areas.fold(f64::MAX, f64::min) > 0.0);
        let mut places: Vec<[u32; 3]> =
            result.positions().iter().map(|p| p.to_array().map(f32::to_bits)).collect();
        let count = places.len();
        places.sort_unstable();
        places.dedup();
        assert_eq!(places.len(), count, "{feature_angle}");
    }
}

#[test]
fn faces_without_area_are_remeshed_too() {
    // The result of a bevel of width 0: a quad between two edges at the same place.
    let mut mesh = cube();
    let edge = mesh.edges().next().expect("has edges");
    let live = halfedge::edit::bevel_edges(&mut mesh, &[edge], 1);
    live.expect("any edge").slide.apply(&mut mesh, 0.0).expect("in range");
    for length in [0.3, 0.5, 1.0] {
        let options = Remesh { edge_length: Some(length), ..Remesh::default() };
        assert_eq!(run(&mesh, &options).euler_characteristic(), 2);
    }
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

/// The share of inner vertices that have six neighbours.
fn regular(mesh: &Mesh) -> f64 {
    let inner: Vec<_> = mesh.vertices().filter(|&v| !mesh.is_boundary_vertex(v)).collect();
    inner.iter().filter(|&&v| mesh.valence(v) == 6).count() as f64 / inner.len() as f64
}

fn same_topology(a: &Mesh, b: &Mesh) {
    let isolated = a.vertices().filter(|&v| a.halfedge_from(v).is_none()).count();
    assert_eq!(b.euler_characteristic(), a.euler_characteristic() - isolated as i64);
    assert_eq!(b.boundary_loops().len(), a.boundary_loops().len());
    assert_eq!(b.components().1, a.components().1 - isolated);
}

/// The largest distance of the result's vertices from the input.
fn farthest_vertex(input: &Mesh, result: &Mesh) -> f64 {
    let tree = FaceTree::new(input);
    let off = |p| tree.closest_point(input, p).expect("has faces").distance;
    result.positions().iter().map(|&p| off(p)).fold(0.0, f64::max)
}

fn a_scan_becomes_regular_and_stays_where_it_was() {
    let bunny = load(&fixtures::shared("models/common/stanford-bunny.obj"));
    // Without features: on a scan of this resolution they are noise, which allows no good triangles.
    let options = Remesh { iterations: 10, feature_angle: 180.0, ..Remesh::default() };
    let result = run(&bunny, &options);
    same_topology(&bunny, &result);
    let (least, mean) = angles(&result);
    assert!(least > 30.0 && mean > 48.0, "{least} {mean}");
    assert!(regular(&result) > 0.8, "{}", regular(&result));
    assert!((mean_edge_length(&result) / mean_edge_length(&bunny) - 1.0).abs() < 0.05);
    let size = bounding_box(&bunny).expect("has vertices").diagonal();
    assert!(farthest_vertex(&bunny, &result) < 1e-6 * size);
}

fn models_with_features_holes_and_components_keep_their_topology() {
    for name in ["cow", "fandisk", "beetle", "cheburashka", "spot", "teapot"] {
        let (positions, faces) = read_obj(&fixtures::shared(&format!("models/common/{name}.obj")));
        let positions = positions.iter().map(|p| p.as_vec3()).collect();
        let mesh = Mesh::build(PolygonSoup::new(positions, &faces)).expect("small").mesh;
        let result = run(&mesh, &Remesh::default());
        same_topology(&mesh, &result);
        if name == "cheburashka" {
            let (least, _) = angles(&result);
            assert!(least > 25.0, "its folded sliver is no feature: {least}");
        }
        let size = bounding_box(&mesh).expect("has vertices").diagonal();
        // Curves are on the input too, except in a few places where they can't be.
        assert!(farthest_vertex(&mesh, &result) < 5e-3 * size, "{name}: {}", farthest_vertex(&mesh, &result));
    }
}

#[test]
fn sharp_rims_are_divided_evenly_however_fine_they_were() {
    for (segments, length) in [(40.0, 0.1), (40.0, 0.25), (64.0, 0.15), (100.0, 0.12), (127.0, 0.2)] {
        let mut cylinder = Shape::named("cylinder").expect("listed");
        cylinder.set("segments", segments).expect("in range");
        let cylinder = cylinder.build().expect("fits");
        let options = Remesh { edge_length: Some(length), iterations: 8, ..Remesh::default() };
        let result = run(&cylinder, &options);
        let (least, _) = angles(&result);
        assert!(least > 30.0, "{segments}: {least}");
        let height = bounding_box(&cylinder).expect("has vertices").max.y;
        for y in [height, -height] {
            let is_on_rim = |p: glam::Vec3| p.y == y && p.x.hypot(p.z) > 0.99;
            let rim: Vec<f64> = result
                .edges()
                .filter(|&e| result.ends(e).iter().all(|&v| is_on_rim(result.position(v))))
                .map(|e| edge_length(&result, e))
                .collect();
            // A polygon with that many sides is nearly as long as the circle. Its sides are between 4/5 and 4/3 of
            // the length, except one where a triangle would be thin.
            let even = TAU / length;
            let count = rim.len() as f64;
            assert!(
                count > 0.74 * even && count < 1.3 * even,
                "{segments}: {count} edges, {even} would be even"
            );
            assert!((rim.iter().sum::<f64>() - TAU).abs() < 0.05, "all the way round");
            let (short, long) = rim.iter().fold((f64::MAX, 0.0f64), |(s, l), &x| (s.min(x), l.max(x)));
            assert!(short > 0.7 * length && long < 1.4 * length, "{segments}: {short} to {long}");
        }
    }
}

#[test]
fn a_polygon_that_is_folded_keeps_the_fold() {
    let corners = [(0.0, -1.0, 0.0), (1.0, 0.0, 1.0), (0.0, 1.0, 0.0), (-1.0, 0.0, 1.0)];
    let positions = corners.map(glam::Vec3::from).to_vec();
    let folded = Mesh::build(PolygonSoup::new(positions, &[[0, 1, 2, 3]])).expect("small").mesh;
    let result = run(&folded, &Remesh { edge_length: Some(0.17), ..Remesh::default() });
    let tree = FaceTree::new(&result);
    for y in [-0.71, 0.0, 0.33] {
        let on_fold = glam::Vec3::new(0.0, y, 0.0);
        let off = tree.closest_point(&result, on_fold).expect("has faces").distance;
        assert!(off < 1e-6, "{on_fold} is {off} off");
    }
}

#[test]
fn boundaries_are_divided_evenly_in_place() {
    let mut disc = grid(20);
    for v in disc.vertices().collect::<Vec<_>>() {
        // A square of circles.
        let p = disc.position(v) / 10.0 - 1.0;
        let (x, y) = (p.x, p.y);
        disc.set_position(
            v,
            glam::Vec3::new(x * (1.0 - y * y / 2.0).sqrt(), y * (1.0 - x * x / 2.0).sqrt(), 0.0),
        );
    }
    let result = run(&disc, &Remesh { iterations: 8, ..Remesh::default() });
    let rim: Vec<DVec3> = disc
        .vertices()
        .filter(|&v| disc.is_boundary_vertex(v))
        .map(|v| disc.position(v).as_dvec3())
        .collect();
    assert!(angles(&result).0 > 30.0, "{}", angles(&result).0);
    for v in result.vertices().filter(|&v| result.is_boundary_vertex(v)) {
        let p = result.position(v).as_dvec3();
        // On a side of the polygon: between two of its corners.
        let on = rim.iter().any(|&a| {
            rim.iter()
                .any(|&b| (a.distance(p) + b.distance(p) - a.distance(b)).abs() < 1e-6 && a.distance(b) < 0.2)
        });
        assert!(on, "{p}");
    }
}

#[test]
fn noise_is_no_feature() {
    let mut mesh = run(&shape("uv-sphere"), &Remesh { edge_length: Some(0.1), ..Remesh::default() });
    let v = mesh.vertices().nth(100).expect("has many");
    let p = mesh.position(v);
    mesh.set_position(v, p * 1.1);
    let result = run(&mesh, &Remesh { iterations: 8, ..Remesh::default() });
    let (least, _) = angles(&result);
    assert!(least > 30.0, "{least}");
}

#[test]
fn the_smallest_meshes() {
    let triangle = mesh(&[[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]], &[&[0, 1, 2]]);
    for (mesh, name) in [(triangle, "triangle"), (cube(), "cube"), (tetrahedron(), "tetrahedron")] {
        for length in [None, Some(0.3), Some(100.0)] {
            for iterations in [1, 5] {
                let result = run(&mesh, &Remesh { edge_length: length, iterations, ..Remesh::default() });
                same_topology(&mesh, &result);
                // All corners are sharp, so all stay.
                for &p in mesh.positions() {
                    assert!(result.positions().contains(&p), "{name} {length:?}: {p}");
                }
                let (before, after) = (surface_area(&mesh), surface_area(&result));
                assert!(
                    (before - after).abs() < 1e-5 * before,
                    "{name} {length:?} {iterations}: {before} {after}"
                );
            }
        }
    }
}

#[test]
fn refuses_bad_values_and_stops_when_cancelled() {
    let cube = cube();
    let bad = |options: Remesh| remesh(&cube, &options, &mut never_cancel).expect_err("refused").to_string();
    assert_eq!(bad(Remesh { edge_length: Some(0.0), ..Remesh::default() }), "edge_length must be above 0");
    assert_eq!(
        bad(Remesh { feature_angle: 0.0, ..Remesh::default() }),
        "feature_angle must be above 0 and at most 180"
    );
    let tiny = remesh(&cube, &Remesh { edge_length: Some(1e-6), ..Remesh::default() }, &mut never_cancel);
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

#[test]
fn more_iterations_than_the_limit_are_refused() {
    let refused = |iterations| {
        let options = Remesh { iterations, ..Remesh::default() };
        remesh(&cube(), &options, &mut never_cancel).expect_err("too many").to_string()
    };
    assert_eq!(refused(1001), "iterations must be from 1 to 1000");
    assert_eq!(refused(u32::MAX), "iterations must be from 1 to 1000");
    let options = Smooth { iterations: 10_001, strength: 0.5, method: SmoothMethod::Taubin };
    let refused = smooth(&cube(), &options, &mut never_cancel).expect_err("too many");
    assert_eq!(refused.to_string(), "iterations must be from 1 to 10000");
    assert!(smooth(&cube(), &Smooth { iterations: 10_000, ..options }, &mut never_cancel).is_ok());
}

proptest! {
    // Each case makes many triangles.
    #![proptest_config(ProptestConfig::with_cases(8))]

    /// Edges shorter than those of the input follow it closely, whatever its polygons, boundary and components: area
    /// and volume stay, and no part disappears.
    #[test]
    fn fine_edges_keep_area_and_volume(mesh in random_mesh(false), length in 0.12f64..0.2) {
        // Polygons that aren't flat have an area once they are cut.
        let whole = Simplify { target: SimplifyTarget::Ratio(1.0), preserve_boundary: true, preserve_seams: true };
        let cut = simplify(&mesh, &whole, &mut never_cancel).expect("in range").mesh;
        let result = run(&mesh, &Remesh { edge_length: Some(length), ..Remesh::default() });
        if cut.face_count() == 0 {
            return Ok(());
        }
        let (before, after) = (surface_area(&cut), surface_area(&result));
        prop_assert!(after > 0.85 * before && after < 1.25 * before, "area from {} to {}", before, after);
        let change = (volume_from_origin(&result) - volume_from_origin(&cut)).abs();
        prop_assert!(change < 0.3 * length * before, "volume by {}, of area {}", change, before);
        let (there, back) = (farthest_vertex(&cut, &result), farthest_vertex(&result, &cut));
        // A corner that is no feature may end up above the middle of a triangle with the longest sides, 4/3 of the
        // length, but not farther above it than the middle is from its corners: steeper ones are features.
        prop_assert!(back < 4.0 / 3.0 / 3f64.sqrt() * length, "the input is {} off", back);
        // Vertices on blocked curves are off the input by less than the width of its faces.
        prop_assert!(there < 1.0, "{} off", there);
    }
}

/// Between the corners of a unit cube this far from the origin there is no float.
#[test]
fn coordinates_too_coarse_for_the_edge_length_come_to_an_end() {
    let mut far = cube();
    for v in far.vertices().collect::<Vec<_>>() {
        let corner = far.position(v).max(glam::Vec3::ZERO);
        far.set_position(v, corner + glam::Vec3::splat(1e7));
    }
    for edge_length in [None, Some(0.3), Some(0.01)] {
        let result = remesh(&far, &Remesh { edge_length, ..Remesh::default() }, &mut never_cancel).unwrap();
        result.validate().expect("valid");
        assert!((4..100).contains(&result.face_count()), "{}", result.face_count());
    }
}
