//! A flip, a split and a collapse with their undo take the same time on a thousand and on a million triangles, and edits of
//! large selections time in proportion to the selection.

use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use glam::Vec3;
use halfedge::edit::{self, Connect, Grouping};
use halfedge::{EdgeId, FaceId, Mesh, PolygonSoup, Refusal};

/// A torus of 2 n m triangles.
fn torus(n: u32, m: u32) -> Mesh {
    let mut soup = PolygonSoup::default();
    let at = |i: u32, j: u32| i % n * m + j % m;
    for i in 0..n {
        for j in 0..m {
            let (u, v) =
                (i as f32 / n as f32 * std::f32::consts::TAU, j as f32 / m as f32 * std::f32::consts::TAU);
            let r = 1.0 + 0.3 * v.cos();
            soup.positions.push(Vec3::new(r * u.cos(), r * u.sin(), 0.3 * v.sin()));
            soup.push_face([at(i, j), at(i + 1, j), at(i + 1, j + 1)]);
            soup.push_face([at(i, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    Mesh::build(soup).expect("it fits").mesh
}

/// Makes an edit and undoes it, each time at another edge.
fn there_and_back(
    mesh: &mut Mesh,
    step: &mut usize,
    edit: impl Fn(&mut Mesh, EdgeId) -> Result<(), Refusal>,
) {
    *step += 7919;
    let edge = EdgeId::new(*step % mesh.edge_capacity());
    if let Ok(((), journal)) = mesh.transaction(|mesh| edit(mesh, edge)) {
        std::hint::black_box(journal.touched());
        mesh.undo(journal);
    }
}

fn one_edit(c: &mut Criterion) {
    for (name, n, m) in [("1 thousand triangles", 25, 20), ("1 million triangles", 1000, 500)] {
        let mut group = c.benchmark_group(name);
        let mut mesh = torus(n, m);
        // From now on the columns have room for what a split adds.
        let mut step = 0;
        there_and_back(&mut mesh, &mut step, |m, e| {
            edit::split_edge(m, e, 0.5, Connect::Triangles).map(drop)
        });
        group.bench_function("flip and undo", |b| {
            b.iter(|| there_and_back(&mut mesh, &mut step, edit::flip_edge));
        });
        group.bench_function("split and undo", |b| {
            b.iter(|| {
                there_and_back(&mut mesh, &mut step, |m, e| {
                    edit::split_edge(m, e, 0.5, Connect::Triangles).map(drop)
                });
            });
        });
        group.bench_function("collapse and undo", |b| {
            b.iter(|| there_and_back(&mut mesh, &mut step, |m, e| edit::collapse_edge(m, e, 0.5).map(drop)));
        });
    }
}

fn selections(c: &mut Criterion) {
    let mut group = c.benchmark_group("selection in 1 million triangles");
    group.sample_size(10);
    let mesh = torus(1000, 500);
    for count in [31_250, 125_000, 500_000] {
        group.throughput(Throughput::Elements(count as u64));
        let faces: Vec<FaceId> = mesh.faces().take(count).collect();
        group.bench_function(format!("delete {count} faces"), |b| {
            b.iter_batched(
                || mesh.clone(),
                |mut mesh| edit::delete_faces(&mut mesh, &faces),
                BatchSize::PerIteration,
            );
        });
        group.bench_function(format!("extrude {count} faces"), |b| {
            b.iter_batched(
                || mesh.clone(),
                |mut mesh| edit::extrude_faces(&mut mesh, &faces, Grouping::Region),
                BatchSize::PerIteration,
            );
        });
    }
}

criterion_group!(benches, one_edit, selections);
criterion_main!(benches);
