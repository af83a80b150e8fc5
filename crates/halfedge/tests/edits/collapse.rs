//! Collapse edge, collapse face, split vertex, merge vertices.

use crate::zoo::{self, counts, he, v};
use glam::Vec3;
use halfedge::edit::*;
use halfedge::{EdgeId, Mesh, Refusal};

#[test]
fn a_tetrahedron_collapses_once() {
    for edge in 0..6 {
        let mut mesh = zoo::tetrahedron();
        let made = collapse_edge(&mut mesh, EdgeId::new(edge), 0.5).unwrap();
        assert_eq!((made.removed_edges.len(), made.removed_faces.len()), (3, 2));
        assert_eq!(counts(&mesh), [3, 3, 2]);
        for edge in mesh.edges() {
            let refusal = can_collapse_edge(&mesh, edge, 0.5).unwrap_err();
            assert!(matches!(refusal, Refusal::LeftWithoutFace(_)), "{refusal}");
        }
    }
}

#[test]
fn a_collapse_that_would_pinch_is_refused() {
    // The diagonal of a single square joins two boundary vertices through the inside.
    let mesh = zoo::triangle_grid(1, 1);
    let diagonal = he(&mesh, 0, 3).edge();
    assert_eq!(can_collapse_edge(&mesh, diagonal, 0.5), Err(Refusal::JoinsBoundaries(diagonal)));
    // So do the edge across a strip of quads, and one from the outer to the inner boundary of a frame.
    let mesh = zoo::grid(2, 1);
    let across = he(&mesh, 1, 4).edge();
    assert_eq!(can_collapse_edge(&mesh, across, 0.5), Err(Refusal::JoinsBoundaries(across)));
    let mesh = zoo::frame();
    let across = he(&mesh, 1, 5).edge();
    assert_eq!(can_collapse_edge(&mesh, across, 0.5), Err(Refusal::JoinsBoundaries(across)));
}

#[test]
fn an_edge_on_the_boundary_collapses() {
    let mut mesh = zoo::grid(2, 1);
    let edge = he(&mesh, 0, 1).edge();
    collapse_edge(&mut mesh, edge, 0.0).unwrap();
    assert_eq!(counts(&mesh), [5, 6, 2]);
    assert_eq!(mesh.boundary_loops().len(), 1);
    // A triangle beside the boundary vanishes.
    let mut mesh = zoo::triangle_grid(2, 1);
    let edge = he(&mesh, 0, 1).edge();
    collapse_edge(&mut mesh, edge, 1.0).unwrap();
    assert_eq!(counts(&mesh), [5, 7, 3]);
}

#[test]
fn an_isolated_triangle_does_not_collapse() {
    let mesh = zoo::triangle();
    for edge in mesh.edges() {
        assert!(matches!(can_collapse_edge(&mesh, edge, 0.5), Err(Refusal::LeftWithoutFace(_))));
    }
    // At the tip of a strip two edges of a triangle are on the boundary.
    let mesh = zoo::triangle_grid(1, 1);
    let tip = mesh.vertices().find(|&v| mesh.valence(v) == 2).unwrap();
    for edge in mesh.vertex_edges(tip) {
        // The third edge is inside, so these can collapse.
        can_collapse_edge(&mesh, edge, 0.5).unwrap();
    }
}

#[test]
fn a_ring_of_three_edges_that_is_no_face_is_refused() {
    let mesh = zoo::torus(3, 5);
    let round = he(&mesh, 0, 5).edge();
    assert!(matches!(can_collapse_edge(&mesh, round, 0.5), Err(Refusal::AlreadyJoined(..))));
}

#[test]
fn a_far_face_with_both_ends_is_refused() {
    let mesh = zoo::cut_coin();
    let cut = he(&mesh, 0, 3).edge();
    assert_eq!(can_collapse_edge(&mesh, cut, 0.5), Err(Refusal::RepeatedCorner(mesh.ends(cut)[0])));
}

#[test]
fn polygons_lose_a_corner() {
    let mut mesh = zoo::cube();
    let edge = he(&mesh, 0, 1).edge();
    let [a, b] = mesh.ends(edge);
    let at = mesh.position(a).lerp(mesh.position(b), 0.25);
    let made = collapse_edge(&mut mesh, edge, 0.25).unwrap();
    assert_eq!((made.vertex, made.removed_vertex), (a, b));
    assert_eq!(counts(&mesh), [7, 11, 6]);
    assert_eq!(mesh.position(a), at);
    assert_eq!(mesh.faces().filter(|&f| mesh.face_degree(f) == 3).count(), 2);
}

#[test]
fn vertices_with_two_or_three_edges_collapse() {
    let mut mesh = zoo::coin(7);
    for left in (3..7).rev() {
        let edge = mesh.edges().next().unwrap();
        collapse_edge(&mut mesh, edge, 0.5).unwrap();
        assert_eq!(counts(&mesh), [left, left, 2]);
    }
    let edge = mesh.edges().next().unwrap();
    assert!(matches!(can_collapse_edge(&mesh, edge, 0.5), Err(Refusal::LeftWithoutFace(_))));
    // A vertex with two edges beside a triangle and a quad: the triangle vanishes, and the quad becomes one.
    let mut mesh = zoo::coin(4);
    connect_vertices(&mut mesh, v(0), v(2)).unwrap();
    let edge = he(&mesh, 0, 1).edge();
    collapse_edge(&mut mesh, edge, 0.5).unwrap();
    assert_eq!(counts(&mesh), [3, 3, 2]);
    // Valence three in a triangle mesh: collapsing a spoke removes the vertex.
    let mut mesh = zoo::triangle_grid(2, 2);
    let face = mesh.faces().next().unwrap();
    let before = zoo::faces(&mesh);
    let poked = poke_faces(&mut mesh, &[face]).unwrap();
    let spoke = mesh.vertex_edges(poked.vertices[0]).next().unwrap();
    let t = if mesh.ends(spoke)[0] == poked.vertices[0] { 1.0 } else { 0.0 };
    collapse_edge(&mut mesh, spoke, t).unwrap();
    mesh.validate().unwrap();
    assert_eq!(mesh.face_count(), before.len());
}

#[test]
fn splitting_a_vertex_undoes_a_collapse() {
    // Every edge of a triangle mesh that can collapse, inside and on the boundary.
    let start = zoo::triangle_grid(4, 4);
    let mut tried = [0, 0];
    for edge in start.edges().filter(|&e| can_collapse_edge(&start, e, 0.5).is_ok()) {
        let mut mesh = start.clone();
        let [a, b] = mesh.ends(edge);
        let tips: Vec<_> = edge
            .halfedges()
            .into_iter()
            .filter(|&h| !mesh.is_boundary_halfedge(h))
            .map(|h| mesh.to(mesh.next(h)))
            .collect();
        collapse_edge(&mut mesh, edge, 0.5).unwrap();
        let spokes: Vec<EdgeId> = tips.iter().map(|&tip| mesh.find_edge(a, tip).unwrap()).collect();
        let (first, last) = (spokes[0], spokes[spokes.len() - 1]);
        let positions = [start.position(a), start.position(b)];
        let same = [[first, last], [last, first]].into_iter().any(|edges| {
            // Either of the two can be the new vertex.
            [positions, [positions[1], positions[0]]].into_iter().any(|positions| {
                let mut again = mesh.clone();
                split_vertex(&mut again, a, edges, Some(positions)).unwrap();
                again.validate().unwrap();
                geometry(&again) == geometry(&start)
            })
        });
        tried[usize::from(start.is_boundary_edge(edge))] += 1;
        assert!(same, "{edge}");
    }
    assert!(tried.iter().all(|&n| n > 5), "{tried:?}");
}

/// The faces by the positions of their corners, in half units.
fn geometry(mesh: &Mesh) -> Vec<Vec<[i32; 3]>> {
    let mut all: Vec<Vec<[i32; 3]>> = mesh
        .faces()
        .map(|f| {
            let mut corners: Vec<_> =
                mesh.face_vertices(f).map(|v| (mesh.position(v) * 2.0).as_ivec3().to_array()).collect();
            let first = (0..corners.len()).min_by_key(|&i| corners[i]).unwrap();
            corners.rotate_left(first);
            corners
        })
        .collect();
    all.sort();
    all
}

#[test]
fn split_vertex_beside_the_boundary() {
    let mut mesh = zoo::triangle();
    let edges: Vec<EdgeId> = mesh.vertex_edges(v(0)).collect();
    // The same edge twice: one triangle more, beside the boundary.
    let made = split_vertex(&mut mesh, v(0), [edges[0], edges[0]], None).unwrap();
    assert_eq!((made.vertices.len(), made.faces.len()), (1, 1));
    assert_eq!(counts(&mesh), [4, 5, 2]);
    // Inside the mesh the same edge can't be given twice.
    let mut mesh = zoo::tetrahedron();
    let edge = mesh.vertex_edges(v(0)).next().unwrap();
    let refusal = split_vertex(&mut mesh, v(0), [edge, edge], None).unwrap_err();
    assert_eq!(refusal, Refusal::GivenTwice(halfedge::Element::Edge, edge.raw()));
    let far = mesh.edges().find(|&e| !mesh.ends(e).contains(&v(0))).unwrap();
    assert_eq!(can_split_vertex(&mesh, v(0), [edge, far], None), Err(Refusal::NotAtVertex(far, v(0))));
}

#[test]
fn a_face_collapses_to_its_centroid() {
    let mut mesh = zoo::cube();
    let top = mesh.faces().nth(1).unwrap();
    let center = mesh.face_vertices(top).map(|v| mesh.position(v)).sum::<Vec3>() / 4.0;
    let stays = mesh.face_vertices(top).next().unwrap();
    let made = collapse_face(&mut mesh, top).unwrap();
    assert_eq!(made.removed_faces, [top]);
    assert_eq!(counts(&mesh), [5, 8, 5]);
    assert_eq!(mesh.position(stays), center);
    // A triangle inside a triangle mesh vanishes with its three neighbours.
    let mut mesh = zoo::triangle_grid(4, 4);
    let inner = mesh.faces().find(|&f| mesh.face_vertices(f).all(|v| !mesh.is_boundary_vertex(v))).unwrap();
    let before = counts(&mesh);
    collapse_face(&mut mesh, inner).unwrap();
    assert_eq!(counts(&mesh), [before[0] - 2, before[1] - 6, before[2] - 4]);
    // Nothing of a tetrahedron would be left; a face from boundary to boundary would pinch.
    let mesh = zoo::tetrahedron();
    let face = mesh.faces().next().unwrap();
    assert!(matches!(can_collapse_face(&mesh, face), Err(Refusal::LeftWithoutFace(_))));
    let mesh = zoo::grid(3, 1);
    let middle = mesh.faces().nth(1).unwrap();
    assert!(matches!(can_collapse_face(&mesh, middle), Err(Refusal::Pinched(_))));
}

#[test]
fn merging_two_ends_is_collapsing_their_edge() {
    for (name, start) in zoo::all() {
        for edge in start.edges() {
            let (mut collapsed, mut merged) = (start.clone(), start.clone());
            let ends = start.ends(edge);
            let one = collapse_edge(&mut collapsed, edge, 0.5);
            let other = merge_vertices(&mut merged, &ends, None);
            assert_eq!(one.is_ok(), other.is_ok(), "{name} {edge}: {one:?} {other:?}");
            assert_eq!(zoo::faces(&collapsed), zoo::faces(&merged), "{name} {edge}");
        }
    }
}

#[test]
fn merging_apart_sews_or_is_refused() {
    // Two vertices of different pieces would be a pinch.
    let mesh = zoo::several();
    let triangle = 8;
    assert_eq!(can_merge_vertices(&mesh, &[v(0), v(triangle)], None), Err(Refusal::Pinched(v(0))));
    // Opposite corners of the square hole in a frame: the edges between them are paired and close it.
    let mut mesh = zoo::frame();
    merge_vertices(&mut mesh, &[v(5), v(10)], Some(Vec3::ZERO)).unwrap();
    assert_eq!(counts(&mesh), [15, 22, 8]);
    assert_eq!(mesh.boundary_loops().len(), 1);
    assert_eq!(mesh.position(v(5)), Vec3::ZERO);
    // All four: the faces beside the hole become triangles.
    let mut mesh = zoo::frame();
    let made = merge_vertices(&mut mesh, &[v(5), v(6), v(9), v(10)], None).unwrap();
    assert_eq!(made.removed_vertices, [v(6), v(9), v(10)]);
    assert_eq!(counts(&mesh), [13, 20, 8]);
}
