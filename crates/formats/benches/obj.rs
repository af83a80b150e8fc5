//! OBJ in and out at 10 thousand, 100 thousand and a million triangles, beside `tobj`.

use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};
use formats::{Format, NamedBytes};
use std::fmt::Write;
use std::ops::ControlFlow;

/// A wavy torus of `2nm` triangles as exporters write it: six decimals, `v` and `f` lines.
fn torus(n: u32, m: u32) -> String {
    let mut text = String::with_capacity((n * m) as usize * 80);
    for i in 0..n {
        for j in 0..m {
            let (u, v) =
                (i as f32 / n as f32 * std::f32::consts::TAU, j as f32 / m as f32 * std::f32::consts::TAU);
            let r = 1.0 + 0.3 * v.cos() + 0.05 * (7.0 * u).sin();
            let _ = writeln!(text, "v {:.6} {:.6} {:.6}", r * u.cos(), r * u.sin(), 0.3 * v.sin());
        }
    }
    let at = |i: u32, j: u32| (i % n) * m + j % m + 1;
    for i in 0..n {
        for j in 0..m {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            let _ = writeln!(text, "f {a} {b} {c}\nf {a} {c} {d}");
        }
    }
    text
}

fn obj(c: &mut Criterion) {
    let mut group = c.benchmark_group("obj");
    for (n, m) in [(100, 50), (500, 100), (1000, 500)] {
        let text = torus(n, m);
        let size = format!("{} triangles", 2 * n * m);
        group.throughput(Throughput::Bytes(text.len() as u64));
        let files = [NamedBytes::new("torus.obj", text.as_str())];
        group.bench_function(BenchmarkId::new("parse", &size), |b| {
            // The first word of progress that building has begun ends the work: what is left is parsing.
            b.iter(|| {
                formats::read(&files, &mut |part| {
                    if part >= 0.5 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
                })
            });
        });
        group.bench_function(BenchmarkId::new("parse and build", &size), |b| {
            b.iter(|| formats::read(&files, &mut |_| ControlFlow::Continue(())));
        });
        let options = tobj::LoadOptions::default();
        group.bench_function(BenchmarkId::new("parse with tobj", &size), |b| {
            b.iter(|| tobj::load_obj_buf(&mut text.as_bytes(), &options, |_| Ok(Default::default())));
        });
        if let Ok(import) = formats::read(&files, &mut |_| ControlFlow::Continue(())) {
            group.bench_function(BenchmarkId::new("write", &size), |b| {
                b.iter(|| formats::write(Format::default(), &import.model));
            });
        }
    }
    group.finish();
}

criterion_group!(benches, obj);
criterion_main!(benches);
