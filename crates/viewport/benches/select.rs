//! Picking, and selecting in regions, at a million triangles.

#[path = "../tests/support/mod.rs"]
mod support;

use criterion::{Criterion, criterion_group, criterion_main};
use glam::{Vec2, vec2, vec3};
use halfedge::{Budget, Element, InParts, Mesh, VertexId};
use surface::FaceTree;
use viewport::{Aim, Camera, Region, RegionSelection, ScreenRect, pick_nearest};

const VIEW: Vec2 = Vec2::new(1280.0, 800.0);
/// What the page does in a frame.
const ELEMENTS_PER_FRAME: usize = 150_000;

/// A sheet in waves that hide each other, of a million triangles.
fn waves() -> Mesh {
    let mut mesh = support::grid(1000, 500, true);
    for v in 0..mesh.vertex_capacity() {
        let v = VertexId::new(v);
        let p = mesh.position(v);
        mesh.set_position(v, vec3(p.x, p.y, 0.2 * (p.x * 9.0).sin() * (p.y * 7.0).cos()));
    }
    mesh
}

fn picking(c: &mut Criterion) {
    let mesh = waves();
    let tree = FaceTree::new(&mesh);
    let bounds = surface::measure::bounding_box(&mesh);
    let mut group = c.benchmark_group("pick in 1 million triangles");
    for (name, distance) in [("framed", 3.0), ("near", 0.5), ("far away", 200.0)] {
        let mut camera = Camera { pitch: 0.4, yaw: 1.0, distance, ..Camera::default() };
        camera.set_scene(bounds);
        for (kind, radius, through) in [
            (Element::Vertex, 8.0, false),
            (Element::Edge, 8.0, false),
            (Element::Face, 8.0, false),
            (Element::Edge, 22.0, false),
            (Element::Vertex, 8.0, true),
        ] {
            let aim = Aim { kind, radius, through };
            let x_ray = if through { ", x-ray" } else { "" };
            group.bench_function(format!("{name}, {kind} within {radius}{x_ray}"), |b| {
                let mut at = 0.0_f32;
                b.iter(|| {
                    at += 1.0;
                    let pixel = VIEW * 0.5 + Vec2::from_angle(at) * (at * 0.7 % 300.0);
                    pick_nearest(&mesh, &tree, &camera, VIEW, pixel, aim)
                });
            });
        }
    }
}

fn regions(c: &mut Criterion) {
    let mesh = waves();
    let tree = FaceTree::new(&mesh);
    let camera = Camera { pitch: 0.4, yaw: 1.0, distance: 3.0, ..Camera::default() };
    let lasso = || {
        let at =
            |i: u32| VIEW * 0.5 + Vec2::from_angle(i as f32 * 0.02) * (200.0 + 80.0 * (i as f32 * 0.3).sin());
        Region::lasso((0..314).map(at).collect())
    };
    let all = Region::rect(ScreenRect { min: Vec2::ZERO, max: VIEW });
    let circle = Region::brush(VIEW * 0.5, VIEW * 0.5 + vec2(20.0, 5.0), 32.0);
    let mut group = c.benchmark_group("select in 1 million triangles");
    group.sample_size(10);
    for (name, region) in [("circle", circle), ("lasso", lasso()), ("box over all", all)] {
        for (kind, visible) in
            [(Element::Vertex, true), (Element::Edge, true), (Element::Face, true), (Element::Edge, false)]
        {
            let x_ray = if visible { "" } else { ", x-ray" };
            let begin = || RegionSelection::new(&camera, VIEW, region.clone(), kind, visible);
            group.bench_function(format!("{name}, {kind}{x_ray}"), |b| {
                b.iter(|| begin().finish((&mesh, &tree)));
            });
            // How long frames take meanwhile.
            let (mut selection, mut longest, mut frames) = (begin(), 0.0_f64, 0);
            loop {
                let start = std::time::Instant::now();
                let found = selection.step((&mesh, &tree), &mut Budget::new(ELEMENTS_PER_FRAME));
                longest = longest.max(start.elapsed().as_secs_f64() * 1e3);
                frames += 1;
                if let Some(found) = found {
                    println!(
                        "{name}, {kind}{x_ray}: {} found in {frames} frames, the longest {longest:.1} ms",
                        found.len()
                    );
                    break;
                }
            }
        }
    }
}

criterion_group!(benches, picking, regions);
criterion_main!(benches);
