//! The meshes that the benchmarks run on.
#![allow(dead_code, reason = "each benchmark uses its part")]

use glam::Vec3;
use halfedge::{Mesh, PolygonSoup};
use std::ops::ControlFlow;
use surface::{Loop, Shape, subdivide_loop};

/// A progress callback that never cancels.
pub fn never_cancel(_: f32) -> ControlFlow<()> {
    ControlFlow::Continue(())
}

/// A sphere of 20 triangles, each divided into four `subdivisions` times.
pub fn sphere(subdivisions: f64) -> Mesh {
    let mut shape = Shape::named("ico-sphere").expect("listed");
    shape.set("subdivisions", subdivisions).expect("in range");
    shape.build().expect("fits")
}

/// A torus of `u` by `v` quads, or twice as many triangles.
pub fn torus(u: u32, v: u32, triangles: bool) -> Mesh {
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

/// The Stanford bunny with 69 thousand triangles after this many levels of Loop subdivision; none, with a message,
/// if the shared models are missing.
pub fn bunny(levels: u32) -> Option<Mesh> {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../../shared/models/common/stanford-bunny.obj");
    let Ok(text) = std::fs::read_to_string(&path) else {
        eprintln!("skipped: {} is missing", path.display());
        return None;
    };
    let mut soup = PolygonSoup::default();
    for line in text.lines() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => {
                let mut number = || words.next().and_then(|word| word.parse().ok()).expect("a number");
                soup.positions.push(Vec3::new(number(), number(), number()));
            }
            Some("f") => {
                let corner = |word: &str| word.parse::<u32>().expect("an index") - 1;
                soup.push_face(words.map(corner).collect::<Vec<_>>());
            }
            _ => {}
        }
    }
    let mesh = Mesh::build(soup).expect("fits").mesh;
    let options = Loop { levels, ..Loop::default() };
    Some(subdivide_loop(&mesh, &options, &mut never_cancel).expect("fits"))
}
