//! Loop cut.

use crate::zoo::{self, counts, he, v};
use glam::Vec3;
use halfedge::edit::*;
use halfedge::{EdgeId, Refusal, VertexId};

#[test]
fn a_closed_ring_is_cut_all_round() {
    let mut mesh = zoo::torus(6, 4);
    let edge = he(&mesh, 0, 1).edge();
    let (ring, closed) = edge_ring(&mesh, edge);
    assert_eq!((ring.len(), closed), (6, true));
    let made = loop_cut(&mut mesh, edge, 2, 0.5).unwrap();
    assert_eq!((made.vertices.len(), made.edges.len(), made.faces.len()), (12, 24, 12));
    assert_eq!(counts(&mesh), [36, 72, 36]);
}

#[test]
fn an_open_ring_ends_on_the_boundary() {
    let mut mesh = zoo::grid(3, 2);
    let edge = he(&mesh, 0, 1).edge();
    let (ring, closed) = edge_ring(&mesh, edge);
    assert_eq!((ring.len(), closed), (3, false));
    // The cut lies at t along the even half-edge.
    let along = edge.halfedge();
    let (from, to) = (mesh.position(mesh.from(along)), mesh.position(mesh.to(along)));
    let made = loop_cut(&mut mesh, edge, 1, 0.25).unwrap();
    assert_eq!(counts(&mesh), [15, 22, 8]);
    let x = from.lerp(to, 0.25).x;
    assert!(made.vertices.iter().all(|&v| mesh.position(v).x == x));
    // Several cuts are evenly spaced for t = 1/2.
    let mut mesh = zoo::grid(1, 1);
    let edge = he(&mesh, 0, 1).edge();
    let mut at: Vec<f32> =
        loop_cut(&mut mesh, edge, 3, 0.5).unwrap().vertices.iter().map(|&v| mesh.position(v).x).collect();
    at.sort_by(f32::total_cmp);
    assert_eq!(at, [0.25, 0.25, 0.5, 0.5, 0.75, 0.75]);
}

#[test]
fn a_ring_ends_at_faces_that_are_not_quads() {
    let mut mesh = zoo::lantern(5);
    let upright = he(&mesh, 2, 7).edge();
    // The ring round the belt is closed; the one up and down runs from fan to fan.
    assert!(edge_ring(&mesh, upright).1);
    let across = he(&mesh, 2, 3).edge();
    let (ring, closed) = edge_ring(&mesh, across);
    assert_eq!((ring.len(), closed), (2, false));
    loop_cut(&mut mesh, across, 3, 0.5).unwrap();
    assert_eq!(counts(&mesh), [18, 34, 18]);
    assert_eq!(mesh.faces().filter(|&f| mesh.face_degree(f) == 6).count(), 2);
}

#[test]
fn a_ring_that_crosses_itself_makes_grids() {
    for cuts in 1..4u32 {
        let mut mesh = zoo::trefoil();
        let (ring, closed) = edge_ring(&mesh, EdgeId::new(0));
        assert_eq!((ring.len(), closed), (6, true));
        loop_cut(&mut mesh, EdgeId::new(0), cuts, 0.3).unwrap();
        let n = cuts as usize;
        let faces = 3 * (n + 1) * (n + 1);
        assert_eq!(counts(&mesh), [5 + 6 * n + 3 * n * n, 2 * faces, faces]);
        assert!(mesh.faces().all(|f| mesh.face_degree(f) == 4));
        // Rows and columns of a grid are straight: each crossing lies between its neighbours.
        let crossings: Vec<VertexId> = mesh.vertices().skip(5 + 6 * n).collect();
        assert_eq!(crossings.len(), 3 * n * n);
        for crossing in crossings {
            let around: Vec<Vec3> = mesh.outgoing(crossing).map(|h| mesh.position(mesh.to(h))).collect();
            let [a, b, c, d] = *around.as_slice() else { panic!("{crossing:?} has {} edges", around.len()) };
            for (one, other) in [(a, c), (b, d)] {
                let at = mesh.position(crossing);
                assert!(one.distance(at) + at.distance(other) - one.distance(other) < 1e-5, "{crossing:?}");
            }
        }
    }
}

#[test]
fn no_quad_no_ring() {
    let mesh = zoo::octahedron();
    let edge = he(&mesh, 0, 2).edge();
    assert_eq!(edge_ring(&mesh, edge).0.len(), 1);
    assert_eq!(can_loop_cut(&mesh, edge, 1, 0.5), Err(Refusal::NoRing(edge)));
    let mesh = zoo::grid(1, 1);
    let edge = mesh.find_edge(v(0), v(1)).unwrap();
    for (cuts, t) in [(0, 0.5), (1001, 0.5), (1, 0.0), (1, 1.0), (1, f32::NAN)] {
        assert!(matches!(can_loop_cut(&mesh, edge, cuts, t), Err(Refusal::OutOfRange { .. })));
    }
}
