//! Splitting edges and cutting faces into fans.

use super::*;

#[test]
fn splitting_an_edge_makes_what_it_says() {
    for (connect, faces, edges) in
        [(Connect::None, 6, 13), (Connect::Triangles, 6, 13), (Connect::All, 8, 15)]
    {
        let (mut mesh, _) = built(8, CUBE);
        let edge = mesh.edge(3).unwrap();
        let [a, b] = mesh.ends(edge);
        let split = split_edge(&mut mesh, edge, 0.25, connect).unwrap();
        mesh.validate().unwrap();
        assert_eq!((mesh.vertex_count(), mesh.edge_count(), mesh.face_count()), (9, edges, faces));
        assert_eq!(mesh.position(split.vertex), mesh.position(a).lerp(mesh.position(b), 0.25));
        assert_eq!(mesh.ends(edge), [a, split.vertex]);
        assert_eq!(mesh.ends(split.edges[0]), [split.vertex, b]);
        assert_eq!(split.faces.len(), faces - 6);
        for f in 0..6 {
            let first = corners(&mesh, f)[0];
            assert!(
                first == CUBE[f as usize][0] || first == split.vertex.raw(),
                "face {f} starts at {first}"
            );
        }
    }
}

#[test]
fn a_split_that_would_join_two_vertices_twice_is_refused() {
    let (mut mesh, _) = built(3, &[&[0, 1, 2], &[0, 2, 1]]);
    let before = mesh.clone();
    let edge = mesh.edge(0).unwrap();
    assert!(split_edge(&mut mesh, edge, 0.5, Connect::Triangles).is_err());
    assert!(split_edge(&mut mesh, edge, 0.0, Connect::None).is_err());
    assert!(split_edge(&mut mesh, edge, f32::NAN, Connect::None).is_err());
    assert_eq!(mesh, before);
    split_edge(&mut mesh, edge, 0.5, Connect::None).unwrap();
    mesh.validate().unwrap();
}

#[test]
fn a_fan_starts_at_the_first_corner() {
    let (mut mesh, _) = built(6, &[&[2, 3, 4, 5, 0, 1]]);
    let made = triangulate_face(&mut mesh, FaceId::new(0), Triangulation::Fan).unwrap();
    mesh.validate().unwrap();
    assert_eq!((made.faces.len(), made.edges.len()), (3, 3));
    for f in mesh.faces() {
        assert_eq!(mesh.face_degree(f), 3);
        assert!(corners(&mesh, f.raw()).contains(&2));
    }
}
