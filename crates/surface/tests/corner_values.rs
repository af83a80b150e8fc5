//! Corner values follow operations on whole meshes: on flat meshes whose texture coordinates are a linear function of
//! position, they still are that function afterwards, each island of the texture its own.
//!
//! Where this can't hold, and why:
//!
//! - Smoothing moves vertices and keeps their values, as `transform` does: the texture moves with the surface.
//! - Catmull-Clark and Loop subdivision interpolate values linearly and positions by smooth rules. These agree where
//!   the mesh is regular, not along boundaries.

mod common;

use common::*;
use glam::{Vec2, Vec3};
use halfedge::attribute::Column;
use halfedge::{Element, FaceId, Mesh, keys};
use proptest::prelude::*;
use surface::*;

/// The value at a position on an island.
fn function(island: u32, position: Vec3) -> Vec2 {
    let Vec3 { x, y, .. } = position;
    match island {
        0 => Vec2::new(0.1 * x + 0.05 * y, 0.2 - 0.15 * y),
        _ => Vec2::new(3.0 - 0.2 * y, 5.0 + 0.1 * x),
    }
}

/// A grid of `n` by `n` quads, its inner vertices moved by up to a third; the faces right of a line on island 1.
fn flat(n: u32, moves: &[(f32, f32)], line: Option<u32>) -> Mesh {
    let mut mesh = grid(n);
    let inner: Vec<_> = mesh.vertices().filter(|&v| !mesh.is_boundary_vertex(v)).collect();
    let islands = (0..mesh.face_capacity() as u32).map(|f| u32::from(line.is_some_and(|line| f % n >= line)));
    let islands: Vec<u32> = islands.collect();
    for (v, &(x, y)) in inner.into_iter().zip(moves.iter().cycle()) {
        mesh.set_position(v, mesh.position(v) + Vec3::new(x, y, 0.0));
    }
    mesh.insert_column(Element::Face, Column::with_values(keys::FACE_GROUP, islands));
    for h in mesh.halfedges().collect::<Vec<_>>() {
        if let Some(f) = mesh.face_of(h) {
            let value = function(island(&mesh, f), mesh.position(mesh.from(h)));
            mesh.set(keys::CORNER_UV, h.index(), value);
        }
    }
    mesh
}

fn island(mesh: &Mesh, f: FaceId) -> u32 {
    mesh.get(keys::FACE_GROUP, f.index())
}

/// The largest distance of a value from its function, among corners at these positions.
fn largest_error(mesh: &Mesh, counts: impl Fn(Vec3) -> bool) -> f32 {
    let mut largest = 0.0_f32;
    let mut corners = 0;
    for f in mesh.faces() {
        for h in mesh.face_halfedges(f) {
            let position = mesh.position(mesh.from(h));
            let error = mesh.get(keys::CORNER_UV, h.index()).distance(function(island(mesh, f), position));
            assert!(!error.is_nan());
            if counts(position) {
                largest = largest.max(error);
                corners += 1;
            }
        }
    }
    assert!(corners > 10, "{corners}");
    largest
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn linear_values_stay_linear(
        moves in proptest::collection::vec((-0.3f32..0.3, -0.3f32..0.3), 5..30),
        line in proptest::option::of(1u32..6),
        length in 0.4f64..1.5,
        ratio in 0.2f64..0.9,
    ) {
        let mesh = flat(6, &moves, line);
        let everywhere = |_: Vec3| true;
        let linear = subdivide_linear(&mesh, &Linear { levels: 2 }, &mut never_cancel).unwrap();
        prop_assert!(largest_error(&linear, everywhere) < 1e-5);
        let options = Remesh { edge_length: Some(length), ..Remesh::default() };
        let remeshed = remesh(&mesh, &options, &mut never_cancel).unwrap();
        prop_assert!(largest_error(&remeshed, everywhere) < 1e-4, "{}", largest_error(&remeshed, everywhere));
        let target = SimplifyTarget::Ratio(ratio);
        let options = Simplify { target, preserve_boundary: true, preserve_seams: true };
        let simplified = simplify(&mesh, &options, &mut never_cancel).unwrap().mesh;
        prop_assert!(largest_error(&simplified, everywhere) < 1e-4, "{}", largest_error(&simplified, everywhere));
        let merged = merge_by_distance(&mesh, 0.0, &mut never_cancel).unwrap().mesh;
        prop_assert!(largest_error(&merged, everywhere) < 1e-5);
    }
}

#[test]
fn smooth_subdivision_is_linear_where_the_mesh_is_regular() {
    let mesh = flat(8, &[(0.0, 0.0)], Some(4));
    let is_inside = |p: Vec3| [p.x, p.y].iter().all(|x| (2.0..=6.0).contains(x));
    let options = CatmullClark { levels: 2, ..CatmullClark::default() };
    let subdivided = subdivide_catmull_clark(&mesh, &options, &mut never_cancel).unwrap();
    assert!(largest_error(&subdivided, is_inside) < 1e-5);
}

/// A vertex on a seam that isn't straight leaves the edge that it was made on.
#[test]
fn values_at_a_zigzag_seam_follow_splits() {
    let mut moves = [(0.0, 0.0); 15];
    moves[1].1 = -0.231;
    moves[2].0 = -0.122;
    moves[4].1 = -0.284;
    moves[6].1 = -0.210;
    moves[7].0 = 0.176;
    moves[8].0 = 0.192;
    moves[12].1 = 0.074;
    let mesh = flat(6, &moves, Some(3));
    let options = Remesh { edge_length: Some(1.362), ..Remesh::default() };
    let remeshed = remesh(&mesh, &options, &mut never_cancel).unwrap();
    assert!(largest_error(&remeshed, |_| true) < 1e-4);
}

/// The best place for a vertex on such a seam isn't on the edge that was merged either.
#[test]
fn values_at_a_zigzag_seam_follow_merges() {
    let mut moves = [(0.0, 0.0); 11];
    moves[0] = (-0.104_375_75, 0.161_205_13);
    moves[5] = (-0.154_757_77, -0.082_657_7);
    moves[6] = (-0.012_298_234, -0.214_184_08);
    moves[10] = (-0.285_104_33, 0.0);
    let mesh = flat(6, &moves, Some(2));
    let target = SimplifyTarget::Ratio(0.2);
    let options = Simplify { target, preserve_boundary: true, preserve_seams: true };
    let simplified = simplify(&mesh, &options, &mut never_cancel).unwrap().mesh;
    assert!(largest_error(&simplified, |_| true) < 1e-4);
}
