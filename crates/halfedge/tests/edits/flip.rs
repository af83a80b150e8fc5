//! Flip edge.

use crate::zoo::{self, he, v};
use halfedge::Refusal;
use halfedge::edit::*;

#[test]
fn a_flip_between_two_triangles_is_the_usual_one_and_two_give_the_same_faces() {
    // The square 0 1 3 2 with the diagonal 0 3.
    let start = zoo::triangle_grid(1, 1);
    let mut mesh = start.clone();
    let edge = he(&mesh, 0, 3).edge();
    let [a, b] = mesh.ends(edge);
    flip_edge(&mut mesh, edge).unwrap();
    mesh.validate().unwrap();
    assert_eq!(zoo::faces(&mesh), [[0, 1, 2], [1, 3, 2]]);
    // Each end moved one step counter-clockwise round the square 0 1 3 2.
    let step = |u| [1, 3, 0, 2][[0, 1, 2, 3].iter().position(|&w| v(w) == u).unwrap()];
    assert_eq!(mesh.ends(edge), [v(step(a)), v(step(b))]);
    flip_edge(&mut mesh, edge).unwrap();
    mesh.validate().unwrap();
    assert_eq!(zoo::faces(&mesh), zoo::faces(&start));
    assert_eq!(mesh.ends(edge), [b, a]);
}

#[test]
fn a_flip_between_polygons_turns_the_edge_round_their_union() {
    // Two quads side by side: 0 1 2 below, 3 4 5 above; the edge 1 4 between.
    let mut mesh = zoo::grid(2, 1);
    let edge = he(&mesh, 1, 4).edge();
    // Round the union 0 1 2 5 4 3, 1 goes to 2 and 4 to 3, 2 to 5 and 3 to 0, and then back.
    for (ends, faces) in [
        ([2, 3], [[0, 1, 2, 3], [2, 5, 4, 3]]),
        ([0, 5], [[0, 1, 2, 5], [0, 5, 4, 3]]),
        ([1, 4], [[0, 1, 4, 3], [1, 2, 5, 4]]),
    ] {
        flip_edge(&mut mesh, edge).unwrap();
        mesh.validate().unwrap();
        let mut now = mesh.ends(edge).map(|v| v.raw());
        now.sort_unstable();
        assert_eq!(now, ends);
        assert_eq!(zoo::faces(&mesh), faces);
    }
}

#[test]
fn a_flip_that_would_duplicate_an_edge_is_refused() {
    let mut mesh = zoo::octahedron();
    let first = he(&mesh, 0, 2).edge();
    flip_edge(&mut mesh, first).unwrap();
    assert!(mesh.find_edge(v(4), v(5)).is_some());
    // The opposite edge 1 3 lies between 4 and 5 too.
    let opposite = he(&mesh, 1, 3).edge();
    let refusal = flip_edge(&mut mesh, opposite).unwrap_err();
    assert!(matches!(refusal, Refusal::AlreadyJoined(..)), "{refusal}");
}

#[test]
fn flips_at_vertices_with_too_few_edges_are_refused() {
    // All vertices of a tetrahedron have three edges, all of a coin two.
    for mesh in [zoo::tetrahedron(), zoo::coin(5), zoo::pillow()] {
        for edge in mesh.edges() {
            assert!(matches!(can_flip_edge(&mesh, edge), Err(Refusal::ValenceTooLow(..))));
        }
    }
    // Inside a quad mesh a vertex may go from three edges to two.
    let mut mesh = zoo::cube();
    flip_edge(&mut mesh, halfedge::EdgeId::new(0)).unwrap();
    mesh.validate().unwrap();
    assert_eq!(mesh.vertices().filter(|&v| mesh.valence(v) == 2).count(), 2);
}

#[test]
fn faces_that_share_another_corner_beyond_the_edge_are_refused() {
    // The faces (0 1 2 3) and (1 0 5 3 4) share the edge 0 1 and the corner 3.
    let p = (0..6).map(|i| glam::Vec3::new(i as f32, (i * i) as f32, (i % 2) as f32)).collect();
    let faces: [&[u32]; 5] = [&[0, 1, 2, 3], &[1, 0, 5, 3, 4], &[1, 4, 2], &[2, 4, 3], &[0, 3, 5]];
    let mesh = zoo::mesh(p, &faces);
    let edge = he(&mesh, 0, 1).edge();
    can_flip_edge(&mesh, edge).unwrap();
    // The first flip is possible; a second one would give a face the corner 3 twice.
    let mut mesh = mesh;
    flip_edge(&mut mesh, edge).unwrap();
    mesh.validate().unwrap();
    let refusal = flip_edge(&mut mesh, edge).unwrap_err();
    assert!(matches!(refusal, Refusal::RepeatedCorner(_)), "{refusal}");
}

#[test]
fn a_boundary_edge_is_refused() {
    let mesh = zoo::triangle();
    for edge in mesh.edges() {
        assert_eq!(can_flip_edge(&mesh, edge), Err(Refusal::BoundaryEdge(edge)));
    }
}
