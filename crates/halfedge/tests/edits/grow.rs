//! Extrude and inset.

use crate::zoo::{self, counts, he};
use glam::Vec3;
use halfedge::edit::*;
use halfedge::{EdgeId, FaceId, Mesh, Refusal};

fn corners(mesh: &Mesh, face: FaceId) -> Vec<Vec3> {
    mesh.face_vertices(face).map(|v| mesh.position(v)).collect()
}

/// The face of a cube where x is 1.
const SIDE: usize = 1;

#[test]
fn a_face_of_a_cube_extrudes_by_the_distance() {
    let start = zoo::cube();
    let face = FaceId::new(SIDE);
    let mut mesh = start.clone();
    let live = extrude_faces(&mut mesh, &[face], Grouping::Region).unwrap();
    assert_eq!(counts(&mesh), [12, 20, 10]);
    assert_eq!(corners(&mesh, face), corners(&start, face), "no height yet");
    live.slide.apply(&mut mesh, 0.5).unwrap();
    let moved: Vec<Vec3> = corners(&start, face).iter().map(|p| *p + Vec3::X * 0.5).collect();
    assert_eq!(corners(&mesh, face), moved);
    // Each call starts from amount 0.
    live.slide.apply(&mut mesh, -0.25).unwrap();
    live.slide.apply(&mut mesh, 0.5).unwrap();
    assert_eq!(corners(&mesh, face), moved);
    assert_eq!(live.slide.limit, f32::INFINITY);
}

#[test]
fn extruding_a_region_with_a_hole_on_the_boundary() {
    let mut mesh = zoo::grid(3, 3);
    let ring: Vec<FaceId> = mesh.faces().filter(|f| f.index() != 4).collect();
    let live = extrude_faces(&mut mesh, &ring, Grouping::Region).unwrap();
    // 12 outer and 4 inner outline edges.
    assert_eq!(live.made.faces.len(), 16);
    assert_eq!(live.made.vertices.len(), 16);
    live.slide.apply(&mut mesh, 1.0).unwrap();
    assert_eq!(counts(&mesh), [32, 56, 25]);
    assert_eq!(mesh.boundary_loops().len(), 1);
    // The boundary stayed, and the region moved up by one.
    for v in mesh.vertices() {
        assert_eq!(mesh.position(v).z, if v.index() < 16 { 0.0 } else { 1.0 });
    }
    assert!(ring.iter().all(|&f| corners(&mesh, f).iter().all(|p| p.z == 1.0)));
}

#[test]
fn extruding_several_pieces_and_a_region_that_touches_itself() {
    // Two diagonal faces share a vertex; each gets a copy.
    let mut mesh = zoo::grid(2, 2);
    let live = extrude_faces(&mut mesh, &[FaceId::new(0), FaceId::new(3)], Grouping::Region).unwrap();
    assert_eq!((live.made.vertices.len(), live.made.faces.len()), (8, 8));
    counts(&mesh);
    // Faces of different components.
    let mut mesh = zoo::several();
    let all: Vec<FaceId> = mesh.faces().collect();
    let [vertices, edges, faces] = counts(&mesh);
    let live = extrude_faces(&mut mesh, &all, Grouping::Region).unwrap();
    // The cube and the tetrahedron have no outline; the triangle has 3 edges, the grid 8.
    assert_eq!(live.made.faces.len(), 11);
    assert_eq!(counts(&mesh), [vertices + 11, edges + 22, faces + 11]);
    // Pieces without an outline move too.
    assert_eq!(live.slide.vertices.len(), 11 + 8 + 4 + 1);
}

#[test]
fn extruding_faces_one_by_one() {
    let mut mesh = zoo::cube();
    let all: Vec<FaceId> = mesh.faces().collect();
    let live = extrude_faces(&mut mesh, &all, Grouping::Individual).unwrap();
    assert_eq!((live.made.vertices.len(), live.made.faces.len()), (24, 24));
    live.slide.apply(&mut mesh, 1.0).unwrap();
    assert_eq!(counts(&mesh), [32, 60, 30]);
    for &face in &all {
        assert!(corners(&mesh, face).iter().all(|p| p.abs().max_element() == 2.0));
    }
}

#[test]
fn boundary_edges_extrude() {
    let mut mesh = zoo::grid(2, 1);
    let edges = [he(&mesh, 0, 1).edge(), he(&mesh, 1, 2).edge()];
    let live = extrude_edges(&mut mesh, &edges, Vec3::NEG_Y).unwrap();
    assert_eq!((live.made.vertices.len(), live.made.faces.len()), (3, 2));
    live.slide.apply(&mut mesh, 1.0).unwrap();
    assert_eq!(counts(&mesh), [9, 12, 4]);
    assert!(live.made.vertices.iter().all(|&v| mesh.position(v).y == -1.0));
    // All the way round.
    let edges: Vec<EdgeId> = mesh.edges().filter(|&e| mesh.is_boundary_edge(e)).collect();
    extrude_edges(&mut mesh, &edges, Vec3::Z).unwrap();
    counts(&mesh);
    assert_eq!(mesh.boundary_loops().len(), 1);
    let inner = mesh.edges().find(|&e| !mesh.is_boundary_edge(e)).unwrap();
    assert_eq!(can_extrude_edges(&mesh, &[inner]), Err(Refusal::NotOnBoundary(inner)));
}

#[test]
fn an_inset_is_as_wide_as_asked_and_clamped_to_the_face() {
    let face = FaceId::new(SIDE);
    let mut mesh = zoo::cube();
    let live = inset_faces(&mut mesh, &[face], Grouping::Region).unwrap();
    assert_eq!(counts(&mesh), [12, 20, 10]);
    assert_eq!(live.slide.apply(&mut mesh, 0.25), Ok(0.25));
    for p in corners(&mesh, face) {
        assert!((p.abs() - Vec3::new(1.0, 0.75, 0.75)).length() < 1e-6, "{p}");
    }
    assert!((live.slide.limit - 1.0).abs() < 1e-6);
    assert_eq!(live.slide.apply(&mut mesh, 7.0), Ok(live.slide.limit));
    for p in corners(&mesh, face) {
        assert!((p - Vec3::X).length() < 1e-6, "clamped to the middle, not beyond: {p}");
    }
}

#[test]
fn insetting_regions_and_single_faces() {
    let mut mesh = zoo::grid(2, 1);
    let both = [FaceId::new(0), FaceId::new(1)];
    let live = inset_faces(&mut mesh, &both, Grouping::Region).unwrap();
    assert_eq!(live.made.faces.len(), 6);
    live.slide.apply(&mut mesh, 0.25).unwrap();
    let mut inner: Vec<[f32; 2]> =
        live.made.vertices.iter().map(|&v| mesh.position(v).truncate().to_array()).collect();
    inner.sort_by(|a, b| a.partial_cmp(b).unwrap());
    assert_eq!(inner, [[0.25, 0.25], [0.25, 0.75], [1.0, 0.25], [1.0, 0.75], [1.75, 0.25], [1.75, 0.75]]);
    let mut mesh = zoo::grid(2, 1);
    let live = inset_faces(&mut mesh, &both, Grouping::Individual).unwrap();
    assert_eq!((live.made.vertices.len(), live.made.faces.len()), (8, 8));
    counts(&mesh);
    // A whole closed piece has no outline.
    let mesh = zoo::cube();
    let all: Vec<FaceId> = mesh.faces().collect();
    assert_eq!(can_inset_faces(&mesh, &all, Grouping::Region), Err(Refusal::NoOutline(all[0])));
    can_inset_faces(&mesh, &all, Grouping::Individual).unwrap();
}
