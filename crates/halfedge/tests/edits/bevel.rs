//! Bevel edges and vertices.

use crate::random::Random;
use crate::zoo::{self, counts, he, v};
use glam::{Vec2, Vec3};
use halfedge::edit::*;
use halfedge::geometry::face_area_vector;
use halfedge::{EdgeId, Mesh, Refusal, VertexId};

#[test]
fn all_edges_of_a_cube_bevel() {
    let mut mesh = zoo::cube();
    let edges: Vec<EdgeId> = mesh.edges().collect();
    let live = bevel_edges(&mut mesh, &edges, 1).unwrap();
    assert_eq!(counts(&mesh), [24, 48, 26]);
    live.slide.apply(&mut mesh, 0.25).unwrap();
    for v in mesh.vertices() {
        let mut p = mesh.position(v).abs().to_array();
        p.sort_by(f32::total_cmp);
        assert!((Vec3::from(p) - Vec3::new(0.75, 0.75, 1.0)).length() < 1e-6, "{p:?}");
    }
    assert!((live.slide.limit - 1.0).abs() < 1e-5, "{}", live.slide.limit);
}

#[test]
fn a_round_bevel_lies_on_an_arc() {
    let mut mesh = zoo::cube();
    let edge = he(&mesh, 0, 1).edge();
    let live = bevel_edges(&mut mesh, &[edge], 4).unwrap();
    // Five vertices at each end, and four faces in the strip; the ends are taken in.
    assert_eq!(counts(&mesh), [6 + 10, 11 + 5 + 8, 6 + 4]);
    live.slide.apply(&mut mesh, 0.5).unwrap();
    // The edge is along z at x = y = -1; the arc's axis is half a unit in from both faces.
    for &v in &live.made.vertices {
        let p = mesh.position(v);
        let from_axis = (p.truncate() + glam::Vec2::splat(0.5)).length();
        assert!((from_axis - 0.5).abs() < 1e-6, "{p}");
    }
    assert!((live.slide.limit - 2.0).abs() < 1e-5, "as long as the edges beside: {}", live.slide.limit);
    assert_eq!(live.slide.apply(&mut mesh, 9.0), Ok(live.slide.limit));
    counts(&mesh);
}

#[test]
fn bevels_that_end_at_vertices_of_every_valence() {
    // Valence 4: a triangle between the strip and a point on the edge opposite.
    let mut mesh = zoo::octahedron();
    let edge = he(&mesh, 0, 2).edge();
    let live = bevel_edges(&mut mesh, &[edge], 1).unwrap();
    assert_eq!(counts(&mesh), [10, 19, 11]);
    assert_eq!(live.made.removed_vertices, [v(0), v(2)]);
    // Valence 2 at both ends: the strip would have no corners.
    let mesh = zoo::coin(6);
    let edge = mesh.edges().next().unwrap();
    assert!(matches!(
        can_bevel_edges(&mesh, &[edge], 1),
        Err(Refusal::TooFewCorners(_) | Refusal::SideTaken(..))
    ));
    // Valence 2 at one end: it runs out in a point.
    let mut mesh = zoo::cube();
    let split = split_edge(&mut mesh, EdgeId::new(0), 0.5, Connect::None).unwrap();
    bevel_edges(&mut mesh, &[split.edges[0]], 3).unwrap();
    mesh.validate().unwrap();
    assert!(mesh.has_vertex(split.vertex));
    // On the boundary the strip's end is on the boundary, and a boundary edge can't be bevelled.
    let mut mesh = zoo::grid(2, 1);
    let across = he(&mesh, 1, 4).edge();
    let live = bevel_edges(&mut mesh, &[across], 2).unwrap();
    live.slide.apply(&mut mesh, 0.25).unwrap();
    assert_eq!(counts(&mesh), [10, 13, 4]);
    let rim = he(&mesh, 0, 3).edge();
    assert_eq!(can_bevel_edges(&mesh, &[rim], 1), Err(Refusal::BoundaryEdge(rim)));
    // Two, three and all edges at a pole, and a closed loop of edges round it.
    for (chosen, segments) in [(2, 1), (3, 2), (16, 3)] {
        let mut mesh = zoo::lantern(16);
        let pole: Vec<EdgeId> = mesh.vertex_edges(v(0)).step_by(16 / chosen).take(chosen).collect();
        bevel_edges(&mut mesh, &pole, segments).unwrap();
        counts(&mesh);
        assert_eq!(mesh.euler_characteristic(), 2);
        assert!(!mesh.has_vertex(v(0)));
    }
    let mut mesh = zoo::lantern(8);
    let belt: Vec<EdgeId> = (0..8).map(|i| he(&mesh, 2 + i, 2 + (i + 1) % 8).edge()).collect();
    let before = counts(&mesh);
    bevel_edges(&mut mesh, &belt, 2).unwrap();
    assert_eq!(counts(&mesh), [before[0] + 16, before[1] + 32, before[2] + 16]);
}

#[test]
fn vertices_bevel_up_to_the_middle_of_their_edges() {
    let mut mesh = zoo::cube();
    let all: Vec<VertexId> = mesh.vertices().collect();
    let live = bevel_vertices(&mut mesh, &all).unwrap();
    assert_eq!(counts(&mesh), [24, 36, 14]);
    assert!((live.slide.limit - 1.0).abs() < 1e-6);
    live.slide.apply(&mut mesh, 5.0).unwrap();
    // Clamped: the cuboctahedron, its vertices in pairs on the middles of the edges.
    for v in mesh.vertices() {
        let mut p = mesh.position(v).abs().to_array();
        p.sort_by(f32::total_cmp);
        assert!((Vec3::from(p) - Vec3::new(0.0, 1.0, 1.0)).length() < 1e-6);
    }
    // On the boundary, with one face and with two.
    let mut mesh = zoo::grid(2, 1);
    let live = bevel_vertices(&mut mesh, &[v(0), v(1)]).unwrap();
    live.slide.apply(&mut mesh, 0.25).unwrap();
    assert_eq!(counts(&mesh), [9, 11, 3]);
    assert_eq!(mesh.boundary_loops().len(), 1);
    // Two edges inside: nothing to cut off.
    let mesh = zoo::coin(5);
    assert_eq!(can_bevel_vertices(&mesh, &[v(2)]), Err(Refusal::ValenceTooLow(v(2), 2)));
}

/// Vertices of valence 3 to 9 round a flat wheel, with a rim of polygons.
fn wheel(n: u32) -> Mesh {
    let ring = |radius: f32| {
        (0..n).map(move |i| Vec3::from((Vec2::from_angle(i as f32 / n as f32 * 6.2831855) * radius, 0.0)))
    };
    let positions = [Vec3::ZERO].into_iter().chain(ring(1.0)).chain(ring(2.0)).collect();
    let faces: Vec<Vec<u32>> = (0..n)
        .flat_map(|i| {
            let j = (i + 1) % n;
            [vec![0, 1 + i, 1 + j], vec![1 + i, 1 + n + i, 1 + n + j, 1 + j]]
        })
        .collect();
    zoo::mesh(positions, &faces)
}

#[test]
fn a_bevel_ends_at_a_flat_vertex_of_four_edges_with_a_third_point() {
    for segments in 1..4 {
        let mut mesh = zoo::grid(3, 3);
        let edge = he(&mesh, 5, 6).edge();
        let live = bevel_edges(&mut mesh, &[edge], segments).unwrap();
        live.slide.apply(&mut mesh, 0.2).unwrap();
        mesh.validate().unwrap();
        assert!(!mesh.has_vertex(v(5)) && !mesh.has_vertex(v(6)));
        for third in [Vec3::new(0.8, 1.0, 0.0), Vec3::new(2.2, 1.0, 0.0)] {
            assert!(live.made.vertices.iter().any(|&v| mesh.position(v).distance(third) < 1e-6), "{third}");
        }
        assert_eq!(live.slide.limit, 1.0, "as long as the edges beside and opposite");
    }
}

#[test]
fn bevels_of_flat_meshes_leave_no_face_without_area() {
    let meshes: Vec<Mesh> = (3..10).map(wheel).chain([zoo::grid(4, 4), zoo::triangle_grid(4, 4)]).collect();
    let mut done = 0;
    for seed in 1..=1500_u64 {
        let mut random = Random::new(seed * 0x9E37_79B9);
        let start = &meshes[seed as usize % meshes.len()];
        let inner: Vec<EdgeId> = start.edges().filter(|&e| !start.is_boundary_edge(e)).collect();
        let edges: Vec<EdgeId> = (0..=random.below(4)).filter_map(|_| random.pick(&inner)).collect();
        let segments = 1 + random.below(3) as u32;
        let mut mesh = start.clone();
        let live = bevel_edges(&mut mesh, &edges, segments).unwrap();
        let width = live.slide.limit.min(1.0) * 0.1;
        live.slide.apply(&mut mesh, width).unwrap();
        mesh.validate().unwrap();
        done += 1;
        for f in mesh.faces() {
            let area = face_area_vector(&mesh, f);
            assert!(
                area.z > 1e-5,
                "seed {seed}, {segments} segments of {edges:?}: {f} has area {area}: {:?}",
                mesh.face_vertices(f).map(|v| mesh.position(v).truncate()).collect::<Vec<_>>()
            );
        }
    }
    assert!(done > 1000);
}
