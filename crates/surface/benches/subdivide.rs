//! Both subdivisions to about two million faces, in one level and in four.

mod meshes;

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use meshes::{bunny, never_cancel, torus};
use std::hint::black_box;
use surface::*;

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
                b.iter(|| subdivide_catmull_clark(black_box(&mesh), &options, &mut never_cancel));
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
                b.iter(|| subdivide_loop(black_box(&mesh), &options, &mut never_cancel));
            },
        );
    }
    if let Some(bunny) = bunny(0) {
        let options = Loop { levels: 2, ..Loop::default() };
        group.bench_function(BenchmarkId::new("loop", "the bunny, 2 levels to 1111216 triangles"), |b| {
            b.iter(|| subdivide_loop(black_box(&bunny), &options, &mut never_cancel));
        });
    }
    group.finish();
}

criterion_group!(benches, subdivide);
criterion_main!(benches);
