//! Meshes and comparisons for the tests of this crate.
#![allow(dead_code, reason = "each test file uses its part")]

use glam::{DVec3, Vec3};
use halfedge::{Mesh, PolygonSoup};
use proptest::prelude::*;
use std::ops::ControlFlow;

/// A progress callback that never cancels.
pub fn never_cancel(_: f32) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// A mesh from positions and faces that must need no repair.
pub fn mesh(positions: &[[f32; 3]], faces: &[&[u32]]) -> Mesh {
    build(PolygonSoup::new(positions.iter().map(|&p| Vec3::from_array(p)).collect(), faces))
}

pub fn build(soup: PolygonSoup) -> Mesh {
    let built = Mesh::build(soup).expect("small");
    assert!(built.notes.is_empty(), "{:?}", built.notes);
    built.mesh.validate().expect("valid");
    built.mesh
}

pub fn cube() -> Mesh {
    mesh(
        &[
            [-1., -1., -1.],
            [1., -1., -1.],
            [-1., 1., -1.],
            [1., 1., -1.],
            [-1., -1., 1.],
            [1., -1., 1.],
            [-1., 1., 1.],
            [1., 1., 1.],
        ],
        &[&[0, 2, 3, 1], &[4, 5, 7, 6], &[0, 1, 5, 4], &[2, 6, 7, 3], &[0, 4, 6, 2], &[1, 3, 7, 5]],
    )
}

pub fn tetrahedron() -> Mesh {
    mesh(
        &[[1., 1., 1.], [1., -1., -1.], [-1., 1., -1.], [-1., -1., 1.]],
        &[&[0, 1, 2], &[0, 3, 1], &[0, 2, 3], &[1, 3, 2]],
    )
}

/// A flat grid of `n` by `n` unit quads in the xy plane, facing +z.
pub fn grid(n: u32) -> Mesh {
    let side = n + 1;
    let positions = (0..side * side).map(|i| Vec3::new((i % side) as f32, (i / side) as f32, 0.0)).collect();
    let faces: Vec<[u32; 4]> = (0..n * n)
        .map(|i| {
            let a = i / n * side + i % n;
            [a, a + 1, a + side + 1, a + side]
        })
        .collect();
    build(PolygonSoup::new(positions, &faces))
}

/// The content of a cell of [`random_mesh`].
#[derive(Clone, Copy, Debug)]
pub enum Cell {
    Quad,
    Triangles,
    OtherTriangles,
    Hole,
    /// One six-sided polygon with the cell to the right.
    Merged,
    /// Four triangles around a vertex of their own.
    Poked,
}

/// Grids of mixed polygons with holes, bumps and isolated vertices, open or closed in one or both directions; with
/// `triangles` only triangles and holes.
pub fn random_mesh(triangles: bool) -> impl Strategy<Value = Mesh> {
    let cell = if triangles {
        prop_oneof![3 => Just(Cell::Triangles), 2 => Just(Cell::OtherTriangles), 1 => Just(Cell::Hole), 1 => Just(Cell::Poked)]
            .boxed()
    } else {
        prop_oneof![
            4 => Just(Cell::Quad),
            2 => Just(Cell::Triangles),
            1 => Just(Cell::OtherTriangles),
            1 => Just(Cell::Hole),
            2 => Just(Cell::Merged),
            1 => Just(Cell::Poked),
        ]
        .boxed()
    };
    (3usize..8, 3usize..8, any::<bool>(), any::<bool>())
        .prop_flat_map(move |(w, h, wrap_x, wrap_y)| {
            (
                Just((w, h, wrap_x, wrap_y)),
                prop::collection::vec(cell.clone(), w * h),
                prop::collection::vec(-0.3f32..0.3, 3 * (w + 1) * (h + 1)),
            )
        })
        .prop_map(|((w, h, wrap_x, wrap_y), cells, noise)| patchwork(w, h, wrap_x, wrap_y, &cells, &noise))
}

fn patchwork(w: usize, h: usize, wrap_x: bool, wrap_y: bool, cells: &[Cell], noise: &[f32]) -> Mesh {
    let columns = if wrap_x { w } else { w + 1 };
    let rows = if wrap_y { h } else { h + 1 };
    let id = |x: usize, y: usize| ((y % rows) * columns + x % columns) as u32;
    let mut soup = PolygonSoup::default();
    for y in 0..rows {
        for x in 0..columns {
            let (u, v) = (x as f32 / w as f32, y as f32 / h as f32);
            let ring = std::f32::consts::TAU;
            let at = match (wrap_x, wrap_y) {
                (false, false) => Vec3::new(x as f32, y as f32, 0.0),
                (true, false) => Vec3::new((u * ring).cos() * 3.0, (u * ring).sin() * 3.0, y as f32),
                (false, true) => Vec3::new((v * ring).sin() * 3.0, x as f32, (v * ring).cos() * 3.0),
                (true, true) => {
                    let r = 5.0 + 2.0 * (v * ring).cos();
                    Vec3::new((u * ring).cos() * r, (u * ring).sin() * r, (v * ring).sin() * 2.0)
                }
            };
            let k = 3 * (y * (w + 1) + x);
            soup.positions.push(at + Vec3::new(noise[k], noise[k + 1], noise[k + 2]));
        }
    }
    let mut taken = vec![false; w * h];
    for y in 0..h {
        for x in 0..w {
            if std::mem::replace(&mut taken[y * w + x], true) {
                continue;
            }
            let [a, b, c, d] = [id(x, y), id(x + 1, y), id(x + 1, y + 1), id(x, y + 1)];
            match cells[y * w + x] {
                Cell::Merged if x + 1 < w && !taken[y * w + x + 1] && !(wrap_x && w < 4) => {
                    taken[y * w + x + 1] = true;
                    soup.push_face([a, b, id(x + 2, y), id(x + 2, y + 1), c, d]);
                }
                Cell::Quad | Cell::Merged => soup.push_face([a, b, c, d]),
                Cell::Triangles => {
                    soup.push_face([a, b, c]);
                    soup.push_face([a, c, d]);
                }
                Cell::OtherTriangles => {
                    soup.push_face([a, b, d]);
                    soup.push_face([b, c, d]);
                }
                Cell::Hole => {}
                Cell::Poked => {
                    let middle = soup.positions.len() as u32;
                    let mean = [a, b, c, d].map(|v| soup.positions[v as usize]).iter().sum::<Vec3>() / 4.0;
                    soup.positions.push(mean + Vec3::Z * 0.1);
                    for (p, q) in [(a, b), (b, c), (c, d), (d, a)] {
                        soup.push_face([p, q, middle]);
                    }
                }
            }
        }
    }
    // Only faces that meet at a vertex alone may be separated.
    let mesh = Mesh::build(soup).expect("small").mesh;
    mesh.validate().expect("valid");
    mesh
}

/// Reads the `v` and `f` lines of an OBJ with positive indices, positions in 64 bits.
pub fn read_obj(path: &std::path::Path) -> (Vec<DVec3>, Vec<Vec<u32>>) {
    let text = std::fs::read_to_string(path).expect("readable");
    let (mut positions, mut faces) = (Vec::new(), Vec::new());
    for line in text.lines() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => {
                let p: Vec<f64> = words.take(3).map(|w| w.parse().expect("number")).collect();
                positions.push(DVec3::new(p[0], p[1], p[2]));
            }
            Some("f") => faces.push(
                words
                    .map(|w| w.split('/').next().expect("index").parse::<u32>().expect("index") - 1)
                    .collect(),
            ),
            _ => {}
        }
    }
    (positions, faces)
}

pub fn load(path: &std::path::Path) -> Mesh {
    let (positions, faces) = read_obj(path);
    build(PolygonSoup::new(positions.iter().map(|p| p.as_vec3()).collect(), &faces))
}

pub fn diagonal(points: &[DVec3]) -> f64 {
    let min = points.iter().copied().reduce(DVec3::min).unwrap_or_default();
    let max = points.iter().copied().reduce(DVec3::max).unwrap_or_default();
    (max - min).length()
}

/// The largest distance from a point of `from` to its nearest in `to`.
pub fn farthest(from: &[DVec3], to: &[DVec3]) -> f64 {
    let mut sorted = to.to_vec();
    sorted.sort_by(|a, b| a.x.total_cmp(&b.x));
    let mut worst = 0.0f64;
    for p in from {
        let start = sorted.partition_point(|q| q.x < p.x);
        let mut best = f64::INFINITY;
        for q in &sorted[start..] {
            if q.x - p.x >= best {
                break;
            }
            best = best.min(q.distance(*p));
        }
        for q in sorted[..start].iter().rev() {
            if p.x - q.x >= best {
                break;
            }
            best = best.min(q.distance(*p));
        }
        worst = worst.max(best);
    }
    worst
}

/// The volume between the triangles of a mesh and the origin. For two open surfaces with the same boundary, it
/// differs by the volume between them.
pub fn volume_from_origin(mesh: &Mesh) -> f64 {
    let of_face = |f| {
        let p: Vec<DVec3> = mesh.face_vertices(f).map(|v| mesh.position(v).as_dvec3()).collect();
        p[0].dot(p[1].cross(p[2])) / 6.0
    };
    mesh.faces().map(of_face).sum()
}

pub fn points(mesh: &Mesh) -> Vec<DVec3> {
    mesh.vertices().map(|v| mesh.position(v).as_dvec3()).collect()
}
