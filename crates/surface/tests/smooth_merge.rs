//! Smoothing and merging close vertices.

mod common;

use common::*;
use glam::{Vec2, Vec3};
use halfedge::attribute::keys;
use halfedge::{Color, Mesh, PolygonSoup, VertexId};
use proptest::prelude::*;
use surface::measure::*;
use surface::*;

fn smoothed(mesh: &Mesh, iterations: u32, strength: f64, method: SmoothMethod) -> Mesh {
    let result = smooth(mesh, &Smooth { iterations, strength, method }, &mut never_cancel).expect("in range");
    result.validate().expect("valid");
    result
}

#[test]
fn a_full_laplacian_step_goes_to_the_mean_of_the_neighbours() {
    let cube = cube();
    let once = smoothed(&cube, 1, 1.0, SmoothMethod::Laplacian);
    // Each corner's neighbours differ from it in one coordinate.
    for v in cube.vertices() {
        assert_eq!(once.position(v), cube.position(v) / 3.0);
    }
    let half = smoothed(&cube, 1, 0.5, SmoothMethod::Laplacian);
    assert_eq!(half.position(VertexId::new(0)), cube.position(VertexId::new(0)) * (2.0 / 3.0));
    let none = Smooth { iterations: 0, strength: 0.5, method: SmoothMethod::Laplacian };
    let refused = smooth(&cube, &none, &mut never_cancel).expect_err("out of range");
    assert_eq!(refused.to_string(), "iterations must be from 1 to 10000");
}

#[test]
fn a_boundary_is_smoothed_as_a_curve() {
    let grid = grid(4);
    let once = smoothed(&grid, 1, 1.0, SmoothMethod::Laplacian);
    assert_eq!(once.position(VertexId::new(0)), Vec3::new(0.5, 0.5, 0.0));
    assert_eq!(once.position(VertexId::new(2)), grid.position(VertexId::new(2)));
    assert_eq!(once.position(VertexId::new(12)), grid.position(VertexId::new(12)));
}

#[test]
fn taubin_keeps_the_volume_that_laplacian_loses() {
    let mut shape = Shape::named("ico-sphere").expect("listed");
    shape.set("subdivisions", 4.0).expect("in range");
    let mut noisy = shape.build().expect("fits");
    let positions = (0u32..)
        .zip(noisy.positions())
        .map(|(i, &p)| p * (1.0 + 0.02 * ((i * 7919 % 101) as f32 / 50.0 - 1.0)))
        .collect();
    noisy.set_positions(positions).expect("as long");
    let before = volume(&noisy);
    let laplacian = volume(&smoothed(&noisy, 20, 0.5, SmoothMethod::Laplacian)) / before;
    let result = smoothed(&noisy, 20, 0.5, SmoothMethod::Taubin);
    let taubin = volume(&result) / before;
    assert!(laplacian < 0.98, "{laplacian}");
    assert!((taubin - 1.0).abs() < 0.005, "{taubin}");
    let rough = |mesh: &Mesh| -> f64 {
        mesh.vertices().map(|v| (f64::from(mesh.position(v).length()) - 1.0).powi(2)).sum()
    };
    assert!(rough(&result) < 0.2 * rough(&noisy));
}

#[test]
fn smoothing_takes_a_strength_from_0_to_1() {
    let still = Smooth { iterations: 3, strength: 0.0, method: SmoothMethod::Taubin };
    assert!(smooth(&cube(), &still, &mut never_cancel).expect("in range") == cube());
    for strength in [-1.0, 1.5, f64::NAN] {
        let options = Smooth { iterations: 1, strength, method: SmoothMethod::Laplacian };
        let refused = smooth(&cube(), &options, &mut never_cancel).expect_err("out of range");
        assert_eq!(refused.to_string(), "strength must be from 0 to 1");
    }
}

fn merge(mesh: &Mesh, distance: f64) -> Merged {
    let merged = merge_by_distance(mesh, distance, &mut never_cancel).expect("in range");
    merged.mesh.validate().expect("valid");
    merged
}

#[test]
fn a_cube_of_loose_faces_closes() {
    let cube = cube();
    let mut soup = PolygonSoup::default();
    for f in cube.faces() {
        let start = soup.positions.len() as u32;
        soup.positions.extend(cube.face_vertices(f).map(|v| cube.position(v) + 1e-4 * f.raw() as f32));
        soup.push_face(start..start + 4);
    }
    let mut loose = build(soup);
    for h in loose.halfedges().collect::<Vec<_>>() {
        loose.set(keys::CORNER_UV, h.index(), Vec2::splat(h.raw() as f32));
    }
    let e = loose.edges().next().expect("24 edges");
    loose.set(keys::EDGE_CREASE, e.index(), 3.0);
    for f in loose.faces().collect::<Vec<_>>() {
        loose.set(keys::FACE_COLOR, f.index(), Color([f.raw() as u8; 3]));
    }
    assert_eq!(loose.components().1, 6);
    assert_eq!(merge(&loose, 1e-6).merged, 0);
    let closed = merge(&loose, 2e-3);
    assert_eq!((closed.merged, closed.mesh.vertex_count(), closed.mesh.face_count()), (16, 8, 6));
    assert!(closed.mesh.boundary_loops().is_empty() && closed.notes.is_empty());
    assert_eq!(closed.mesh.euler_characteristic(), 2);
    assert_eq!(closed.mesh.attribute(keys::EDGE_CREASE).expect("kept").iter().sum::<f32>(), 3.0);
    for f in closed.mesh.faces() {
        assert_eq!(closed.mesh.get(keys::FACE_COLOR, f.index()), Color([f.raw() as u8; 3]));
        assert!(
            closed.mesh.face_halfedges(f).all(|h| closed.mesh.get(keys::CORNER_UV, h.index()).is_finite())
        );
    }
}

#[test]
fn coinciding_corners_leave_the_face() {
    let sliver = mesh(
        &[
            [0., 0., 0.],
            [1., 0., 0.],
            [1.001, 0., 0.],
            [1., 1., 0.],
            [5., 5., 5.],
            [5., 5.001, 5.],
            [5.001, 5., 5.],
        ],
        &[&[0, 1, 2, 3], &[4, 5, 6]],
    );
    let result = merge(&sliver, 0.01);
    assert_eq!((result.merged, result.mesh.face_count()), (3, 1));
    assert_eq!(result.mesh.face_degree(result.mesh.faces().next().expect("one")), 3);
    assert!(merge_by_distance(&sliver, -1.0, &mut never_cancel).is_err());
    assert_eq!(merge(&Mesh::new(), 1.0).mesh, Mesh::new());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn kept_vertices_are_farther_apart_than_the_distance(mesh in random_mesh(false), distance in 0f64..1.5) {
        let result = merge(&mesh, distance);
        let kept: Vec<Vec3> = result.mesh.positions().to_vec();
        // Vertices that were separated again to keep a manifold are at the same place.
        for (i, p) in kept.iter().enumerate() {
            for q in &kept[..i] {
                let apart = p.as_dvec3().distance(q.as_dvec3());
                prop_assert!(p == q || apart > distance, "{} apart", apart);
            }
        }
        for v in mesh.vertices() {
            let p = mesh.position(v).as_dvec3();
            prop_assert!(kept.iter().any(|q| q.as_dvec3().distance(p) <= distance));
        }
    }

    #[test]
    fn smoothing_keeps_connectivity_and_stays_inside(mesh in random_mesh(false), strength in 0.1f64..1.0) {
        let result = smoothed(&mesh, 3, strength, SmoothMethod::Laplacian);
        prop_assert_eq!(result.connectivity().next, mesh.connectivity().next);
        let bounds = bounding_box(&mesh).expect("not empty");
        for v in result.vertices() {
            let p = result.position(v);
            prop_assert!(p.cmpge(bounds.min - 1e-5).all() && p.cmple(bounds.max + 1e-5).all());
        }
        // Isolated vertices stay.
        for v in mesh.vertices().filter(|&v| mesh.halfedge_from(v).is_none()) {
            prop_assert_eq!(result.position(v), mesh.position(v));
        }
    }
    /// Triangles that were taken apart and moved a little merge to the same surface.
    #[test]
    fn loose_faces_merge_to_the_same_surface(mesh in random_mesh(true), off in 0f32..1e-5) {
        let mut soup = PolygonSoup::default();
        for f in mesh.faces() {
            let first = soup.positions.len() as u32;
            let shift = Vec3::splat(off * (f.raw() % 3) as f32);
            soup.positions.extend(mesh.face_vertices(f).map(|v| mesh.position(v) + shift));
            soup.push_face(first..first + mesh.face_degree(f) as u32);
        }
        let result = merge(&build(soup), 1e-3).mesh;
        prop_assert_eq!(result.face_count(), mesh.face_count());
        let rim = |mesh: &Mesh| -> f64 {
            mesh.edges().filter(|&e| mesh.is_boundary_edge(e)).map(|e| edge_length(mesh, e)).sum()
        };
        let (before, after) = (surface_area(&mesh), surface_area(&result));
        prop_assert!((after - before).abs() <= 2e-3 * before, "area from {} to {}", before, after);
        let change = (volume_from_origin(&result) - volume_from_origin(&mesh)).abs();
        prop_assert!(change <= 2e-3 * before, "volume by {}, of area {}", change, before);
        let (before, after) = (rim(&mesh), rim(&result));
        prop_assert!((after - before).abs() <= 2e-3 * before, "boundary from {} to {}", before, after);
    }

    /// Vertices move between their neighbours: the area hardly grows, and the volume of a closed surface changes by
    /// no more than the space that the surface moves over.
    #[test]
    fn smoothing_keeps_area_and_volume_in_bounds(mesh in random_mesh(true), strength in 0.1f64..1.0) {
        let result = smoothed(&mesh, 3, strength, SmoothMethod::Laplacian);
        let (before, after) = (surface_area(&mesh), surface_area(&result));
        prop_assert!(after <= 1.25 * before, "area from {} to {}", before, after);
        if mesh.boundary_loops().is_empty() {
            let moved = |v| f64::from(mesh.position(v).distance(result.position(v)));
            let farthest = mesh.vertices().map(moved).fold(0.0, f64::max);
            let change = (volume(&result) - volume(&mesh)).abs();
            prop_assert!(change <= farthest * before, "volume by {}, of area {}", change, before);
        }
    }
}
