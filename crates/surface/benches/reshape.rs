//! Simplification and remeshing of tori with 10 thousand to 1 million triangles and of the refined bunny;
//! simplification compared with meshoptimizer.

mod meshes;

use self::meshes::{bunny, never_cancel, torus};
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion, criterion_group, criterion_main};
use halfedge::Mesh;
use std::hint::black_box;
use surface::*;

/// Tori of 10 thousand, 100 thousand and 1 million triangles, and the bunny refined.
fn inputs(levels: u32) -> Vec<(&'static str, Mesh)> {
    let sizes = [(100, 50), (500, 100), (1000, 500)];
    let mut meshes: Vec<_> = sizes.map(|(u, v)| ("torus", torus(u, v, true))).into();
    meshes.extend(bunny(levels).map(|mesh| ("bunny", mesh)));
    meshes
}

type Group<'a> = BenchmarkGroup<'a, WallTime>;

#[cfg(feature = "meshopt")]
fn with_meshopt(group: &mut Group<'_>, size: &str, mesh: &Mesh) {
    let positions: Vec<[f32; 3]> = mesh.positions().iter().map(|p| p.to_array()).collect();
    let indices: Vec<u32> =
        mesh.faces().flat_map(|f| mesh.face_vertices(f).map(|v| v.raw()).collect::<Vec<_>>()).collect();
    let bytes = meshopt::typed_to_bytes(&positions);
    let vertices = meshopt::VertexDataAdapter::new(bytes, 12, 0).expect("whole vertices");
    let wanted = indices.len() / 30 * 3;
    let options = meshopt::SimplifyOptions::None;
    group.bench_function(BenchmarkId::new("simplify with meshopt", size), |b| {
        b.iter(|| meshopt::simplify(black_box(&indices), &vertices, wanted, f32::MAX, options, None));
    });
}

/// `cargo xtask bench` asks for it where there is a C++ compiler.
#[cfg(not(feature = "meshopt"))]
fn with_meshopt(_: &mut Group<'_>, _: &str, _: &Mesh) {}

fn reshape(c: &mut Criterion) {
    let mut group = c.benchmark_group("reshape");
    group.sample_size(10);
    for (name, mesh) in inputs(2) {
        let options =
            Simplify { target: SimplifyTarget::Ratio(0.1), preserve_boundary: true, preserve_seams: true };
        let size = format!("{name}, {} triangles to a tenth", mesh.face_count());
        group.bench_function(BenchmarkId::new("simplify", &size), |b| {
            b.iter(|| simplify(black_box(&mesh), &options, &mut never_cancel));
        });
        with_meshopt(&mut group, &size, &mesh);
    }
    for (name, mesh) in inputs(1) {
        let options = Remesh { iterations: 10, ..Remesh::default() };
        let size = format!("{name}, {} triangles, 10 iterations", mesh.face_count());
        group.bench_function(BenchmarkId::new("remesh", size), |b| {
            b.iter(|| remesh(black_box(&mesh), &options, &mut never_cancel));
        });
    }
    group.finish();
}

criterion_group!(benches, reshape);
criterion_main!(benches);
