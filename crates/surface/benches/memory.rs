//! The peak memory of each whole-mesh operation, by Linux's count of resident pages: input, result and everything
//! between, as a multiple of the larger of input and result.
//!
//! Each job runs in its own process, so that none starts with memory that another one left.

mod meshes;

use halfedge::Mesh;
use meshes::{bunny, never_cancel, sphere};
use std::io::Write as _;
use std::process::Command;
use surface::*;

const JOBS: [&str; 10] = [
    "catmull-clark",
    "loop",
    "linear",
    "simplify",
    "simplify quads",
    "simplify within a distance",
    "simplify within little",
    "remesh",
    "remesh a scan",
    "merge by distance",
];
/// The environment variable with the job of a child process.
const JOB: &str = "MESHWRIGHT_MEMORY_JOB";

fn main() {
    if let Ok(job) = std::env::var(JOB) {
        run(&job);
        return;
    }
    println!("{:<28} {:>10} {:>10} {:>10} {:>7}", "job", "input", "result", "peak", "ratio");
    for job in JOBS {
        let this = std::env::current_exe().expect("has a path");
        let done = Command::new(this).env(JOB, job).status().expect("starts");
        assert!(done.success(), "{job} failed");
    }
}

/// A line of `/proc/self/status`, in bytes; none if there is no such file.
fn status(name: &str) -> Option<usize> {
    let text = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(name))?;
    Some(line.split_whitespace().next()?.parse::<usize>().ok()? * 1024)
}

fn run(job: &str) {
    let input = match job {
        "simplify quads" => {
            let levels = CatmullClark { levels: 1, ..CatmullClark::default() };
            subdivide_catmull_clark(&sphere(6.0), &levels, &mut never_cancel).expect("fits")
        }
        "simplify within a distance" | "simplify within little" | "remesh a scan" => {
            bunny(1).unwrap_or_else(|| sphere(7.0))
        }
        "simplify" | "merge by distance" => sphere(8.0),
        _ => sphere(7.0),
    };
    let before = status("VmRSS:");
    // The peak so far came from making the input: reset it.
    let reset = std::fs::OpenOptions::new()
        .write(true)
        .open("/proc/self/clear_refs")
        .and_then(|mut file| file.write_all(b"5"));
    let (Some(before), Ok(())) = (before, reset) else {
        println!("{job:<28} skipped: this system does not tell");
        return;
    };
    let result = operate(job, &input);
    let peak = status("VmHWM:").unwrap_or(0).saturating_sub(before) + input.bytes();
    let larger = input.bytes().max(result.bytes());
    let megabytes = |bytes: usize| format!("{:.1} MB", bytes as f64 / 1e6);
    println!(
        "{job:<28} {:>10} {:>10} {:>10} {:>7.2}",
        megabytes(input.bytes()),
        megabytes(result.bytes()),
        megabytes(peak),
        peak as f64 / larger as f64
    );
}

fn operate(job: &str, mesh: &Mesh) -> Mesh {
    match job {
        "catmull-clark" => {
            subdivide_catmull_clark(mesh, &CatmullClark::default(), &mut never_cancel).expect("fits")
        }
        "loop" => subdivide_loop(mesh, &Loop::default(), &mut never_cancel).expect("fits"),
        "linear" => subdivide_linear(mesh, &Linear { levels: 1 }, &mut never_cancel).expect("fits"),
        "remesh" | "remesh a scan" => remesh(mesh, &Remesh::default(), &mut never_cancel).expect("in range"),
        "merge by distance" => merge_by_distance(mesh, 1e-7, &mut never_cancel).expect("in range").mesh,
        _ => {
            let diagonal = measure::bounding_box(mesh).expect("has vertices").diagonal();
            let target = match job {
                "simplify within a distance" => SimplifyTarget::MaxError(1e-3 * diagonal),
                "simplify within little" => SimplifyTarget::MaxError(1e-4 * diagonal),
                _ => SimplifyTarget::Ratio(0.1),
            };
            simplify(
                mesh,
                &Simplify { target, preserve_boundary: true, preserve_seams: true },
                &mut never_cancel,
            )
            .expect("in range")
            .mesh
        }
    }
}
