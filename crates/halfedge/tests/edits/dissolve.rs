//! Dissolve vertices and edges, delete faces and vertices, poke, connect.

use crate::random::Random;
use crate::zoo::{self, counts, he, v};
use halfedge::edit::*;
use halfedge::{EdgeId, FaceId, Mesh, Refusal};

fn dissolvable(mesh: &Mesh) -> Option<EdgeId> {
    mesh.edges().find(|&e| can_dissolve_edges(mesh, &[e]).is_ok())
}

#[test]
fn dissolving_an_edge_merges_two_faces() {
    let mut mesh = zoo::cube();
    let edge = he(&mesh, 0, 1).edge();
    let keeps = mesh.face_of(edge.halfedge()).unwrap();
    let made = dissolve_edges(&mut mesh, &[edge], true).unwrap();
    assert_eq!((made.removed_edges.as_slice(), made.removed_faces.len()), (&[edge][..], 1));
    assert_eq!(counts(&mesh), [8, 11, 5]);
    assert_eq!(mesh.face_degree(keeps), 6);
}

#[test]
fn faces_that_meet_along_a_row_of_edges_merge_and_lose_it_all() {
    let mut mesh = zoo::cube();
    let edge = he(&mesh, 0, 1).edge();
    let split = split_edge(&mut mesh, edge, 0.5, Connect::None).unwrap();
    let made = dissolve_edges(&mut mesh, &[split.edges[0]], true).unwrap();
    assert_eq!(made.removed_vertices, [split.vertex]);
    assert_eq!(counts(&mesh), [8, 11, 5]);
}

#[test]
fn faces_that_meet_along_two_edges_apart_are_refused() {
    let mut mesh = zoo::coin(8);
    connect_vertices(&mut mesh, v(0), v(3)).unwrap();
    connect_vertices(&mut mesh, v(4), v(7)).unwrap();
    // The middle face of the front (0 3 4 7) and the back meet along 3 4 and 7 0.
    for (a, b) in [(3, 4), (7, 0)] {
        let edge = he(&mesh, a, b).edge();
        assert!(matches!(can_dissolve_edges(&mesh, &[edge]), Err(Refusal::NotADisc(_))));
    }
    // The other faces of the front each meet the back along one row.
    for (a, b) in [(0, 1), (1, 2), (5, 6)] {
        can_dissolve_edges(&mesh, &[he(&mesh, a, b).edge()]).unwrap();
    }
    // Merging faces of a torus as long as that is allowed never cuts its handle: two faces that meet along three rows have
    // an outline of one loop and are no disc.
    let mut mesh = zoo::complete_torus();
    while let Some(edge) = dissolvable(&mesh) {
        dissolve_edges(&mut mesh, &[edge], true).unwrap();
        mesh.validate().unwrap();
        assert_eq!(mesh.euler_characteristic(), 0);
    }
    assert!(mesh.face_count() >= 2);
}

/// A prism on a regular octagon, its 8 sides cut halfway up.
fn cut_prism() -> (Mesh, Vec<EdgeId>) {
    let n = 8;
    let ring = |z: f32| {
        (0..n).map(move |i| glam::Vec3::from((glam::Vec2::from_angle(i as f32 / n as f32 * 6.2831855), z)))
    };
    let mut faces: Vec<Vec<u32>> = vec![(0..n).rev().collect(), (n..2 * n).collect()];
    faces.extend((0..n).map(|i| vec![i, (i + 1) % n, n + (i + 1) % n, n + i]));
    let mut mesh = zoo::mesh(ring(0.0).chain(ring(1.0)).collect(), &faces);
    let upright = he(&mesh, 0, n as usize).edge();
    let made = loop_cut(&mut mesh, upright, 1, 0.5).unwrap();
    let cut: Vec<EdgeId> =
        made.edges.into_iter().filter(|&e| mesh.ends(e).iter().all(|v| v.index() >= 16)).collect();
    assert_eq!((cut.len(), counts(&mesh)), (8, [24, 40, 18]));
    (mesh, cut)
}

#[test]
fn dissolving_a_loop_cut_takes_its_vertices_too() {
    let (start, cut) = cut_prism();
    let mut mesh = start.clone();
    let made = dissolve_edges(&mut mesh, &cut, false).unwrap();
    assert_eq!(counts(&mesh), [16, 24, 10]);
    assert_eq!((made.removed_vertices.len(), made.removed_edges.len()), (8, 16));
    assert!(made.edges.is_empty());
    let mut mesh = start.clone();
    dissolve_edges(&mut mesh, &cut, true).unwrap();
    assert_eq!(counts(&mesh), [24, 32, 10]);
    // One by one, as separate edits.
    let mut mesh = start.clone();
    for &edge in &cut {
        dissolve_edges(&mut mesh, &[edge], false).unwrap();
    }
    assert_eq!(counts(&mesh), [16, 24, 10]);
    // All but one: its ends still have three edges.
    let mut mesh = start;
    dissolve_edges(&mut mesh, &cut[1..], false).unwrap();
    assert_eq!(counts(&mesh), [18, 27, 11]);
}

#[test]
fn vertices_count_when_all_edges_are_gone() {
    // Two of three edges at a vertex. After the first, the other two would become one if vertices were counted then, and
    // the second edge could be lost in the third, which isn't given.
    let start = zoo::tetrahedron();
    let spokes: Vec<EdgeId> = start.vertex_edges(v(3)).collect();
    for (i, j) in [(0, 1), (1, 0), (0, 2), (2, 0), (1, 2), (2, 1)] {
        let mut mesh = start.clone();
        dissolve_edges(&mut mesh, &[spokes[i], spokes[j]], false).unwrap();
        assert_eq!(counts(&mesh), [3, 3, 2]);
    }
    // The vertex in the middle is removed with its edges; their other ends are left with two boundary edges.
    let mut mesh = zoo::grid(2, 2);
    let spokes = [(4, 5), (4, 7), (4, 3)].map(|(a, b)| he(&mesh, a, b).edge());
    let made = dissolve_edges(&mut mesh, &spokes, false).unwrap();
    assert_eq!(made.removed_faces.len(), 3);
    assert_eq!(counts(&mesh), [4, 4, 1]);
    // Vertices with two edges that are no end of a dissolved edge stay.
    let mut mesh = zoo::grid(3, 1);
    let across = he(&mesh, 1, 5).edge();
    split_edge(&mut mesh, he(&zoo::grid(3, 1), 0, 4).edge(), 0.5, Connect::None).unwrap();
    dissolve_edges(&mut mesh, &[across], false).unwrap();
    assert_eq!(counts(&mesh), [7, 8, 2]);
    // A vertex stays if a face would be left with two corners.
    let mut mesh = zoo::triangle_grid(1, 1);
    let diagonal = he(&mesh, 0, 3).edge();
    dissolve_edges(&mut mesh, &[diagonal], false).unwrap();
    assert_eq!(counts(&mesh), [3, 3, 1]);
}

#[test]
fn regions_dissolve_as_wholes() {
    let start = zoo::grid(5, 5);
    let edges = |pairs: &[(usize, usize)]| -> Vec<EdgeId> {
        pairs.iter().map(|&(a, b)| he(&start, a, b).edge()).collect()
    };
    // The eight faces round the middle one are a ring; with it they are a disc.
    let ring = edges(&[(8, 14), (9, 15), (20, 26), (21, 27), (13, 14), (19, 20), (15, 16), (21, 22)]);
    assert!(matches!(can_dissolve_edges(&start, &ring), Err(Refusal::NotADisc(_))));
    let middle = edges(&[(14, 15), (15, 21), (20, 21), (14, 20)]);
    // With another region apart from it.
    let all: Vec<EdgeId> = ring.into_iter().chain(middle).chain(edges(&[(1, 7)])).collect();
    for (keep_vertices, expected) in [(true, [32, 47, 16]), (false, [31, 46, 16])] {
        let mut mesh = start.clone();
        dissolve_edges(&mut mesh, &all, keep_vertices).unwrap();
        assert_eq!(counts(&mesh), expected);
    }
}

#[test]
fn dissolving_at_once_is_dissolving_one_by_one() {
    let mut same = 0;
    for (seed, (name, start)) in (1..40).flat_map(|seed| zoo::all().into_iter().map(move |m| (seed, m))) {
        let mut random = Random::new(seed);
        let inner: Vec<EdgeId> = start.edges().filter(|&e| !start.is_boundary_edge(e)).collect();
        let edges: Vec<EdgeId> = (0..=random.below(6)).filter_map(|_| random.pick(&inner)).collect();
        let mut one_by_one = start.clone();
        let mut is_refused = edges.is_empty();
        for &edge in &edges {
            is_refused |=
                one_by_one.has_edge(edge) && dissolve_edges(&mut one_by_one, &[edge], true).is_err();
        }
        if is_refused {
            continue;
        }
        let mut at_once = start.clone();
        dissolve_edges(&mut at_once, &edges, true).unwrap();
        let faces = |mesh: &Mesh| -> Vec<_> {
            mesh.faces().map(|f| (f, mesh.face_halfedges(f).collect::<Vec<_>>())).collect()
        };
        assert_eq!(faces(&at_once), faces(&one_by_one), "{name}, seed {seed}: {edges:?}");
        same += 1;
    }
    assert!(same > 100, "{same}");
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
        assert!(matches!(can_dissolve_edges(&mesh, &[edge]), Err(Refusal::NotADisc(_))));
    }
    // A cube, edge by edge, ends with two faces too.
    let mut mesh = zoo::cube();
    while let Some(edge) = dissolvable(&mesh) {
        dissolve_edges(&mut mesh, &[edge], true).unwrap();
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
    // On the boundary an edge joins its two neighbours.
    let mut mesh = zoo::grid(2, 1);
    dissolve_vertex(&mut mesh, v(1)).unwrap();
    assert_eq!(counts(&mesh), [5, 5, 1]);
    assert!(mesh.find_edge(v(0), v(2)).is_some());
    let mesh = zoo::triangle();
    assert!(matches!(can_dissolve_vertex(&mesh, v(0)), Err(Refusal::TooFewCorners(_))));
    // In the tip of two triangles: an edge joins its neighbours already.
    let mut mesh = zoo::triangle_grid(1, 1);
    let tip = mesh.vertices().find(|&v| mesh.valence(v) == 2).unwrap();
    assert!(matches!(dissolve_vertex(&mut mesh, tip), Err(Refusal::TooFewCorners(_))));
    // In a tetrahedron without a face: likewise.
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
    // If an edge joins the neighbours already the two edges can't become one: vertex 1 between (0 1 2 3) and (2 1 0 4),
    // and two triangles with the edge 0 2.
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
    // All faces, and vertices with the faces round them.
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

/// The faces as loops of vertices, each from its smallest vertex, sorted.
fn loops(mesh: &Mesh) -> Vec<Vec<halfedge::VertexId>> {
    let mut loops: Vec<_> = mesh
        .faces()
        .map(|f| {
            let mut corners: Vec<_> = mesh.face_vertices(f).collect();
            let least = (0..corners.len()).min_by_key(|&i| corners[i]).unwrap();
            corners.rotate_left(least);
            corners
        })
        .collect();
    loops.sort();
    loops
}

/// Dissolves vertices one by one; None where one is refused.
fn one_by_one(mesh: &Mesh, vertices: &[halfedge::VertexId]) -> Option<Mesh> {
    let mut mesh = mesh.clone();
    for &vertex in vertices {
        if mesh.has_vertex(vertex) {
            dissolve_vertex(&mut mesh, vertex).ok()?;
        }
    }
    Some(mesh)
}

#[test]
fn dissolving_around_many_vertices_merges_what_one_by_one_merges() {
    let mut random = Random::new(7);
    let mut compared = 0;
    for round in 0..400 {
        let mesh = match round % 4 {
            0 => zoo::grid(5, 5),
            1 => zoo::cube(),
            2 => zoo::coin(8),
            _ => zoo::complete_torus(),
        };
        let chance = 1 + random.below(4);
        let mut vertices: Vec<_> = mesh.vertices().filter(|_| random.below(5) < chance).collect();
        vertices.sort_by_cached_key(|_| random.below(1000));
        let Some(expected) = one_by_one(&mesh, &vertices) else { continue };
        let mut merged = mesh.clone();
        let made = dissolve_around(&mut merged, &vertices).unwrap();
        merged.validate().unwrap();
        assert_eq!(made.counts_after(&mesh), counts(&merged));
        let merged = one_by_one(&merged, &vertices).expect("what is left");
        assert_eq!(loops(&merged), loops(&expected), "{vertices:?}");
        compared += 1;
    }
    assert!(compared > 100, "{compared}");
}
