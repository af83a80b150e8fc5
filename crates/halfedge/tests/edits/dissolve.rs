//! Dissolve vertex and edge, delete faces and vertices, poke, connect.

use crate::zoo::{self, he, v};
use halfedge::edit::*;
use halfedge::{EdgeId, FaceId, Mesh, Refusal};

fn counts(mesh: &Mesh) -> [usize; 3] {
    mesh.validate().unwrap();
    [mesh.vertex_count(), mesh.edge_count(), mesh.face_count()]
}

fn dissolvable(mesh: &Mesh) -> Option<EdgeId> {
    mesh.edges().find(|&e| can_dissolve_edge(mesh, e).is_ok())
}

#[test]
fn dissolving_an_edge_merges_two_faces() {
    let mut mesh = zoo::cube();
    let edge = he(&mesh, 0, 1).edge();
    let keeps = mesh.face_of(edge.halfedge()).unwrap();
    let made = dissolve_edge(&mut mesh, edge).unwrap();
    assert_eq!((made.removed_edges.as_slice(), made.removed_faces.len()), (&[edge][..], 1));
    assert_eq!(counts(&mesh), [8, 11, 5]);
    assert_eq!(mesh.face_degree(keeps), 6);
}

#[test]
fn faces_that_meet_along_a_row_of_edges_merge_and_lose_it_all() {
    let mut mesh = zoo::cube();
    let edge = he(&mesh, 0, 1).edge();
    let split = split_edge(&mut mesh, edge, 0.5, Connect::None).unwrap();
    let made = dissolve_edge(&mut mesh, split.edges[0]).unwrap();
    assert_eq!(made.removed_vertices, [split.vertex]);
    assert_eq!(counts(&mesh), [8, 11, 5]);
}

#[test]
fn faces_that_meet_along_two_edges_apart_are_refused() {
    let mut mesh = zoo::coin(8);
    connect_vertices(&mut mesh, v(0), v(3)).unwrap();
    connect_vertices(&mut mesh, v(4), v(7)).unwrap();
    // The front's middle (0 3 4 7) and the back meet along 3 4 and 7 0.
    for (a, b) in [(3, 4), (7, 0)] {
        let edge = he(&mesh, a, b).edge();
        assert!(matches!(can_dissolve_edge(&mesh, edge), Err(Refusal::NotADisc(_))));
    }
    // The front's ends each meet the back along one row.
    for (a, b) in [(0, 1), (1, 2), (5, 6)] {
        can_dissolve_edge(&mesh, he(&mesh, a, b).edge()).unwrap();
    }
    // Merging faces of a torus for as long as that is allowed never cuts its handle: two faces that
    // meet along three rows have an outline of one loop, and are no disc.
    let mut mesh = zoo::complete_torus();
    while let Some(edge) = dissolvable(&mesh) {
        dissolve_edge(&mut mesh, edge).unwrap();
        mesh.validate().unwrap();
        assert_eq!(mesh.euler_characteristic(), 0);
    }
    assert!(mesh.face_count() >= 2);
}

#[test]
fn dissolving_down_to_two_faces() {
    let mut mesh = zoo::tetrahedron();
    dissolve_vertex(&mut mesh, v(3)).unwrap();
    assert_eq!(counts(&mesh), [3, 3, 2]);
    for vertex in mesh.vertices() {
        assert!(matches!(can_dissolve_vertex(&mesh, vertex), Err(Refusal::TooFewCorners(_))));
    }
    for edge in mesh.edges() {
        assert!(matches!(can_dissolve_edge(&mesh, edge), Err(Refusal::NotADisc(_))));
    }
    // The cube, edge by edge, ends with two faces as well.
    let mut mesh = zoo::cube();
    while let Some(edge) = dissolvable(&mesh) {
        dissolve_edge(&mut mesh, edge).unwrap();
        mesh.validate().unwrap();
        assert_eq!(mesh.euler_characteristic(), 2);
    }
    assert_eq!(mesh.face_count(), 2);
}

#[test]
fn dissolving_a_vertex_inside_and_on_the_boundary() {
    let mut mesh = zoo::grid(2, 2);
    dissolve_vertex(&mut mesh, v(4)).unwrap();
    assert_eq!(counts(&mesh), [8, 8, 1]);
    // On the boundary its two neighbours there are joined.
    let mut mesh = zoo::grid(2, 1);
    dissolve_vertex(&mut mesh, v(1)).unwrap();
    assert_eq!(counts(&mesh), [5, 5, 1]);
    assert!(mesh.find_edge(v(0), v(2)).is_some());
    let mesh = zoo::triangle();
    assert!(matches!(can_dissolve_vertex(&mesh, v(0)), Err(Refusal::TooFewCorners(_))));
    // Two triangles on the boundary: the neighbours are joined by the edge that stays.
    let mut mesh = zoo::triangle_grid(1, 1);
    let tip = mesh.vertices().find(|&v| mesh.valence(v) == 2).unwrap();
    assert!(matches!(dissolve_vertex(&mut mesh, tip), Err(Refusal::TooFewCorners(_))));
    // A boundary triangle of neighbours: the hole 1 3 of a strip.
    let mut mesh = zoo::tetrahedron();
    delete_faces(&mut mesh, &[FaceId::new(0)]).unwrap();
    let refusal = dissolve_vertex(&mut mesh, v(0)).unwrap_err();
    assert!(matches!(refusal, Refusal::AlreadyJoined(..)), "{refusal}");
}

#[test]
fn dissolving_the_vertex_of_a_split_undoes_it() {
    for (name, start) in zoo::all() {
        for edge in start.edges() {
            let mut mesh = start.clone();
            let split = split_edge(&mut mesh, edge, 0.3, Connect::None).unwrap();
            dissolve_vertex(&mut mesh, split.vertex).unwrap_or_else(|r| panic!("{name} {edge}: {r}"));
            mesh.validate().unwrap();
            assert_eq!(zoo::faces(&mesh), zoo::faces(&start), "{name} {edge}");
            assert_eq!(mesh.edge_count(), start.edge_count());
        }
    }
}

#[test]
fn two_faces_inside_a_vertex_keep_apart() {
    let mut mesh = zoo::coin(5);
    dissolve_vertex(&mut mesh, v(2)).unwrap();
    assert_eq!(counts(&mesh), [4, 4, 2]);
    // Where the neighbours are joined already, the two edges can't become one: the vertex 1 between
    // the faces (0 1 2 a) and (2 1 0 b), and a triangle pair that has the edge 0 2.
    let p = (0..5).map(|i| glam::Vec3::new(i as f32, (i * i) as f32, (i % 2) as f32)).collect();
    let faces: [&[u32]; 4] = [&[0, 1, 2, 3], &[2, 1, 0, 4], &[0, 3, 2], &[0, 2, 4]];
    let mesh = zoo::mesh(p, &faces);
    assert_eq!(can_dissolve_vertex(&mesh, v(1)), Err(Refusal::AlreadyJoined(v(0), v(2))));
}

#[test]
fn deleting_leaves_holes_and_separates_bow_ties() {
    let mut mesh = zoo::grid(2, 2);
    let made = delete_faces(&mut mesh, &[FaceId::new(0), FaceId::new(3), FaceId::new(0)]).unwrap();
    assert_eq!(made.vertices.len(), 1);
    assert_eq!(made.removed_vertices, [v(0), v(8)]);
    assert_eq!(counts(&mesh), [8, 8, 2]);
    assert_eq!(mesh.position(made.vertices[0]), mesh.position(v(4)));
    assert_eq!(mesh.components().1, 2);
    // All of it, and vertices with the faces round them.
    let mut mesh = zoo::cube();
    let all: Vec<FaceId> = mesh.faces().collect();
    delete_faces(&mut mesh, &all).unwrap();
    assert_eq!(counts(&mesh), [0, 0, 0]);
    let mut mesh = zoo::grid(2, 2);
    let made = delete_vertices(&mut mesh, &[v(4)]).unwrap();
    assert_eq!(made.removed_vertices.len(), 9);
    assert_eq!(counts(&mesh), [0, 0, 0]);
    let mut mesh = zoo::triangle();
    let alone = mesh.add_vertex(glam::Vec3::ONE);
    let made = delete_vertices(&mut mesh, &[alone]).unwrap();
    assert_eq!(made.removed_vertices, [alone]);
    assert_eq!(counts(&mesh), [3, 3, 1]);
}

#[test]
fn poking_and_connecting() {
    let mut mesh = zoo::cube();
    let all: Vec<FaceId> = mesh.faces().collect();
    let made = poke_faces(&mut mesh, &all).unwrap();
    assert_eq!((made.vertices.len(), made.edges.len(), made.faces.len()), (6, 24, 18));
    assert_eq!(counts(&mesh), [14, 36, 24]);
    assert!(made.vertices.iter().all(|&v| (mesh.position(v).length() - 1.0).abs() < 1e-6));

    let mut mesh = zoo::grid(1, 1);
    let cut = connect_vertices(&mut mesh, v(0), v(3)).unwrap();
    assert_eq!(zoo::faces(&mesh), [[0, 1, 3], [0, 3, 2]]);
    assert_eq!(cut.new_face, FaceId::new(1));
    assert_eq!(can_connect_vertices(&mesh, v(1), v(2)), Err(Refusal::NotInOneFace(v(1), v(2))));
    assert_eq!(can_connect_vertices(&mesh, v(0), v(3)), Err(Refusal::AlreadyJoined(v(0), v(3))));
}
