//! The peak of memory that each whole-mesh operation takes, by Linux's count of resident pages: input and
//! result and everything in between, as a multiple of the larger of input and result.
//!
//! Each job runs in a process of its own, so that none starts with what another has left behind.

mod meshes;

use halfedge::Mesh;
use meshes::{bunny, go_on, sphere};
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
/// Which job a child process is to do.
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

/// A line of `/proc/self/status`, in bytes; none where there is no such file.
fn status(name: &str) -> Option<usize> {
    let text = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = text.lines().find_map(|line| line.strip_prefix(name))?;
    Some(line.split_whitespace().next()?.parse::<usize>().ok()? * 1024)
}

fn run(job: &str) {
    let input = match job {
        "simplify quads" => {
            let levels = CatmullClark { levels: 1, ..CatmullClark::default() };
            subdivide_catmull_clark(&sphere(6.0), &levels, &mut go_on).expect("fits")
        }
        "simplify within a distance" | "simplify within little" | "remesh a scan" => {
            bunny(1).unwrap_or_else(|| sphere(7.0))
        }
        "simplify" | "merge by distance" => sphere(8.0),
        _ => sphere(7.0),
    };
    let before = status("VmRSS:");
    // The peak so far is of making the input: count from here.
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
        "catmull-clark" => subdivide_catmull_clark(mesh, &CatmullClark::default(), &mut go_on).expect("fits"),
        "loop" => subdivide_loop(mesh, &Loop::default(), &mut go_on).expect("fits"),
        "linear" => subdivide_linear(mesh, &Linear { levels: 1 }, &mut go_on).expect("fits"),
        "remesh" | "remesh a scan" => remesh(mesh, &Remesh::default(), &mut go_on).expect("in range"),
        "merge by distance" => merge_by_distance(mesh, 1e-7, &mut go_on).expect("in range").mesh,
        _ => {
            let diagonal = measure::bounding_box(mesh).expect("has vertices").diagonal();
            let target = match job {
                "simplify within a distance" => SimplifyTarget::MaxError(1e-3 * diagonal),
                "simplify within little" => SimplifyTarget::MaxError(1e-4 * diagonal),
                _ => SimplifyTarget::Ratio(0.1),
            };
            simplify(mesh, &Simplify { target, preserve_boundary: true, preserve_seams: true }, &mut go_on)
                .expect("in range")
                .mesh
        }
    }
}
