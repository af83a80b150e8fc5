//! Large selections, faces and valences: quadratic work would take hours.

use crate::zoo::{self, v};
use glam::{Vec2, Vec3};
use halfedge::edit::*;
use halfedge::{FaceId, VertexId};

#[test]
fn a_hundred_thousand_faces_at_once() {
    let start = zoo::torus(400, 250);
    let some: Vec<FaceId> = start.faces().filter(|f| f.index() % 3 != 0).collect();
    let mut mesh = start.clone();
    let ((), journal) = mesh
        .transaction(|mesh| {
            delete_faces(mesh, &some)?;
            Ok::<_, halfedge::Refusal>(())
        })
        .unwrap();
    mesh.validate().unwrap();
    assert_eq!(mesh.face_count(), start.face_count() - some.len());
    mesh.undo(journal);
    assert!(mesh == start);
    for grouping in [Grouping::Region, Grouping::Individual] {
        let mut mesh = start.clone();
        let live = extrude_faces(&mut mesh, &some, grouping).unwrap();
        live.slide.apply(&mut mesh, 0.1).unwrap();
        mesh.validate().unwrap();
        assert_eq!(mesh.euler_characteristic(), 0);
    }
    let mut mesh = start.clone();
    let vertices: Vec<VertexId> = mesh.vertices().filter(|v| v.index() % 7 == 0).collect();
    bevel_vertices(&mut mesh, &vertices).unwrap();
    mesh.validate().unwrap();
}

#[test]
fn a_pole_of_a_hundred_thousand_edges() {
    // A cone on an n-gon; its tip is the last vertex.
    let n = 100_000;
    let mut positions: Vec<Vec3> = (0..n)
        .map(|i| Vec3::from((Vec2::from_angle(i as f32 / n as f32 * std::f32::consts::TAU), 0.0)))
        .collect();
    positions.push(Vec3::Z);
    let mut faces: Vec<Vec<u32>> = (0..n).map(|i| vec![i, (i + 1) % n, n]).collect();
    faces.push((0..n).rev().collect());
    let mut mesh = zoo::mesh(positions, &faces);
    let tip = v(n as usize);
    let spoke = mesh.vertex_edges(tip).nth(3).unwrap();
    collapse_edge(&mut mesh, spoke, 0.5).unwrap();
    mesh.validate().unwrap();
    let tip = mesh.vertices().max_by_key(|&v| mesh.valence(v)).unwrap();
    let made = delete_vertices(&mut mesh, &[tip]).unwrap();
    mesh.validate().unwrap();
    assert!(made.removed_faces.len() > 99_000);
    let mut mesh = zoo::mesh(
        (0..n).map(|i| Vec3::new(i as f32, (i as f32).powi(2), 0.0)).collect(),
        &[(0..n).collect::<Vec<u32>>()],
    );
    assert_eq!(
        triangulate_face(&mut mesh, FaceId::new(0), Triangulation::Fan).unwrap().faces.len(),
        n as usize - 3
    );
    mesh.validate().unwrap();
    let hole = mesh.boundary_loops()[0];
    fill_hole(&mut mesh, hole).unwrap();
    mesh.validate().unwrap();
    assert_eq!(mesh.euler_characteristic(), 2);
}

#[test]
fn a_face_of_a_hundred_thousand_corners_is_poked() {
    let n = 100_000;
    let mut mesh = zoo::coin(n);
    zoo::paint(&mut mesh);
    let made = poke_faces(&mut mesh, &[FaceId::new(0)]).unwrap();
    mesh.validate().unwrap();
    assert_eq!(made.faces.len(), n as usize - 1);
}

#[test]
fn checking_whether_a_face_can_be_turned_costs_nothing_on_a_large_mesh() {
    let mesh = zoo::torus(400, 250);
    for face in mesh.faces() {
        let refusal = can_flip_orientation(&mesh, &[face]).unwrap_err();
        assert_eq!(refusal, halfedge::Refusal::NotAWholePiece(face));
    }
}
