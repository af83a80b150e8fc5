//! Normals and the face tree on a million triangles.

use criterion::{Criterion, criterion_group, criterion_main};
use glam::Vec3;
use halfedge::FaceId;
use std::hint::black_box;
use surface::*;

fn queries(c: &mut Criterion) {
    let mut shape = Shape::named("ico-sphere").expect("listed");
    shape.set("subdivisions", 8.0).expect("in range");
    let mesh = shape.build().expect("fits");
    let size = format!("{} triangles", mesh.face_count());
    let mut group = c.benchmark_group(format!("queries on {size}"));
    group.sample_size(10);
    group.bench_function("face normals", |b| b.iter(|| normals::face_normals(black_box(&mesh))));
    group.bench_function("vertex normals", |b| b.iter(|| normals::vertex_normals(black_box(&mesh))));
    group.bench_function("face tree: build", |b| b.iter(|| FaceTree::new(black_box(&mesh))));
    let mut tree = FaceTree::new(&mesh);
    let mut turn = 0u32;
    group.bench_function("face tree: update one face", |b| {
        b.iter(|| {
            turn = turn.wrapping_add(7919);
            tree.update(&mesh, [FaceId::new(turn as usize % mesh.face_count())]);
        });
    });
    let mut direction = move || {
        turn = turn.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let unit = |bits: u32| (bits & 0x3ff) as f32 / 511.5 - 1.0;
        Vec3::new(unit(turn >> 2), unit(turn >> 12), unit(turn >> 22)) + Vec3::splat(1e-3)
    };
    group.bench_function("face tree: ray", |b| {
        b.iter(|| tree.hit(&mesh, Ray { origin: direction() * 3.0, direction: direction() }));
    });
    group.bench_function("face tree: closest point", |b| {
        b.iter(|| tree.closest_point(&mesh, direction().normalize() * 1.01))
    });
    group.finish();
}

criterion_group!(benches, queries);
criterion_main!(benches);
