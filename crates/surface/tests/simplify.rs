//! Simplifying: counts, topology, distances, attributes.

mod common;

use common::*;
use glam::{Vec2, Vec3};
use halfedge::attribute::keys;
use halfedge::geometry::PolygonTriangulator;
use halfedge::{Color, FaceId, Mesh, PolygonSoup};
use proptest::prelude::*;
use std::ops::ControlFlow;
use surface::measure::*;
use surface::normals::*;
use surface::*;

fixtures::shared_tests!(max_error_holds_between_the_points_that_are_measured);

fn to(mesh: &Mesh, target: SimplifyTarget) -> Simplified {
    let options = Simplify { target, preserve_boundary: true, preserve_seams: true };
    let result = simplify(mesh, &options, &mut never_cancel).expect("target in range");
    result.mesh.validate().expect("valid");
    assert!(result.mesh.is_compact());
    result
}

fn shape(name: &str, sizes: &[(&str, f64)]) -> Mesh {
    let mut shape = Shape::named(name).expect("listed");
    for &(field, value) in sizes {
        shape.set(field, value).expect("in range");
    }
    shape.build().expect("fits")
}

/// Components and Euler characteristic without isolated vertices, and boundary loops.
fn topology(mesh: &Mesh) -> (usize, i64, usize) {
    let isolated = mesh.vertices().filter(|&v| mesh.halfedge_from(v).is_none()).count();
    (
        mesh.components().1 - isolated,
        mesh.euler_characteristic() - isolated as i64,
        mesh.boundary_loops().len(),
    )
}

/// The largest distance from sampled points of one mesh to the other.
fn sampled_distance(from: &Mesh, to: &Mesh) -> f64 {
    finely_sampled_distance(from, to, 4)
}

/// Like [`sampled_distance`], with the sides of triangles divided into `parts`.
fn finely_sampled_distance(from: &Mesh, to: &Mesh, parts: u32) -> f64 {
    let tree = FaceTree::new(to);
    let mut worst = 0.0f64;
    let mut cut = PolygonTriangulator::new();
    for f in from.faces() {
        for &corners in cut.triangulate_face(from, f) {
            let [a, b, c] = corners.map(|h| from.position(from.from(h)));
            for i in 0..=parts {
                for j in 0..=parts - i {
                    let (u, v) = (i as f32 / parts as f32, j as f32 / parts as f32);
                    let p = a * (1.0 - u - v) + b * u + c * v;
                    worst = worst.max(tree.closest_point(to, p).expect("has faces").distance);
                }
            }
        }
    }
    worst
}

#[test]
fn reaches_the_requested_count() {
    let sphere = shape("ico-sphere", &[("subdivisions", 5.0)]);
    for faces in [10_000, 2_048, 500, 100, 20, 4] {
        let result = to(&sphere, SimplifyTarget::Faces(faces));
        assert_eq!((result.mesh.face_count(), result.shortfall()), (faces, None));
        assert_eq!(topology(&result.mesh), (1, 2, 0));
        assert!(volume(&result.mesh) > 0.0);
    }
    let ratio = to(&sphere, SimplifyTarget::Ratio(0.25));
    assert_eq!((ratio.wanted, ratio.mesh.face_count()), (Some(5120), 5120));
    assert!((volume(&ratio.mesh) / volume(&sphere) - 1.0).abs() < 1e-3);
    let odd = to(&sphere, SimplifyTarget::Faces(501));
    assert_eq!(odd.mesh.face_count(), 502);
    assert_eq!(
        odd.shortfall().as_deref(),
        Some("502 triangles, not 501: a closed mesh has an even number of them")
    );
    let least = to(&sphere, SimplifyTarget::Faces(0));
    assert!(least.mesh.face_count() >= 4 && least.shortfall().is_some());
    let already = to(&tetrahedron(), SimplifyTarget::Faces(100));
    assert_eq!(already.shortfall().as_deref(), Some("the mesh has only 4 triangles"));
    // An open mesh has odd counts too.
    let open = to(&grid(10), SimplifyTarget::Faces(31));
    assert_eq!(open.mesh.face_count(), 31);
}

/// Meshes with more than some ten thousand triangles are processed in blocks.
#[test]
fn large_meshes_are_simplified_evenly() {
    let mesh = grid(200);
    let result = to(&mesh, SimplifyTarget::Ratio(0.1)).mesh;
    assert_eq!(result.face_count(), 8000);
    assert!((surface_area(&result) - 40_000.0).abs() < 1.0);
    // No part of the plane keeps more of its triangles than another: 500 in each sixteenth.
    let mut parts = [0; 16];
    for f in result.faces() {
        let middle = face_center(&result, f) / 50.0;
        parts[middle.x as usize + 4 * middle.y as usize] += 1;
    }
    assert!(parts.iter().all(|count| (400..=600).contains(count)), "{parts:?}");

    let sphere = shape("ico-sphere", &[("subdivisions", 6.0)]);
    let result = to(&sphere, SimplifyTarget::Ratio(0.1)).mesh;
    assert_eq!(topology(&result), (1, 2, 0));
    // A chord of a triangle's size is off by its square over eight; twice that all over is generous.
    assert!(sampled_distance(&result, &sphere) < 2.5e-3);
    let areas: Vec<f64> = result.faces().map(|f| face_area(&result, f)).collect();
    let largest = areas.iter().copied().fold(0.0, f64::max);
    assert!(largest < 4.0 * surface_area(&result) / areas.len() as f64);
}

#[test]
fn seams_that_stop_it_are_named() {
    let mut mesh = shape("cube", &[]);
    mesh = subdivide_linear(&mesh, &Linear { levels: 2 }, &mut never_cancel).expect("fits");
    // Each face has its own chart: every edge is a seam.
    for h in 0..mesh.halfedge_count() {
        mesh.set(keys::CORNER_UV, h, Vec2::splat(h as f32));
    }
    let why = to(&mesh, SimplifyTarget::Faces(4)).shortfall().expect("falls short");
    assert!(why.contains("break a seam of the texture coordinates"), "{why}");
    let flat = to(&cube(), SimplifyTarget::Faces(2)).shortfall().expect("falls short");
    assert!(!flat.contains("seam"), "{flat}");
}

#[test]
fn seams_need_not_be_preserved() {
    let mut mesh = subdivide_linear(&cube(), &Linear { levels: 2 }, &mut never_cancel).expect("fits");
    for h in 0..mesh.halfedge_count() {
        mesh.set(keys::CORNER_UV, h, Vec2::splat(h as f32));
    }
    let run = |faces: usize, preserve_seams: bool| {
        let target = SimplifyTarget::Faces(faces);
        let options = Simplify { target, preserve_boundary: true, preserve_seams };
        let result = simplify(&mesh, &options, &mut never_cancel).expect("in range");
        result.mesh.validate().expect("valid");
        result
    };
    assert_eq!(run(12, true).mesh.face_count(), 192, "every vertex is where seams meet");
    let free = run(12, false);
    assert_eq!((free.mesh.face_count(), free.has_seams), (12, false));
    assert!((surface_area(&free.mesh) / surface_area(&mesh) - 1.0).abs() < 1e-5, "the shape stays");
    assert!(free.mesh.attribute(keys::CORNER_UV).is_some_and(|uv| uv.iter().all(|uv| uv.is_finite())));
    assert!(!run(2, false).shortfall().expect("falls short").contains("seam"), "no seam stops it");
}

#[test]
fn simplification_stops_at_once_where_nothing_can_go() {
    // No tetrahedron of these ten thousand can lose a triangle.
    let mut soup = halfedge::PolygonSoup::default();
    for i in 0..10_000u32 {
        let at = Vec3::new((i % 100) as f32, (i / 100) as f32, 0.0) * 3.0;
        soup.positions.extend([Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z].map(|p| at + p));
        for face in [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]] {
            soup.push_face(face.map(|v| 4 * i + v));
        }
    }
    let mesh = build(soup);
    let result = to(&mesh, SimplifyTarget::Ratio(0.1));
    assert_eq!(result.mesh.face_count(), 40_000);
    let why = result.shortfall().expect("falls short");
    assert!(why.starts_with("stopped at 40\u{a0}000 triangles, not 4\u{a0}000"), "{why}");
}

#[test]
fn flat_faces_go_first_and_edges_stay_sharp() {
    let mut cube = shape("cube", &[]);
    cube = subdivide_linear(&cube, &Linear { levels: 4 }, &mut never_cancel).expect("fits");
    let result = to(&cube, SimplifyTarget::Faces(12));
    assert_eq!(result.mesh.face_count(), 12);
    assert!((volume(&result.mesh) - 8.0).abs() < 1e-4);
    let area = surface_area(&result.mesh);
    assert!((area - 24.0).abs() < 1e-3, "{area}");
    let grid = to(&grid(20), SimplifyTarget::Faces(2));
    assert_eq!(grid.mesh.face_count(), 2);
    assert!((surface_area(&grid.mesh) - 400.0).abs() < 1e-2, "the square's outline is kept");
}

#[test]
fn a_small_spike_stays_on_a_large_surface() {
    let sphere = shape("ico-sphere", &[("subdivisions", 4.0)]);
    let mut soup = sphere.to_soup();
    // A spike inside the first triangle, half as wide as that and as high as wide: its area alone counts too little.
    let corners = [0, 1, 2].map(|k| soup.positions[soup.corners[k] as usize]);
    let middle = (corners[0] + corners[1] + corners[2]) / 3.0;
    let tip = middle + 0.5 * corners[0].distance(corners[1]) * middle.normalize();
    let first = soup.positions.len() as u32;
    soup.positions.extend(corners.map(|p| middle + (p - middle) * 0.5));
    soup.positions.push(tip);
    let mut faces: Vec<[u32; 3]> = soup.corners.as_chunks::<3>().0.to_vec();
    let outer = faces.swap_remove(0);
    for k in 0..3 {
        let (a, b) = (k, (k + 1) % 3);
        let [x, y] = [first + a as u32, first + b as u32];
        faces.extend([[outer[a], outer[b], y], [outer[a], y, x], [x, y, first + 3]]);
    }
    let spiked = build(PolygonSoup::new(soup.positions, &faces));
    let result = to(&spiked, SimplifyTarget::Ratio(0.3)).mesh;
    let off = FaceTree::new(&result).closest_point(&result, tip).expect("has faces").distance;
    let height = f64::from(tip.distance(middle));
    assert!(off < 0.2 * height, "the tip is {off} off, of {height}");
}

#[test]
fn max_error_is_a_distance() {
    let torus = shape("torus", &[("segments", 60.0), ("tube_segments", 40.0)]);
    for (error, most) in [(0.01, 1500), (0.05, 250)] {
        let result = to(&torus, SimplifyTarget::MaxError(error)).mesh;
        assert_eq!(topology(&result), (1, 0, 0));
        let distance = sampled_distance(&torus, &result).max(sampled_distance(&result, &torus));
        assert!(distance <= error, "{distance} is more than {error}");
        assert!(result.face_count() <= most, "{} triangles at {error}", result.face_count());
    }
    let grid = grid(16);
    let flat = to(&grid, SimplifyTarget::MaxError(0.01)).mesh;
    assert!(flat.face_count() <= 4, "{}", flat.face_count());
    assert!(sampled_distance(&grid, &flat) <= 0.01);
    let exact = to(&torus, SimplifyTarget::MaxError(0.0)).mesh;
    assert_eq!(exact.face_count(), 2 * torus.face_count());
}

fn max_error_holds_between_the_points_that_are_measured() {
    for (name, error, most) in
        [("alligator", 0.003, 120), ("cheburashka", 0.0005, 7000), ("fandisk", 0.02, 250), ("cow", 0.02, 300)]
    {
        let (positions, faces) = read_obj(&fixtures::shared(&format!("models/common/{name}.obj")));
        let positions = positions.iter().map(|p| p.as_vec3()).collect();
        let mesh = Mesh::build(PolygonSoup::new(positions, &faces)).expect("small").mesh;
        let mesh = to(&mesh, SimplifyTarget::Ratio(1.0)).mesh;
        let error = error * bounding_box(&mesh).expect("has vertices").diagonal();
        let result = to(&mesh, SimplifyTarget::MaxError(error)).mesh;
        assert!(result.face_count() <= most, "{name}: {} triangles", result.face_count());
        let there = finely_sampled_distance(&mesh, &result, 8);
        let back = finely_sampled_distance(&result, &mesh, 16);
        assert!(there.max(back) <= error, "{name}: {there} and {back}, more than {error}");
    }
}

#[test]
fn max_error_holds_where_the_nearest_triangle_is_around_a_fold() {
    // A strip folded over itself: a walk from a corner's old place ends on the wrong side.
    let mut soup = PolygonSoup::default();
    soup.positions.extend(
        [
            [0.0, 0.0, 3.0],
            [0.0, 1.2227526, 2.94685],
            [0.0, 2.0, 3.0],
            [0.0, 3.0, 3.0],
            [2.598076, 0.0, -1.5000002],
            [2.598076, 1.0, -1.5000002],
            [2.598076, 2.0, -1.5000002],
            [2.598076, 3.0, -1.5000002],
            [-2.6149266, 0.0, -1.4999998],
            [-2.5980763, 1.0, -1.6239247],
            [-2.3457916, 2.0, -1.4999998],
            [-2.5980763, 3.0, -1.4999998],
            [0.0, 1.2227526, 2.94685],
        ]
        .map(Vec3::from),
    );
    for face in [
        &[1, 2, 6, 5][..],
        &[2, 3, 7, 6],
        &[4, 5, 6, 10, 9, 8],
        &[6, 7, 11, 10],
        &[8, 9, 12, 0],
        &[10, 11, 3, 2],
    ] {
        soup.push_face(face.iter().copied());
    }
    let mesh = to(&Mesh::build(soup).expect("small").mesh, SimplifyTarget::Ratio(1.0)).mesh;
    for error in [0.3, 0.4686, 0.6] {
        let result = to(&mesh, SimplifyTarget::MaxError(error)).mesh;
        let distance = sampled_distance(&mesh, &result).max(sampled_distance(&result, &mesh));
        assert!(distance <= error, "{distance} is more than {error}");
    }
}

#[test]
fn seams_and_painted_borders_stay_where_they_are() {
    // Two charts that meet at x = 8, each its own unit square; and a red half above y = 8.
    let mut mesh = grid(16);
    for f in mesh.faces().collect::<Vec<_>>() {
        let center = face_center(&mesh, f);
        let right = center.x > 8.0;
        if center.y > 8.0 {
            mesh.set(keys::FACE_COLOR, f.index(), Color([255, 0, 0]));
        }
        for h in mesh.face_halfedges(f).collect::<Vec<_>>() {
            let p = mesh.position(mesh.from(h));
            let shift = if right { 100.0 } else { 0.0 };
            mesh.set(keys::CORNER_UV, h.index(), Vec2::new(p.x + shift, p.y));
        }
    }
    let result = to(&mesh, SimplifyTarget::Faces(64)).mesh;
    for f in result.faces() {
        let center = face_center(&result, f);
        let red = result.get(keys::FACE_COLOR, f.index()) == Color([255, 0, 0]);
        let corners: Vec<Vec3> = result.face_vertices(f).map(|v| result.position(v)).collect();
        assert_eq!(red, center.y > 8.0, "{f} at {corners:?}");
        for h in result.face_halfedges(f) {
            let p = result.position(result.from(h));
            let uv = result.get(keys::CORNER_UV, h.index());
            let shift = if center.x > 8.0 { 100.0 } else { 0.0 };
            assert!(uv.distance(Vec2::new(p.x + shift, p.y)) < 1e-3, "{uv} at {p}");
        }
    }
}

#[test]
fn sizes_at_the_limits_of_floats_are_no_different() {
    let sphere = shape("ico-sphere", &[("subdivisions", 3.0)]);
    for size in [1e-36, 1e-20, 1e20, 1.9e38] {
        let mut scaled = sphere.clone();
        for v in sphere.vertices() {
            scaled.set_position(v, sphere.position(v) * (size / sphere.position(v).length()));
        }
        let result = to(&scaled, SimplifyTarget::Ratio(0.1)).mesh;
        assert_eq!(result.face_count(), 128);
        let far = f64::from(size) * 1.2;
        assert!(result.positions().iter().all(|p| p.is_finite() && p.as_dvec3().length() < far), "{size}");
        let options = Remesh { iterations: 2, ..Remesh::default() };
        let remeshed = remesh(&scaled, &options, &mut never_cancel).expect("in range");
        remeshed.validate().expect("valid");
        assert!(remeshed.face_count() > 500, "{size}: {}", remeshed.face_count());
        assert!(remeshed.positions().iter().all(|p| p.is_finite() && p.as_dvec3().length() < far), "{size}");
    }
}

#[test]
fn refuses_targets_out_of_range_and_stops_when_cancelled() {
    let cube = cube();
    for target in [SimplifyTarget::Ratio(0.0), SimplifyTarget::Ratio(1.5), SimplifyTarget::Ratio(f64::NAN)] {
        let refused = simplify(
            &cube,
            &Simplify { target, preserve_boundary: true, preserve_seams: true },
            &mut never_cancel,
        );
        assert_eq!(refused.expect_err("no ratio").to_string(), "ratio must be above 0 and at most 1");
    }
    let target = SimplifyTarget::MaxError(-1.0);
    assert!(
        simplify(
            &cube,
            &Simplify { target, preserve_boundary: true, preserve_seams: true },
            &mut never_cancel
        )
        .is_err()
    );
    let sphere = shape("ico-sphere", &[("subdivisions", 5.0)]);
    let mut asked = 0;
    let mut stop = |fraction: f32| {
        asked += 1;
        if fraction > 0.2 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let target = SimplifyTarget::Faces(10);
    let stopped =
        simplify(&sphere, &Simplify { target, preserve_boundary: true, preserve_seams: true }, &mut stop);
    assert_eq!(stopped, Err(SurfaceError::Cancelled));
    assert!(asked > 3);
    let empty = to(&Mesh::new(), SimplifyTarget::Ratio(0.5));
    assert_eq!(empty.mesh, Mesh::new());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn any_mesh_keeps_its_topology(
        mesh in random_mesh(false),
        share in 0.05f64..1.0,
        preserve_boundary in any::<bool>(),
    ) {
        let before: usize = mesh.faces().map(|f| mesh.face_degree(f) - 2).sum();
        let wanted = ((before as f64 * share) as usize).max(1);
        let options = Simplify { target: SimplifyTarget::Faces(wanted), preserve_boundary, preserve_seams: true };
        let result = simplify(&mesh, &options, &mut never_cancel).expect("in range");
        result.mesh.validate().expect("valid");
        prop_assert_eq!(topology(&result.mesh), topology(&mesh));
        prop_assert!(result.mesh.face_count() >= wanted);
        prop_assert_eq!(result.shortfall().is_none(), result.mesh.face_count() == wanted);
        prop_assert!(result.mesh.faces().all(|f| result.mesh.face_degree(f) == 3));
        prop_assert!(result.mesh.faces().all(|f| face_normal(&result.mesh, f) != Vec3::ZERO));
        let again = simplify(&mesh, &options, &mut never_cancel).expect("in range");
        prop_assert_eq!(again.mesh, result.mesh);
    }

    #[test]
    fn max_error_holds_on_any_mesh(mesh in random_mesh(false), error in 0.01f64..0.5) {
        // Non-planar polygons are compared as the triangles that they are cut into.
        let triangles = to(&mesh, SimplifyTarget::Ratio(1.0)).mesh;
        prop_assume!(triangles.face_count() > 0);
        let result = to(&triangles, SimplifyTarget::MaxError(error)).mesh;
        let distance = sampled_distance(&triangles, &result).max(sampled_distance(&result, &triangles));
        prop_assert!(distance <= error, "{} is more than {}", distance, error);
    }

    #[test]
    fn attributes_are_carried(mesh in random_mesh(false)) {
        let mut mesh = mesh;
        for f in mesh.faces().collect::<Vec<_>>() {
            mesh.set(keys::FACE_GROUP, f.index(), f.raw() % 3);
            for h in mesh.face_halfedges(f).collect::<Vec<_>>() {
                let p = mesh.position(mesh.from(h));
                mesh.set(keys::CORNER_UV, h.index(), Vec2::new(p.x, p.y + (f.raw() % 2) as f32));
            }
        }
        for e in mesh.edges().collect::<Vec<_>>() {
            mesh.set(keys::EDGE_CREASE, e.index(), (e.raw() % 3) as f32);
        }
        for v in mesh.vertices().collect::<Vec<_>>() {
            mesh.set(keys::VERTEX_COLOR, v.index(), mesh.position(v));
        }
        let result = to(&mesh, SimplifyTarget::Ratio(0.6)).mesh;
        for f in result.faces() {
            prop_assert!(result.get(keys::FACE_GROUP, f.index()) < 3);
            for h in result.face_halfedges(f) {
                prop_assert!(result.get(keys::CORNER_UV, h.index()).is_finite());
            }
        }
        prop_assert!(result.vertices().all(|v| result.get(keys::VERTEX_COLOR, v.index()).is_finite()));
    }
}

#[test]
fn polygons_that_share_a_diagonal_are_cut_another_way() {
    // Two quads on the same four corners, front and back, whose usual diagonals would join the same two
    // corners: a pillow.
    let pillow =
        mesh(&[[0., 0., 0.], [1., 0., 0.], [1., 1., 0.3], [0., 1., 0.]], &[&[0, 1, 2, 3], &[0, 3, 2, 1]]);
    let result = to(&pillow, SimplifyTarget::Ratio(1.0)).mesh;
    assert_eq!(result.euler_characteristic(), 2);
    assert!(result.has_face(FaceId::new(5)));
}
