//! Large jobs that `cargo xtask bench --wasm` times natively and in WebAssembly.

#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable))]
#![cfg_attr(not(test), deny(clippy::indexing_slicing))]

use std::fmt::Write;
use std::hint::black_box;
use std::ops::ControlFlow;

use formats::NamedBytes;
use glam::Vec3;
use halfedge::{Mesh, PolygonSoup};
use surface::{CatmullClark, Loop, Remesh, Simplify, SimplifyTarget};

#[cfg(target_arch = "wasm32")]
mod node;

/// A job whose input has been made.
pub type Prepared = Box<dyn FnMut()>;

/// A job's name, and the function that makes its input.
pub type Job = (&'static str, fn() -> Prepared);

/// The jobs. Each runs on one thread.
pub const JOBS: &[Job] = &[
    ("parse OBJ, 1 million triangles", parse),
    ("build half-edges, 1 million triangles", build),
    ("Catmull-Clark to 2 million quads", catmull_clark),
    ("Loop to 1.6 million triangles", loop_rule),
    ("simplify 1 million triangles to 10%", simplify),
    ("remesh 260 thousand triangles, 10 iterations", remesh),
];

fn parse() -> Prepared {
    let soup = wavy_torus(1000, 500, true);
    let mut text = String::with_capacity(40 << 20);
    for p in &soup.positions {
        let _ = writeln!(text, "v {:.6} {:.6} {:.6}", p.x, p.y, p.z);
    }
    for corners in soup.corners.chunks(3) {
        if let [a, b, c] = corners {
            let _ = writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1);
        }
    }
    let files = [NamedBytes::new("torus.obj", text)];
    Box::new(move || {
        // Stop as soon as the progress says that building begins, so that only parsing is timed.
        let _ = black_box(formats::read(&files, &mut |part| {
            if part >= 0.5 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        }));
    })
}

fn build() -> Prepared {
    let soup = wavy_torus(1000, 500, true);
    Box::new(move || drop(black_box(Mesh::build(soup.clone()))))
}

fn catmull_clark() -> Prepared {
    let mesh = mesh(wavy_torus(1000, 500, false));
    Box::new(move || {
        let options = CatmullClark::default();
        drop(black_box(surface::subdivide_catmull_clark(&mesh, &options, &mut never_cancel)));
    })
}

fn loop_rule() -> Prepared {
    let mesh = mesh(wavy_torus(500, 400, true));
    Box::new(move || drop(black_box(surface::subdivide_loop(&mesh, &Loop::default(), &mut never_cancel))))
}

fn simplify() -> Prepared {
    let mesh = mesh(wavy_torus(1000, 500, true));
    let options =
        Simplify { target: SimplifyTarget::Ratio(0.1), preserve_boundary: true, preserve_seams: true };
    Box::new(move || drop(black_box(surface::simplify(&mesh, &options, &mut never_cancel))))
}

fn remesh() -> Prepared {
    let mesh = mesh(wavy_torus(520, 250, true));
    let options = Remesh { iterations: 10, ..Remesh::default() };
    Box::new(move || drop(black_box(surface::remesh(&mesh, &options, &mut never_cancel))))
}

fn never_cancel(_: f32) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

fn mesh(soup: PolygonSoup) -> Mesh {
    Mesh::build(soup).map(|built| built.mesh).unwrap_or_default()
}

/// A torus of `u` by `v` quads, or of twice as many triangles, with waves along it.
fn wavy_torus(u: u32, v: u32, triangles: bool) -> PolygonSoup {
    let mut soup = PolygonSoup::default();
    for i in 0..u * v {
        let a = (i / v) as f32 / u as f32 * std::f32::consts::TAU;
        let b = (i % v) as f32 / v as f32 * std::f32::consts::TAU;
        let r = 1.0 + 0.3 * b.cos() + 0.05 * (7.0 * a).sin();
        soup.positions.push(Vec3::new(r * a.cos(), r * a.sin(), 0.3 * b.sin()));
    }
    let at = |x: u32, y: u32| (x % u) * v + y % v;
    for x in 0..u {
        for y in 0..v {
            let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
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
