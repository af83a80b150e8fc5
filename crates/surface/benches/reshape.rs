//! Simplifying and remeshing spheres of triangles.

use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use halfedge::Mesh;
use std::hint::black_box;
use std::ops::ControlFlow;
use surface::*;

fn sphere(subdivisions: f64) -> Mesh {
    let mut shape = Shape::named("ico-sphere").expect("listed");
    shape.set("subdivisions", subdivisions).expect("in range");
    shape.build().expect("fits")
}

fn reshape(c: &mut Criterion) {
    let mut group = c.benchmark_group("reshape");
    group.sample_size(10);
    for subdivisions in [4.0, 6.0, 8.0] {
        let mesh = sphere(subdivisions);
        let options = Simplify { target: SimplifyTarget::Ratio(0.1), preserve_boundary: true };
        let size = format!("{} triangles to a tenth", mesh.face_count());
        group.bench_function(BenchmarkId::new("simplify", size), |b| {
            b.iter(|| simplify(black_box(&mesh), &options, &mut |_| ControlFlow::Continue(())));
        });
    }
    for subdivisions in [4.0, 6.0, 7.0] {
        let mesh = sphere(subdivisions);
        let options = Remesh { iterations: 10, ..Remesh::default() };
        let size = format!("{} triangles, 10 iterations", mesh.face_count());
        group.bench_function(BenchmarkId::new("remesh", size), |b| {
            b.iter(|| remesh(black_box(&mesh), &options, &mut |_| ControlFlow::Continue(())));
        });
    }
    group.finish();
}

criterion_group!(benches, reshape);
criterion_main!(benches);
