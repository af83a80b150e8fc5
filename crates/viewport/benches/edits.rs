//! A flip, split and collapse with its undo, and the upload of both to the graphics card, on meshes of a thousand
//! and of a million triangles: both take the same time.

#[path = "../tests/support/mod.rs"]
mod support;

use criterion::{Criterion, criterion_group, criterion_main};
use halfedge::edit::{self, Connect};
use halfedge::{EdgeId, Mesh, Refusal};
use support::gpu::{Gpu, gpu};
use viewport::{ObjectChange, Renderer, Style};

struct Scene {
    gpu: Gpu,
    renderer: Renderer,
    style: Style,
    mesh: Mesh,
    step: usize,
}

impl Scene {
    fn upload(&mut self, change: ObjectChange<'_>) -> u64 {
        let Gpu { device, queue } = &self.gpu;
        self.renderer.sync_object(device, queue, 1, &self.mesh, change, &self.style)
    }

    /// Waits until the graphics card has received all writes.
    fn wait(&self) {
        self.gpu.queue.submit([]);
        self.gpu.device.poll(wgpu::PollType::wait_indefinitely()).expect("uploaded");
    }

    /// Makes an edit at another edge each time, uploads it, undoes it and uploads that.
    fn edit_and_undo(&mut self, edit: impl Fn(&mut Mesh, EdgeId) -> Result<(), Refusal>) {
        self.step += 7919;
        let edge = EdgeId::new(self.step % self.mesh.edge_capacity());
        let Ok(((), journal)) = self.mesh.transaction(|mesh| edit(mesh, edge)) else { return };
        self.upload(ObjectChange::Touched(&journal.touched()));
        self.wait();
        let redo = self.mesh.undo(journal);
        self.upload(ObjectChange::Touched(&redo.touched()));
        self.wait();
    }
}

fn one_edit(c: &mut Criterion) {
    for (name, n, m) in [("1 thousand triangles", 25, 20), ("1 million triangles", 1000, 500)] {
        let gpu = gpu();
        let renderer = gpu.renderer();
        let mesh = support::grid(n, m, true);
        let mut scene = Scene { gpu, renderer, style: Style::default(), mesh, step: 0 };
        scene.upload(ObjectChange::Everything);
        scene.wait();
        let split = |mesh: &mut Mesh, edge| edit::split_edge(mesh, edge, 0.5, Connect::Triangles).map(drop);
        // From here on, columns and buffers have room for a split.
        scene.edit_and_undo(split);
        let mut group = c.benchmark_group(format!("{name}, with undo and uploads"));
        group.bench_function("flip", |b| b.iter(|| scene.edit_and_undo(edit::flip_edge)));
        group.bench_function("split", |b| b.iter(|| scene.edit_and_undo(split)));
        group.bench_function("collapse", |b| {
            b.iter(|| scene.edit_and_undo(|mesh, edge| edit::collapse_edge(mesh, edge, 0.5).map(drop)));
        });
    }
}

criterion_group!(benches, one_edit);
criterion_main!(benches);
