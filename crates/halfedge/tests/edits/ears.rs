//! Triangulation.

use crate::touching::{Growth, comb};
use crate::zoo::{self, v};
use glam::Vec3;
use halfedge::edit::*;
use halfedge::{FaceId, Mesh, Refusal};
use proptest::prelude::*;

fn polygon(points: &[[f32; 2]]) -> Mesh {
    let positions = points.iter().map(|p| Vec3::new(p[0], p[1], 0.0)).collect();
    zoo::mesh(positions, &[(0..points.len() as u32).collect::<Vec<_>>()])
}

/// Twice the signed areas of the faces, seen from above.
fn areas(mesh: &Mesh) -> Vec<f32> {
    mesh.faces()
        .map(|f| {
            mesh.face_halfedges(f)
                .map(|h| {
                    mesh.position(mesh.from(h)).truncate().perp_dot(mesh.position(mesh.to(h)).truncate())
                })
                .sum()
        })
        .collect()
}

fn check_ears(points: &[[f32; 2]]) {
    let mut mesh = polygon(points);
    let whole: f32 = areas(&mesh).iter().sum();
    let made = triangulate_face(&mut mesh, FaceId::new(0), Triangulation::Ears).unwrap();
    mesh.validate().unwrap();
    assert_eq!(made.faces.len(), points.len() - 3);
    assert!(mesh.faces().all(|f| mesh.face_degree(f) == 3));
    let parts = areas(&mesh);
    assert!(parts.iter().all(|&area| area > 0.0), "{points:?}: {parts:?}");
    let sum: f32 = parts.iter().sum();
    assert!((sum - whole).abs() < whole * 1e-5, "{points:?}: {sum} for {whole}");
}

#[test]
fn concave_polygons() {
    check_ears(&[[0.0, 0.0], [4.0, 0.0], [4.0, 1.0], [1.0, 1.0], [1.0, 4.0], [0.0, 4.0]]);
    check_ears(&[[0.0, 0.0], [2.0, 1.0], [4.0, 0.0], [2.0, 4.0]]);
    // A comb.
    let mut comb = vec![[0.0, -1.0], [10.0, -1.0]];
    for i in (0..10).rev() {
        comb.extend([[i as f32 + 0.9, 3.0], [i as f32 + 0.1, 0.0]]);
    }
    check_ears(&comb);
    // A spiral.
    let point = |i: usize, r: f32| {
        let angle = i as f32 * 0.35;
        [(r + angle) * angle.cos(), (r + angle) * angle.sin()]
    };
    let mut spiral: Vec<[f32; 2]> = (0..40).map(|i| point(i, 3.0)).collect();
    spiral.extend((0..40).rev().map(|i| point(i, 2.0)));
    check_ears(&spiral);
    // Corners at straight angles.
    check_ears(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.5, 2.0], [0.0, 1.0]]);
}

#[test]
fn polygons_that_touch_themselves() {
    // A square with a square hole; the outline runs along a slit between them twice.
    check_ears(&[
        [0.0, 0.0],
        [4.0, 0.0],
        [4.0, 4.0],
        [0.0, 4.0],
        [0.0, 0.0],
        [1.0, 1.0],
        [1.0, 3.0],
        [3.0, 3.0],
        [3.0, 1.0],
        [1.0, 1.0],
    ]);
    // Two triangles that touch at a corner: two of the four triangles have no area, none is turned over.
    let mut mesh = polygon(&[[0.0, 0.0], [2.0, 0.0], [1.0, 1.0], [2.0, 2.0], [0.0, 2.0], [1.0, 1.0]]);
    triangulate_face(&mut mesh, FaceId::new(0), Triangulation::Ears).unwrap();
    mesh.validate().unwrap();
    let mut parts = areas(&mesh);
    parts.sort_by(f32::total_cmp);
    assert_eq!(parts, [0.0, 0.0, 2.0, 2.0]);
}

/// Checks that no triangle of a polygon is turned over. It follows that they cover the polygon, because signed areas add up
/// to its own.
fn check_touching(points: &[[f32; 2]]) {
    // In a tilted plane too, where rounding keeps corners from lying on sides exactly.
    for tilt in [0.0, 0.3] {
        let positions = points.iter().map(|p| Vec3::new(p[0], p[1], (p[0] * 1.1 - p[1]) * tilt)).collect();
        check_covered(zoo::mesh(positions, &[(0..points.len() as u32).collect::<Vec<_>>()]), points);
    }
}

fn check_covered(mut mesh: Mesh, points: &[[f32; 2]]) {
    let whole: f32 = areas(&mesh).iter().sum();
    triangulate_face(&mut mesh, FaceId::new(0), Triangulation::Ears).unwrap();
    mesh.validate().unwrap();
    assert!(mesh.faces().all(|f| mesh.face_degree(f) == 3));
    let parts = areas(&mesh);
    let covered: f32 = parts.iter().map(|area| area.abs()).sum();
    assert!(parts.iter().all(|&area| area >= 0.0), "{points:?}: {parts:?}");
    assert_eq!(covered, whole, "{points:?}");
}

#[test]
fn polygons_that_touch_themselves_in_other_ways() {
    for points in [
        // Two squares that touch at a corner.
        &[[0., 0.], [1., 0.], [1., 1.], [2., 1.], [2., 2.], [1., 2.], [1., 1.], [0., 1.]][..],
        // Corners that touch corners, and one that touches a side.
        &[[0., 0.], [2., 1.], [4., 0.], [4., 4.], [2., 1.], [0., 4.]],
        &[[0., 0.], [4., 0.], [4., 4.], [3., 4.], [2., 0.], [1., 4.], [0., 4.]],
        // Spikes: out along a side, into the inside.
        &[[0., 0.], [2., 0.], [4., 0.], [6., 0.], [4., 0.], [4., 4.], [0., 4.]],
        &[[0., 0.], [4., 0.], [4., 4.], [2., 4.], [2., 2.], [2., 4.], [0., 4.]],
        // Corners at the same place, and a polygon without area.
        &[[0., 0.], [1., 0.], [1., 0.], [1., 1.], [0., 1.]],
        &[[0., 0.], [1., 0.], [2., 0.], [3., 0.], [2., 0.]],
    ] {
        // Starting at each corner.
        for start in 0..points.len() {
            let mut turned = points.to_vec();
            turned.rotate_left(start);
            check_touching(&turned);
        }
    }
}

#[test]
fn random_star_shapes() {
    let mut state = 12345u32;
    for n in 4..60 {
        let points: Vec<[f32; 2]> = (0..n)
            .map(|i| {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                let r = 1.0 + (state >> 16) as f32 / 8192.0;
                let angle = i as f32 / n as f32 * std::f32::consts::TAU;
                [r * angle.cos(), r * angle.sin()]
            })
            .collect();
        check_ears(&points);
    }
}

#[test]
fn a_fan_along_an_edge_that_is_there_is_refused_and_ears_go_round_it() {
    // Two squares back to back, the front cut along the diagonal that the back's fan needs.
    let corners = vec![Vec3::ZERO, Vec3::X, Vec3::new(1.0, 1.0, 0.0), Vec3::Y];
    let faces: [&[u32]; 3] = [&[0, 1, 3], &[1, 2, 3], &[3, 2, 1, 0]];
    let mesh = zoo::mesh(corners, &faces);
    let back = FaceId::new(2);
    assert_eq!(
        can_triangulate_face(&mesh, back, Triangulation::Fan),
        Err(Refusal::AlreadyJoined(v(3), v(1)))
    );
    for by in [Triangulation::Ears, Triangulation::Auto] {
        let mut mesh = mesh.clone();
        let made = triangulate_face(&mut mesh, back, by).unwrap();
        mesh.validate().unwrap();
        assert_eq!(made.edges, [mesh.find_edge(v(0), v(2)).expect("the other diagonal")]);
    }
}

#[test]
fn a_face_whose_corners_are_all_joined_is_refused() {
    let mut mesh = zoo::complete_torus();
    delete_vertices(&mut mesh, &[v(6)]).unwrap();
    let hole = mesh.boundary_loops()[0];
    let filled = fill_hole(&mut mesh, hole).unwrap();
    mesh.validate().unwrap();
    assert_eq!(mesh.face_degree(filled.faces[0]), 6);
    assert_eq!(
        can_triangulate_face(&mesh, filled.faces[0], Triangulation::Ears),
        Err(Refusal::NoTriangulation(filled.faces[0]))
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn squares_joined_at_corners_with_slits_and_spikes(
        moves in prop::collection::vec(any::<u32>(), 1..40),
        start: prop::sample::Index,
    ) {
        check_grown(&moves, start);
    }

    #[test]
    fn combs_whose_teeth_touch(heights in prop::collection::vec(0u8..4, 1..80), start: prop::sample::Index) {
        let mut points = comb(&heights);
        points.rotate_left(start.index(heights.len()));
        check_touching(&points);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    // More corners than the best triangulation is searched for.
    #[test]
    fn many_squares_joined_at_corners(
        moves in prop::collection::vec(any::<u32>(), 100..300),
        start: prop::sample::Index,
    ) {
        check_grown(&moves, start);
    }
}

fn check_grown(moves: &[u32], start: prop::sample::Index) {
    let growth = Growth::new(moves);
    let mut points = growth.points();
    let doubled: f32 =
        points.iter().zip(points.iter().cycle().skip(1)).map(|(a, b)| a[0] * b[1] - b[0] * a[1]).sum();
    assert_eq!(doubled, 2.0 * growth.area(), "a check of the test itself");
    let first = start.index(points.len());
    points.rotate_left(first);
    check_touching(&points);
}
