//! The five regular solids, and the icosphere.

use super::build_mesh;
use crate::{Loop, SurfaceError, subdivide_loop};
use glam::{DVec3, Vec3};
use halfedge::{Mesh, PolygonSoup};
use std::ops::ControlFlow;

/// The golden ratio.
fn golden() -> f64 {
    (1.0 + 5f64.sqrt()) / 2.0
}

/// A solid with its corners moved onto the sphere of this radius.
fn solid<const N: usize>(
    corners: impl IntoIterator<Item = DVec3>,
    radius: f64,
    faces: &[[u32; N]],
) -> Result<Mesh, SurfaceError> {
    let positions = corners.into_iter().map(|p| (p.normalize_or_zero() * radius).as_vec3()).collect();
    build_mesh(PolygonSoup::new(positions, faces))
}

pub(super) fn cube(values: &[f64]) -> Result<Mesh, SurfaceError> {
    let half = (values[0] / 2.0) as f32;
    let positions = (0..8u32)
        .map(|i| {
            let side = |bit: u32| if i >> bit & 1 == 1 { half } else { -half };
            Vec3::new(side(0), side(1), side(2))
        })
        .collect();
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    build_mesh(PolygonSoup::new(positions, &faces))
}

pub(super) fn tetrahedron(values: &[f64]) -> Result<Mesh, SurfaceError> {
    let corners = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    let faces = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];
    solid(corners.map(DVec3::from_array), values[0], &faces)
}

pub(super) fn octahedron(values: &[f64]) -> Result<Mesh, SurfaceError> {
    let corners = [DVec3::X, DVec3::NEG_X, DVec3::Y, DVec3::NEG_Y, DVec3::Z, DVec3::NEG_Z];
    let faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    solid(corners, values[0], &faces)
}

pub(super) fn icosahedron(values: &[f64]) -> Result<Mesh, SurfaceError> {
    let g = golden();
    let corners = [
        [-1.0, g, 0.0],
        [1.0, g, 0.0],
        [-1.0, -g, 0.0],
        [1.0, -g, 0.0],
        [0.0, -1.0, g],
        [0.0, 1.0, g],
        [0.0, -1.0, -g],
        [0.0, 1.0, -g],
        [g, 0.0, -1.0],
        [g, 0.0, 1.0],
        [-g, 0.0, -1.0],
        [-g, 0.0, 1.0],
    ];
    let faces = [
        [0, 11, 5],
        [0, 5, 1],
        [0, 1, 7],
        [0, 7, 10],
        [0, 10, 11],
        [1, 5, 9],
        [5, 11, 4],
        [11, 10, 2],
        [10, 7, 6],
        [7, 1, 8],
        [3, 9, 4],
        [3, 4, 2],
        [3, 2, 6],
        [3, 6, 8],
        [3, 8, 9],
        [4, 9, 5],
        [2, 4, 11],
        [6, 2, 10],
        [8, 6, 7],
        [9, 8, 1],
    ];
    solid(corners.map(DVec3::from_array), values[0], &faces)
}

/// The dual of the icosahedron, with a corner for each of its faces and a face for each of its corners.
pub(super) fn dodecahedron(values: &[f64]) -> Result<Mesh, SurfaceError> {
    let dual = icosahedron(&[1.0])?;
    let mut soup = PolygonSoup::default();
    for f in dual.faces() {
        let sum: DVec3 = dual.face_vertices(f).map(|v| dual.position(v).as_dvec3()).sum();
        soup.positions.push((sum.normalize_or_zero() * values[0]).as_vec3());
    }
    for v in dual.vertices() {
        // Faces around a vertex come clockwise.
        let mut corners: Vec<u32> = dual.vertex_faces(v).map(|f| f.raw()).collect();
        corners.reverse();
        soup.push_face(corners);
    }
    build_mesh(soup)
}

/// The icosahedron after splitting its triangles in four and moving the new corners onto the sphere, as often as
/// `subdivisions` says.
pub(super) fn ico_sphere(values: &[f64]) -> Result<Mesh, SurfaceError> {
    let radius = values[0];
    let mut mesh = icosahedron(&[radius])?;
    for _ in 0..values[1] as u32 {
        let child = subdivide_loop(&mesh, &Loop::default(), &mut |_| ControlFlow::Continue(()))?;
        let mut positions = mesh.positions().to_vec();
        positions.extend(mesh.edges().map(|e| {
            let [a, b] = mesh.ends(e).map(|v| mesh.position(v).as_dvec3());
            ((a + b).normalize_or_zero() * radius).as_vec3()
        }));
        mesh = child;
        // The child has a vertex for each old one and each edge, in that order.
        if mesh.set_positions(positions).is_err() {
            debug_assert!(false, "an edge point for each edge");
        }
    }
    Ok(mesh)
}
