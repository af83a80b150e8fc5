//! Normals, lengths, areas, volumes, and the triangles of polygons.

mod common;

use common::*;
use glam::{DVec3, Vec3};
use halfedge::geometry::PolygonTriangulator;
use halfedge::{Budget, FaceId, InParts, Mesh, PolygonSoup};
use proptest::prelude::*;
use std::f64::consts::PI;
use surface::curvature::*;
use surface::measure::*;
use surface::normals::*;
use surface::*;

#[test]
fn a_cube_measures_up() {
    let mesh = cube();
    assert_eq!(volume(&mesh), 8.0);
    assert_eq!(surface_area(&mesh), 24.0);
    assert_eq!(mean_edge_length(&mesh), 2.0);
    assert_eq!(bounding_box(&mesh), Some(Bounds { min: -Vec3::ONE, max: Vec3::ONE }));
    assert_eq!(bounding_box(&Mesh::new()), None);
    let expected = [Vec3::NEG_Z, Vec3::Z, Vec3::NEG_Y, Vec3::Y, Vec3::NEG_X, Vec3::X];
    assert_eq!(face_normals(&mesh), expected);
    for f in mesh.faces() {
        assert_eq!(face_center(&mesh, f), expected[f.index()].as_dvec3());
        assert_eq!(face_area(&mesh, f), 4.0);
    }
    for v in mesh.vertices() {
        assert!(vertex_normal(&mesh, v).distance(mesh.position(v).normalize()) < 1e-6);
    }
    for e in mesh.edges() {
        assert_eq!(edge_length(&mesh, e), 2.0);
    }
}

#[test]
fn an_arrow_head_is_measured_by_its_area() {
    // Concave at the second corner.
    let mesh = mesh(&[[-2., -2., 5.], [0., 0., 5.], [2., -2., 5.], [0., 4., 5.]], &[&[0, 1, 2, 3]]);
    let f = FaceId::new(0);
    assert_eq!(face_area(&mesh, f), 8.0);
    assert_eq!(face_normal(&mesh, f), Vec3::Z);
    assert_eq!(face_center(&mesh, f), DVec3::new(0.0, 0.0, 5.0));
}

#[test]
fn a_quad_is_cut_where_both_halves_face_the_same_way() {
    let mut cut = PolygonTriangulator::new();
    let quad = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]].map(Vec3::from_array);
    assert_eq!(cut.triangulate(&quad), [[0, 1, 2], [0, 2, 3]]);
    let arrow = [[-2., -2., 0.], [0., 0., 0.], [2., -2., 0.], [0., 4., 0.]].map(Vec3::from_array);
    assert_eq!(cut.triangulate(&arrow), [[0, 1, 3], [1, 2, 3]]);
    let turned = [arrow[1], arrow[2], arrow[3], arrow[0]];
    assert_eq!(cut.triangulate(&turned), [[0, 1, 2], [0, 2, 3]]);
    let no_area = [Vec3::ZERO; 6];
    assert_eq!(cut.triangulate(&no_area).len(), 4);
    assert!(cut.triangulate(&no_area[..2]).is_empty());
}

#[test]
fn small_polygons_are_fans_where_that_is_right() {
    let mut cut = PolygonTriangulator::new();
    let ring = |count: u8| -> Vec<Vec3> {
        let turn = |i: u8| std::f32::consts::TAU * f32::from(i) / f32::from(count);
        (0..count).map(|i| Vec3::new(turn(i).cos(), turn(i).sin(), 0.1 * f32::from(i % 2))).collect()
    };
    assert_eq!(cut.triangulate(&ring(5)), [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    assert_eq!(cut.triangulate(&ring(8))[5], [0, 6, 7]);
    let fans = |triangles: &[[u32; 3]]| triangles.iter().all(|triangle| triangle.contains(&0));
    assert!(!fans(cut.triangulate(&ring(60))));
    // A fan from the first corner would cross the notch.
    let arrow = [[0., 0.], [4., -3.], [1., 0.], [4., 3.], [2., 3.]].map(|[x, y]| Vec3::new(x, y, 0.0));
    let notched = [arrow[1], arrow[2], arrow[3], arrow[4], arrow[0]];
    assert_cover(&notched, cut.triangulate(&notched));
    assert!(!fans(cut.triangulate(&notched)));
}

#[test]
fn a_comb_and_a_figure_of_eight_are_covered() {
    // A comb with 200 teeth: half of its corners are concave.
    let mut comb = vec![Vec3::new(400.0, -1.0, 0.0), Vec3::new(400.0, 0.0, 0.0)];
    for tooth in (0..200).rev() {
        let x = 2.0 * tooth as f32;
        comb.extend([[x + 1.5, 10.0], [x + 1.0, 0.0]].map(|[x, y]| Vec3::new(x, y, 0.0)));
    }
    comb.push(Vec3::new(0.0, -1.0, 0.0));
    let mut cut = PolygonTriangulator::new();
    assert_cover(&comb, cut.triangulate(&comb));
    let eight = [[0., 0.], [2., 2.], [2., 0.], [0., 2.], [-1., 1.]].map(|[x, y]| Vec3::new(x, y, 0.0));
    assert_eq!(cut.triangulate(&eight).len(), 3);
}

#[test]
fn polygons_that_touch_themselves_are_covered_once() {
    // Two squares that touch at a corner, a waist, and a square with a hole and a slit to it.
    let squares = [(0., 0.), (1., 0.), (1., 1.), (2., 1.), (2., 2.), (1., 2.), (1., 1.), (0., 1.)];
    let waist = [(0., 0.), (2., 1.), (4., 0.), (4., 4.), (2., 1.), (0., 4.)];
    let hole =
        [(0., 0.), (4., 0.), (4., 4.), (0., 4.), (0., 0.), (1., 1.), (1., 3.), (3., 3.), (3., 1.), (1., 1.)];
    let turn = glam::Quat::from_euler(glam::EulerRot::XYZ, 0.3, -0.7, 0.2);
    for polygon in [&squares[..], &waist, &hole] {
        for start in 0..polygon.len() {
            let flat = polygon[start..].iter().chain(&polygon[..start]);
            let flat: Vec<Vec3> = flat.map(|&(x, y)| Vec3::new(x, y, 0.0)).collect();
            let tilted: Vec<Vec3> = flat.iter().map(|&p| turn * p).collect();
            let mut cut = PolygonTriangulator::new();
            assert_cover(&flat, cut.triangulate(&flat));
            assert_cover(&tilted, cut.triangulate(&tilted));
        }
    }
}

/// Checks the number of triangles, that none is turned over, and that their areas sum to the polygon's.
fn assert_cover(polygon: &[Vec3], triangles: &[[u32; 3]]) {
    assert_eq!(triangles.len(), polygon.len() - 2);
    let cross = |a: Vec3, b: Vec3, c: Vec3| (b - a).as_dvec3().cross((c - a).as_dvec3());
    let whole: DVec3 = polygon[1..].windows(2).map(|p| cross(polygon[0], p[0], p[1])).sum();
    let normal = whole.normalize();
    let mut sum = 0.0;
    for triangle in triangles {
        let [a, b, c] = triangle.map(|i| polygon[i as usize]);
        let area = cross(a, b, c).dot(normal);
        assert!(area > -1e-6 * whole.length(), "turned over");
        sum += area;
    }
    assert!((sum - whole.length()).abs() < 1e-5 * whole.length(), "{sum} is not {}", whole.length());
}

/// A star-shaped polygon in any plane.
fn star() -> impl Strategy<Value = Vec<Vec3>> {
    (prop::collection::vec(0.1f32..2.0, 3..40), -1f32..1.0, -1f32..1.0, any::<bool>()).prop_map(
        |(radii, tilt_x, tilt_y, over)| {
            let turn = glam::Quat::from_euler(glam::EulerRot::XYZ, tilt_x * 3.0, tilt_y * 3.0, 0.3);
            let count = radii.len() as f32;
            let mut polygon: Vec<Vec3> = (0u16..)
                .zip(&radii)
                .map(|(i, r)| {
                    let a = f32::from(i) / count * std::f32::consts::TAU;
                    turn * Vec3::new(r * a.cos(), r * a.sin(), 0.0)
                })
                .collect();
            if over {
                polygon.reverse();
            }
            polygon
        },
    )
}

proptest! {
    #[test]
    fn ear_clipping_covers_star_polygons(polygon in star()) {
        assert_cover(&polygon, PolygonTriangulator::new().triangulate(&polygon));
    }
}

proptest! {
    #[test]
    fn normals_of_single_elements_are_those_of_the_whole_mesh(mesh in random_mesh(false)) {
        let (faces, vertices) = (face_normals(&mesh), vertex_normals(&mesh));
        prop_assert!(mesh.faces().all(|f| faces[f.index()] == face_normal(&mesh, f)));
        prop_assert!(mesh.vertices().all(|v| vertices[v.index()] == vertex_normal(&mesh, v)));
    }
}

#[test]
fn shapes_are_closed_outward_and_as_large_as_asked() {
    for name in Shape::names() {
        let shape = Shape::named(name).expect("listed");
        let mesh = shape.build().expect("default sizes");
        mesh.validate().expect(name);
        if shape.control_points().is_some() {
            continue;
        }
        let flat = ["plane", "grid"].contains(&name);
        if name != "teapot" {
            assert_eq!(mesh.face_count() as u64, shape.face_count(), "{name}");
            assert_eq!(mesh.components().1, 1, "{name}");
            assert_eq!(mesh.boundary_loops().len(), usize::from(flat), "{name}");
            let center = bounding_box(&mesh).expect("not empty").center();
            let regular = ["tetrahedron", "dodecahedron"].contains(&name);
            assert!(center.length() < 1e-6 || regular, "{name} is centred at {center}");
        }
        if flat {
            assert!(face_normals(&mesh).iter().all(|&n| n == Vec3::Y), "{name} faces up");
            assert!((surface_area(&mesh) - 4.0).abs() < 1e-5);
        } else {
            assert!(volume(&mesh) > 0.5, "{name} faces outward");
        }
        let euler = if name == "torus" { 0 } else { 2 };
        if !flat && name != "teapot" {
            assert_eq!(mesh.euler_characteristic(), euler, "{name}");
        }
    }
}

#[test]
fn bezier_shapes_have_the_control_points_that_their_meshes_show() {
    for (size, degree) in [(2.0, 3.0), (0.5, 1.0), (7.0, 32.0)] {
        let mut curve = Shape::named("bezier-curve").expect("listed");
        curve.set("size", size).expect("in range");
        curve.set("degree", degree).expect("in range");
        let points = curve.control_points().expect("a curve").points();
        assert_eq!(points.len(), degree as usize + 1);
        assert!(points.iter().all(|at| at.z == 0.0));
        assert!(f64::from((points[0].x - points[degree as usize].x).abs()) - size < 1e-6);
        assert_eq!((curve.face_count(), curve.build().expect("empty").vertex_count()), (0, 0));
    }
    let patch = Shape::named("bezier-patch").expect("listed");
    let points = patch.control_points().expect("a patch").points();
    assert_eq!(points.len(), 16);
    let mesh = patch.build().expect("small");
    assert_eq!(mesh.face_count() as u64, patch.face_count());
    assert_eq!(mesh.boundary_loops().len(), 1);
    assert!(face_normals(&mesh).iter().all(|n| n.y > 0.0), "it faces up");
    for corner in [0, 3, 12, 15] {
        assert!(
            mesh.positions().iter().any(|at| at.distance(points[corner]) < 1e-6),
            "a corner is on the surface"
        );
    }
    assert!(Shape::named("cube").expect("listed").control_points().is_none());
}

#[test]
fn volumes_of_shapes_follow_from_their_sizes() {
    let build = |name: &str, sizes: &[(&str, f64)]| {
        let mut shape = Shape::named(name).expect("listed");
        for &(field, value) in sizes {
            shape.set(field, value).expect("in range");
            assert_eq!(shape.get(field), Some(value));
        }
        shape.build().expect("sizes that go together")
    };
    // The area of a regular n-gon in a circle of radius r is n/2 r^2 sin(2 pi / n).
    let polygon = |r: f64, n: f64| n / 2.0 * r * r * (2.0 * PI / n).sin();
    let near = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-5, "{a} is not {b}");
    near(volume(&build("cube", &[("size", 3.0)])), 27.0);
    near(volume(&build("tetrahedron", &[("radius", 3.0)])), 27.0 * 8.0 / (9.0 * 3f64.sqrt()));
    near(volume(&build("octahedron", &[("radius", 2.0)])), 4.0 / 3.0 * 8.0);
    near(
        volume(&build("cylinder", &[("radius", 2.0), ("height", 5.0), ("segments", 7.0)])),
        polygon(2.0, 7.0) * 5.0,
    );
    near(
        volume(&build("cone", &[("radius", 2.0), ("height", 5.0), ("segments", 9.0)])),
        polygon(2.0, 9.0) * 5.0 / 3.0,
    );
    // Inside the sphere, by less than a ten-thousandth.
    let ball = volume(&build("ico-sphere", &[("subdivisions", 7.0)])) / (4.0 / 3.0 * PI);
    assert!(ball < 1.0 && ball > 0.9999, "{ball}");
    // A uv-sphere is a stack of frusta of regular polygons.
    let (segments, rings) = (9.0, 5.0);
    let frusta: f64 = (0..5)
        .map(|ring| {
            let [(y0, a0), (y1, a1)] = [ring, ring + 1].map(|k| {
                let angle = f64::from(k) / rings * PI;
                (-angle.cos(), polygon(angle.sin(), segments))
            });
            (y1 - y0) / 3.0 * (a0 + a1 + (a0 * a1).sqrt())
        })
        .sum();
    near(volume(&build("uv-sphere", &[("segments", segments), ("rings", rings)])), frusta);
    let ico = build("icosahedron", &[]);
    let edge = mean_edge_length(&ico);
    near(volume(&ico), 5.0 / 12.0 * (3.0 + 5f64.sqrt()) * edge.powi(3));
    let dodeca = build("dodecahedron", &[("radius", 2.0)]);
    let edge = mean_edge_length(&dodeca);
    near(volume(&dodeca), (15.0 + 7.0 * 5f64.sqrt()) / 4.0 * edge.powi(3));
    assert!(dodeca.faces().all(|f| dodeca.face_degree(f) == 5));
    for v in dodeca.vertices() {
        assert!((dodeca.position(v).length() - 2.0).abs() < 1e-6);
    }
    let torus = build(
        "torus",
        &[("radius", 2.0), ("tube_radius", 0.5), ("segments", 500.0), ("tube_segments", 400.0)],
    );
    assert!((volume(&torus) / (2.0 * PI * PI * 2.0 * 0.25) - 1.0).abs() < 1e-3);
}

#[test]
fn sizes_out_of_range_are_refused_by_name() {
    let mut torus = Shape::named("torus").expect("listed");
    for (field, value) in [("segments", 2.0), ("segments", 3.5), ("radius", 0.0), ("radius", f64::NAN)] {
        let refused = torus.set(field, value).expect_err("out of range");
        assert!(refused.to_string().starts_with(&format!("{field} must be ")), "{refused}");
    }
    torus.set("tube_radius", 1.0).expect("in range on its own");
    assert_eq!(
        torus.build().expect_err("no hole left").to_string(),
        "tube_radius must be smaller than radius"
    );
    let mut grid = Shape::named("grid").expect("listed");
    grid.set("columns", 4096.0).expect("in range");
    grid.set("rows", 4096.0).expect("in range");
    assert!(matches!(grid.build(), Err(SurfaceError::TooManyFaces { faces: 16_777_216, .. })));
    assert!(Shape::named("donut").is_none());
    assert_eq!(grid.get("radius"), None);
}

fn shape(name: &str, radius: f64) -> Mesh {
    let mut shape = Shape::named(name).expect("a shape");
    shape.set("radius", radius).expect("a radius");
    shape.build().expect("a mesh")
}

#[test]
fn curvatures_of_a_sphere_are_those_of_its_radius() {
    for radius in [0.5, 3.0] {
        let ball = shape("ico-sphere", radius);
        for v in ball.vertices() {
            let (mean, gauss) =
                (mean_curvature(&ball, v) * radius, gaussian_curvature(&ball, v) * radius * radius);
            // The twelve vertices of valence five have faces of other shapes than a share of a third suits.
            let near = if ball.valence(v) == 6 { 0.1 } else { 0.16 };
            assert!((mean - 1.0).abs() < near && (gauss - 1.0).abs() < near, "{v}: {mean} {gauss}");
        }
    }
    // Turned inside out it is hollow, and its Gaussian curvature is the same.
    let ball = shape("ico-sphere", 1.0);
    let faces: Vec<Vec<u32>> = ball
        .faces()
        .map(|f| {
            let mut corners: Vec<u32> = ball.face_vertices(f).map(|v| v.raw()).collect();
            corners.reverse();
            corners
        })
        .collect();
    let hollow =
        Mesh::build(halfedge::PolygonSoup::new(ball.positions().to_vec(), &faces)).expect("a ball").mesh;
    for v in hollow.vertices() {
        assert!(mean_curvature(&hollow, v) < -0.9);
        assert!(gaussian_curvature(&hollow, v) > 0.8);
    }
}

/// Gauss and Bonnet: the total curvature is a matter of topology.
#[test]
fn total_curvature_is_two_pi_times_the_euler_characteristic() {
    for (mesh, euler) in [(shape("torus", 1.0), 0.0), (shape("ico-sphere", 2.0), 2.0)] {
        let share = |v| {
            let faces = mesh.vertex_faces(v);
            faces.map(|f| face_area(&mesh, f) / mesh.face_degree(f) as f64).sum::<f64>()
        };
        let total: f64 = mesh.vertices().map(|v| gaussian_curvature(&mesh, v) * share(v)).sum();
        assert!((total - 2.0 * PI * euler).abs() < 1e-4, "{total}");
    }
    let torus = shape("torus", 1.0);
    let inner = torus.vertices().filter(|v| {
        let p = torus.position(*v);
        p.x.hypot(p.z) < 0.7
    });
    for v in inner {
        assert!(gaussian_curvature(&torus, v) < 0.0, "{v} is a saddle");
    }
    let open = grid(3);
    let rim = open.vertices().filter(|v| open.is_boundary_vertex(*v));
    assert!(rim.map(|v| gaussian_curvature(&open, v)).all(f64::is_nan));
    let inside = open.vertices().filter(|v| !open.is_boundary_vertex(*v));
    assert!(inside.map(|v| mean_curvature(&open, v)).all(|h| h.abs() < 1e-9));
}

#[test]
fn the_quality_of_regular_faces_is_one() {
    for name in ["tetrahedron", "icosahedron", "dodecahedron"] {
        let mesh = shape(name, 1.0);
        assert!(mesh.faces().all(|f| (face_quality(&mesh, f) - 1.0).abs() < 1e-6), "{name}");
    }
    let sliver = mesh(&[[0., 0., 0.], [10., 0., 0.], [5., 0.1, 0.]], &[&[0, 1, 2]]);
    assert!(face_quality(&sliver, FaceId::new(0)) < 0.03);
    let rectangle = mesh(&[[0., 0., 0.], [2., 0., 0.], [2., 1., 0.], [0., 1., 0.]], &[&[0, 1, 2, 3]]);
    assert!((face_quality(&rectangle, FaceId::new(0)) - 0.8).abs() < 1e-9);
}

#[test]
fn sizes_are_the_same_in_parts() {
    for (name, values) in [("cube", [("size", 3.0)].as_slice()), ("torus", &[]), ("grid", &[])] {
        let mut shape = Shape::named(name).expect("a shape");
        for (field, value) in values {
            shape.set(field, *value).expect("in range");
        }
        let mesh = shape.build().expect("a mesh");
        let whole = SizeCounter::default().finish(&mesh);
        assert_eq!(whole.bounds, bounding_box(&mesh));
        assert_eq!((whole.area, whole.volume), (surface_area(&mesh), volume(&mesh)));
        let mut counter = SizeCounter::default();
        let mut steps = 1;
        let in_parts = loop {
            if let Some(sizes) = counter.step(&mesh, &mut Budget::new(5)) {
                break sizes;
            }
            steps += 1;
        };
        assert_eq!(in_parts, whole, "{name}");
        assert!(steps > 2, "{name}: {steps}");
    }
    assert_eq!(SizeCounter::default().finish(&Mesh::new()), Sizes::default());
    let points = PolygonSoup { positions: vec![Vec3::ZERO, Vec3::X], ..PolygonSoup::default() };
    let points = Mesh::build(points).expect("a mesh of two points").mesh;
    let sizes = SizeCounter::default().finish(&points);
    assert_eq!((sizes.isolated_vertices, sizes.area), (2, 0.0));
    assert_eq!(sizes.bounds, bounding_box(&points));
}
