//! Meshes of all kinds, made in code.

use glam::{Vec2, Vec3};
use halfedge::attribute::{Column, Key};
use halfedge::{Color, Element, HalfedgeId, Mesh, PolygonSoup, VertexId, keys};

/// A mesh of polygons, which must need no repair.
pub fn mesh<F: AsRef<[u32]>>(positions: Vec<Vec3>, faces: &[F]) -> Mesh {
    let built = Mesh::build(PolygonSoup::new(positions, faces)).unwrap();
    assert!(built.notes.is_empty(), "{:?}", built.notes);
    built.mesh.validate().unwrap();
    built.mesh
}

pub fn v(index: usize) -> VertexId {
    VertexId::new(index)
}

/// The numbers of vertices, edges and faces of a mesh, which must be valid.
pub fn counts(mesh: &Mesh) -> [usize; 3] {
    mesh.validate().unwrap();
    [mesh.vertex_count(), mesh.edge_count(), mesh.face_count()]
}

/// The half-edge from one vertex to another, by number.
pub fn he(mesh: &Mesh, from: usize, to: usize) -> HalfedgeId {
    mesh.find_halfedge(v(from), v(to)).unwrap()
}

/// The faces as cycles of vertex numbers that start with the smallest, sorted.
pub fn faces(mesh: &Mesh) -> Vec<Vec<u32>> {
    let mut all: Vec<Vec<u32>> = mesh
        .faces()
        .map(|f| {
            let mut corners: Vec<u32> = mesh.face_vertices(f).map(VertexId::raw).collect();
            let first = (0..corners.len()).min_by_key(|&i| corners[i]).unwrap();
            corners.rotate_left(first);
            corners
        })
        .collect();
    all.sort();
    all
}

pub fn triangle() -> Mesh {
    mesh(vec![Vec3::ZERO, Vec3::X, Vec3::Y], &[[0, 1, 2]])
}

/// Two triangles back to back.
pub fn pillow() -> Mesh {
    mesh(vec![Vec3::ZERO, Vec3::X, Vec3::Y], &[[0, 1, 2], [2, 1, 0]])
}

pub fn tetrahedron() -> Mesh {
    let p = vec![Vec3::ZERO, Vec3::X, Vec3::Y, Vec3::Z];
    mesh(p, &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
}

/// Two hexagons back to back, the front one cut from 0 to 3: two quads against a hexagon.
pub fn cut_coin() -> Mesh {
    let mut mesh = coin(6);
    halfedge::edit::connect_vertices(&mut mesh, v(0), v(3)).unwrap();
    mesh
}

/// A cube of side 2 round the origin; vertex 4i + 2j + k has the i-th x, the j-th y and the k-th z.
pub fn cube() -> Mesh {
    let p = (0..8u8)
        .map(|i| Vec3::new(f32::from(i >> 2), f32::from(i >> 1 & 1), f32::from(i & 1)) * 2.0 - Vec3::ONE)
        .collect();
    mesh(p, &[[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]])
}

pub fn octahedron() -> Mesh {
    let p = vec![Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::NEG_Y, Vec3::Z, Vec3::NEG_Z];
    mesh(p, &[[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]])
}

/// A flat grid of m x n quads in the xy plane; vertex j * (m + 1) + i is at (i, j).
pub fn grid(m: u32, n: u32) -> Mesh {
    let p = (0..=n).flat_map(|j| (0..=m).map(move |i| Vec3::new(i as f32, j as f32, 0.0))).collect();
    let at = |i: u32, j: u32| j * (m + 1) + i;
    let quads: Vec<[u32; 4]> = (0..n)
        .flat_map(|j| (0..m).map(move |i| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]))
        .collect();
    mesh(p, &quads)
}

/// A grid of triangles.
pub fn triangle_grid(m: u32, n: u32) -> Mesh {
    let mut mesh = grid(m, n);
    for face in mesh.faces().collect::<Vec<_>>() {
        halfedge::edit::triangulate_face(&mut mesh, face, halfedge::edit::Triangulation::Fan).unwrap();
    }
    mesh
}

/// A closed torus of m x n quads.
pub fn torus(m: u32, n: u32) -> Mesh {
    let angle = |i: u32, n: u32| i as f32 / n as f32 * std::f32::consts::TAU;
    let p = (0..m)
        .flat_map(|i| {
            (0..n).map(move |j| {
                let (u, w) = (angle(i, m), angle(j, n));
                Vec3::new((3.0 + w.cos()) * u.cos(), (3.0 + w.cos()) * u.sin(), w.sin())
            })
        })
        .collect();
    let at = |i: u32, j: u32| i % m * n + j % n;
    let quads: Vec<[u32; 4]> = (0..m)
        .flat_map(|i| (0..n).map(move |j| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]))
        .collect();
    mesh(p, &quads)
}

/// The outside of 5 x 3 unit cubes in the xy plane without two of them: genus 2, quads only.
pub fn genus_two() -> Mesh {
    let solid = |i: i32, j: i32, k: i32| {
        (0..5).contains(&i) && (0..3).contains(&j) && k == 0 && (i, j) != (1, 1) && (i, j) != (3, 1)
    };
    let mut positions = Vec::new();
    let mut number = std::collections::HashMap::new();
    let mut quads = Vec::new();
    for (i, j) in (0..5).flat_map(|i| (0..3).map(move |j| (i, j))) {
        if !solid(i, j, 0) {
            continue;
        }
        for axis in 0..3 {
            for side in [0, 1] {
                let mut across = [i, j, 0];
                across[axis] += if side == 1 { 1 } else { -1 };
                if solid(across[0], across[1], across[2]) {
                    continue;
                }
                let (a, b) = ((axis + 1) % 3, (axis + 2) % 3);
                let mut quad: Vec<u32> = [(0, 0), (1, 0), (1, 1), (0, 1)]
                    .iter()
                    .map(|&(s, t)| {
                        let mut at = [i, j, 0];
                        at[axis] += side;
                        at[a] += s;
                        at[b] += t;
                        *number.entry(at).or_insert_with(|| {
                            positions.push(Vec3::new(at[0] as f32, at[1] as f32, at[2] as f32));
                            positions.len() as u32 - 1
                        })
                    })
                    .collect();
                if side == 0 {
                    quad.reverse();
                }
                quads.push(quad);
            }
        }
    }
    mesh(positions, &quads)
}

/// Two n-gons back to back: every vertex has two edges.
pub fn coin(n: u32) -> Mesh {
    let p = (0..n).map(|i| Vec3::from((Vec2::from_angle(i as f32 / n as f32 * 6.2831855), 0.0))).collect();
    let front: Vec<u32> = (0..n).collect();
    let back: Vec<u32> = (0..n).rev().collect();
    mesh(p, &[front, back])
}

/// Two poles of valence n with a belt of n quads between two fans.
pub fn lantern(n: u32) -> Mesh {
    let mut p = vec![Vec3::Z * 2.0, Vec3::NEG_Z * 2.0];
    for z in [0.5, -0.5] {
        p.extend((0..n).map(|i| Vec3::from((Vec2::from_angle(i as f32 / n as f32 * 6.2831855), z))));
    }
    let (up, down) = (|i: u32| 2 + i % n, |i: u32| 2 + n + i % n);
    let mut faces = Vec::new();
    for i in 0..n {
        faces.push(vec![0, up(i), up(i + 1)]);
        faces.push(vec![1, down(i + 1), down(i)]);
        faces.push(vec![up(i), down(i), down(i + 1), up(i + 1)]);
    }
    mesh(p, &faces)
}

/// A 3 x 3 grid without its middle: two boundary loops.
pub fn frame() -> Mesh {
    let mut mesh = grid(3, 3);
    let middle = mesh.faces().nth(4).unwrap();
    halfedge::edit::delete_faces(&mut mesh, &[middle]).unwrap();
    mesh.compact();
    mesh
}

/// A triangle, quads and a pentagon, with a boundary.
pub fn patchwork() -> Mesh {
    let p = [(0, 0), (2, 0), (4, 0), (5, 2), (4, 4), (2, 4), (0, 4), (-1, 2), (1, 2), (3, 2), (2, 1)]
        .iter()
        .map(|&(x, y)| Vec3::new(x as f32, y as f32, ((x * 7 + y * 3) % 5) as f32 / 10.0))
        .collect();
    let faces: [&[u32]; 6] =
        [&[0, 1, 10, 8], &[1, 2, 9, 10], &[2, 3, 4, 9], &[9, 4, 5], &[8, 10, 9, 5, 6], &[0, 8, 6, 7]];
    mesh(p, &faces)
}

/// Several components in one mesh.
pub fn several() -> Mesh {
    let mut positions = Vec::new();
    let mut polygons: Vec<Vec<u32>> = Vec::new();
    for (i, part) in [cube(), triangle(), tetrahedron(), grid(2, 2)].into_iter().enumerate() {
        let base = positions.len() as u32;
        positions.extend(part.positions().iter().map(|p| *p + Vec3::X * 5.0 * i as f32));
        polygons
            .extend(part.faces().map(|f| part.face_vertices(f).map(|v| v.raw() + base).collect::<Vec<_>>()));
    }
    mesh(positions, &polygons)
}

/// Three quads on a sphere; one ring runs through all of them and crosses itself in each. The dual of a drawing of the
/// trefoil knot.
pub fn trefoil() -> Mesh {
    let p = vec![Vec3::Z, Vec3::NEG_Z, Vec3::X, Vec3::new(-0.5, 0.8, 0.0), Vec3::new(-0.5, -0.8, 0.0)];
    mesh(p, &[[0, 2, 1, 3], [0, 3, 1, 4], [0, 4, 1, 2]])
}

/// Császár's torus of seven vertices, each joined to all others.
pub fn complete_torus() -> Mesh {
    let p = (0..7).map(|i| Vec3::new(i as f32, (i * i % 7) as f32, (i * i * i % 5) as f32)).collect();
    let faces: Vec<[u32; 3]> =
        (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 3) % 7, (i + 2) % 7]]).collect();
    mesh(p, &faces)
}

/// All meshes, with their names.
pub fn all() -> Vec<(&'static str, Mesh)> {
    vec![
        ("triangle", triangle()),
        ("pillow", pillow()),
        ("tetrahedron", tetrahedron()),
        ("cube", cube()),
        ("octahedron", octahedron()),
        ("grid", grid(4, 3)),
        ("triangle grid", triangle_grid(4, 4)),
        ("torus", torus(6, 4)),
        ("genus two", genus_two()),
        ("coin", coin(7)),
        ("lantern", lantern(16)),
        ("frame", frame()),
        ("patchwork", patchwork()),
        ("several", several()),
        ("trefoil", trefoil()),
        ("complete torus", complete_torus()),
    ]
}

/// Gives a mesh columns of all kinds, with different values.
pub fn paint(mesh: &mut Mesh) {
    fn fill<T: halfedge::attribute::AttributeType>(mesh: &mut Mesh, key: Key<T>, value: impl Fn(usize) -> T) {
        let values = (0..mesh.capacity(key.element)).map(value).collect();
        mesh.insert_column(key.element, Column::with_values(key, values));
    }
    fill(mesh, keys::VERTEX_COLOR, |i| Vec3::splat(i as f32));
    fill(mesh, keys::VERTEX_CREASE, |i| i as f32 * 0.25);
    fill(mesh, keys::CORNER_UV, |i| Vec2::new(i as f32, -(i as f32)));
    fill(mesh, keys::CORNER_NORMAL, |i| Vec3::new(i as f32, 1.0, 2.0));
    fill(mesh, keys::EDGE_CREASE, |i| i as f32 * 0.5);
    fill(mesh, keys::FACE_COLOR, |i| Color([i as u8, 7, 9]));
    fill(mesh, keys::FACE_GROUP, |i| i as u32 % 5);
    assert_eq!(mesh.columns().of(Element::Face).len(), 2);
}
