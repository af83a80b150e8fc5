//! Building meshes of 10 thousand, 100 thousand and a million triangles, and of a quarter of a million quads.

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use glam::Vec3;
use halfedge::{Mesh, PolygonSoup};

/// A wavy torus of `n` by `m` quads, or twice as many triangles.
fn torus(n: u32, m: u32, triangles: bool) -> PolygonSoup {
    let mut soup = PolygonSoup::default();
    for i in 0..n {
        for j in 0..m {
            let (u, v) =
                (i as f32 / n as f32 * std::f32::consts::TAU, j as f32 / m as f32 * std::f32::consts::TAU);
            let r = 1.0 + 0.3 * v.cos() + 0.05 * (7.0 * u).sin();
            soup.positions.push(Vec3::new(r * u.cos(), r * u.sin(), 0.3 * v.sin()));
        }
    }
    let at = |i: u32, j: u32| (i % n) * m + j % m;
    for i in 0..n {
        for j in 0..m {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            if triangles {
                soup.push_face([a, b, c]);
                soup.push_face([a, c, d]);
            } else {
                soup.push_face([a, b, c, d]);
            }
        }
    }
    soup
}

/// The same faces in an order without neighbours next to each other.
fn shuffled(soup: &PolygonSoup) -> PolygonSoup {
    let count = soup.face_count();
    let mut order: Vec<usize> = (0..count).collect();
    let mut state = 0x9e37_79b9_u64;
    for i in (1..count).rev() {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        order.swap(i, (state >> 33) as usize % (i + 1));
    }
    let faces: Vec<&[u32]> = order.iter().map(|&f| soup.face(f)).collect();
    PolygonSoup::new(soup.positions.clone(), &faces)
}

fn build(c: &mut Criterion) {
    let (small, middle) = (torus(100, 50, true), torus(500, 100, true));
    let triangles = torus(1000, 500, true);
    let quads = torus(500, 500, false);
    let scattered = shuffled(&triangles);
    let mut group = c.benchmark_group("build");
    for (name, soup) in [
        ("10k triangles", &small),
        ("100k triangles", &middle),
        ("1M triangles", &triangles),
        ("1M triangles in random order", &scattered),
        ("250k quads", &quads),
    ] {
        group.bench_function(name, |b| {
            b.iter_batched(
                || soup.clone(),
                |soup| Mesh::build(soup).map(|built| built.mesh),
                BatchSize::PerIteration,
            );
        });
    }
    group.finish();
}

criterion_group!(benches, build);
criterion_main!(benches);
