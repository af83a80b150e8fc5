//! Meshes for tests.
// Each test binary uses some of it.
#![allow(dead_code)]

pub mod gpu;

use glam::{Vec3, vec3};
use halfedge::{Color, Mesh, PolygonSoup, keys};

pub fn mesh<F: AsRef<[u32]>>(positions: Vec<Vec3>, faces: &[F]) -> Mesh {
    let built = Mesh::build(PolygonSoup::new(positions, faces)).expect("a small mesh");
    assert!(built.notes.is_empty(), "{:?}", built.notes);
    built.mesh
}

/// A cube from -1 to 1. Faces: front (+z), back, right (+x), left, top (+y), bottom.
pub fn cube() -> Mesh {
    let corner = |i: u32| vec3(sign(i & 1), sign(i & 2), sign(i & 4));
    let faces = [[4, 5, 7, 6], [1, 0, 2, 3], [5, 1, 3, 7], [0, 4, 6, 2], [6, 7, 3, 2], [0, 1, 5, 4]];
    mesh((0..8).map(corner).collect(), &faces)
}

fn sign(bit: u32) -> f32 {
    if bit == 0 { -1.0 } else { 1.0 }
}

/// A square of 2 x 2 in the xy plane, facing +z, of n x m quads, each cut in two if `triangles`.
pub fn grid(n: u32, m: u32, triangles: bool) -> Mesh {
    let positions = (0..=m)
        .flat_map(|j| (0..=n).map(move |i| (i, j)))
        .map(|(i, j)| vec3(i as f32 / n as f32 * 2.0 - 1.0, j as f32 / m as f32 * 2.0 - 1.0, 0.0))
        .collect();
    let mut soup = PolygonSoup { positions, ..PolygonSoup::default() };
    for (i, j) in (0..m).flat_map(|j| (0..n).map(move |i| (i, j))) {
        let a = j * (n + 1) + i;
        let (b, c, d) = (a + 1, a + n + 2, a + n + 1);
        if triangles {
            soup.push_face([a, b, c]);
            soup.push_face([a, c, d]);
        } else {
            soup.push_face([a, b, c, d]);
        }
    }
    Mesh::build(soup).expect("a grid").mesh
}

/// A sphere of quads with triangles around the poles, radius 1.
pub fn sphere(slices: u32, stacks: u32) -> Mesh {
    let mut positions = vec![vec3(0.0, 1.0, 0.0)];
    for j in 1..stacks {
        let down = j as f32 / stacks as f32 * std::f32::consts::PI;
        for i in 0..slices {
            let around = i as f32 / slices as f32 * std::f32::consts::TAU;
            positions.push(vec3(down.sin() * around.sin(), down.cos(), down.sin() * around.cos()));
        }
    }
    positions.push(vec3(0.0, -1.0, 0.0));
    let last = positions.len() as u32 - 1;
    let at = |j: u32, i: u32| 1 + j * slices + i % slices;
    let mut faces: Vec<Vec<u32>> = Vec::new();
    for i in 0..slices {
        faces.push(vec![0, at(0, i), at(0, i + 1)]);
        for j in 0..stacks - 2 {
            faces.push(vec![at(j, i), at(j + 1, i), at(j + 1, i + 1), at(j, i + 1)]);
        }
        faces.push(vec![at(stacks - 2, i), last, at(stacks - 2, i + 1)]);
    }
    mesh(positions, &faces)
}

/// A torus around the y axis of n x m quads; its radii are 1 and 0.4.
pub fn torus(n: u32, m: u32) -> Mesh {
    let place = |i: u32, j: u32| {
        let [around, tube] = [(i, n), (j, m)].map(|(i, n)| i as f32 / n as f32 * std::f32::consts::TAU);
        let radius = 1.0 + 0.4 * tube.cos();
        vec3(radius * around.cos(), 0.4 * tube.sin(), radius * around.sin())
    };
    let positions = (0..n).flat_map(|i| (0..m).map(move |j| place(i, j))).collect();
    let at = |i: u32, j: u32| i % n * m + j % m;
    let quad = |i, j| [at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)];
    let faces: Vec<[u32; 4]> = (0..n).flat_map(|i| (0..m).map(move |j| quad(i, j))).collect();
    mesh(positions, &faces)
}

pub fn paint(mesh: &mut Mesh, face: usize, color: [u8; 3]) {
    mesh.set(keys::FACE_COLOR, face, Color(color));
}

pub fn paint_all(mesh: &mut Mesh, color: [u8; 3]) {
    for face in 0..mesh.face_capacity() {
        paint(mesh, face, color);
    }
}
