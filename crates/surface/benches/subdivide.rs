//! Both subdivisions to about two million faces, from one level's input and from four.

mod meshes;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use glam::Vec3;
use halfedge::{Mesh, PolygonSoup};
use std::hint::black_box;
use std::ops::ControlFlow;
use surface::*;

/// A torus of `u` by `v` quads, or twice as many triangles.
fn torus(u: u32, v: u32, triangles: bool) -> Mesh {
    let mut soup = PolygonSoup::default();
    for i in 0..u * v {
        let (a, b) = ((i % u) as f32 / u as f32, (i / u) as f32 / v as f32);
        let ((sin_a, cos_a), (sin_b, cos_b)) =
            ((a * std::f32::consts::TAU).sin_cos(), (b * std::f32::consts::TAU).sin_cos());
        let r = 1.0 + 0.4 * cos_b;
        soup.positions.push(Vec3::new(r * cos_a, r * sin_a, 0.4 * sin_b));
    }
    let at = |x: u32, y: u32| (y % v) * u + x % u;
    for y in 0..v {
        for x in 0..u {
            let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
            if triangles {
                soup.push_face([a, b, c]);
                soup.push_face([a, c, d]);
            } else {
                soup.push_face([a, b, c, d]);
            }
        }
    }
    Mesh::build(soup).expect("small").mesh
}

fn subdivide(c: &mut Criterion) {
    let mut group = c.benchmark_group("subdivide");
    group.sample_size(10);
    for (levels, u, v) in [(1, 1000, 500), (4, 125, 64), (1, 50, 50), (1, 250, 100)] {
        let mesh = torus(u, v, false);
        let options = CatmullClark { levels, ..CatmullClark::default() };
        let faces = quad_split_faces(&mesh, levels);
        group.bench_function(
            BenchmarkId::new("catmull-clark", format!("{levels} levels to {faces} quads")),
            |b| {
                b.iter(|| {
                    subdivide_catmull_clark(black_box(&mesh), &options, &mut |_| ControlFlow::Continue(()))
                });
            },
        );
    }
    for (levels, u, v) in [(1, 500, 400), (3, 125, 100), (1, 50, 25), (1, 125, 100)] {
        let mesh = torus(u, v, true);
        let options = Loop { levels, ..Loop::default() };
        let faces = mesh.face_count() << (2 * levels);
        group.bench_function(
            BenchmarkId::new("loop", format!("{levels} levels to {faces} triangles")),
            |b| {
                b.iter(|| subdivide_loop(black_box(&mesh), &options, &mut |_| ControlFlow::Continue(())));
            },
        );
    }
    if let Some(bunny) = meshes::bunny(0) {
        let options = Loop { levels: 2, ..Loop::default() };
        group.bench_function(BenchmarkId::new("loop", "the bunny, 2 levels to 1111216 triangles"), |b| {
            b.iter(|| subdivide_loop(black_box(&bunny), &options, &mut meshes::go_on));
        });
    }
    group.finish();
}

criterion_group!(benches, subdivide);
criterion_main!(benches);
