//! `cargo xtask bench --wasm`: times the large jobs natively and in WebAssembly.

use std::process::Command;

use crate::project::Project;
use crate::setup::{self, npm};
use crate::shell::{self, Result};

/// How often each job is run; its best time counts.
const RUNS_PER_JOB: &str = "5";

pub fn run(project: &Project) -> Result {
    let wasm = setup::for_building(project)?;
    // wasm-opt is among its packages.
    npm::ensure(project)?;

    let mut build = shell::cargo();
    build.args(["build", "--profile", "dist", "-p", "timings", "--lib", "--target", setup::TARGET]);
    build.current_dir(&project.root);
    shell::run(wasm.choose_for_dist(&mut build))?;
    let folder = project.target.join("timings");
    shell::make_folder(&folder)?;
    let built = project.target.join(setup::TARGET).join("dist/timings.wasm");
    let mut bind = Command::new(project.tools_bin().join("wasm-bindgen"));
    shell::run(bind.args(["--target", "nodejs", "--out-dir"]).arg(&folder).arg(built))?;
    // As for the page that is shipped.
    let module = folder.join("timings_bg.wasm");
    let mut opt = Command::new("wasm-opt");
    shell::run(opt.arg("-O3").arg(&module).arg("-o").arg(&module).env("PATH", project.path()?))?;

    let mut native = shell::cargo();
    native.args([
        "run",
        "--quiet",
        "--profile",
        "dist",
        "-p",
        "timings",
        "--bin",
        "timings",
        "--",
        RUNS_PER_JOB,
    ]);
    native.current_dir(&project.root);
    let native = times(&mut native)?;
    let mut node = Command::new("node");
    node.arg(project.root.join("crates/timings/node.mjs")).arg(folder.join("timings.js")).arg(RUNS_PER_JOB);
    let node = times(&mut node)?;

    println!("\n{:<46} {:>11} {:>11} {:>7}", "job", "native", "wasm", "ratio");
    for ((name, native), (_, wasm)) in native.iter().zip(&node) {
        println!("{name:<46} {native:>8.1} ms {wasm:>8.1} ms {:>7.2}", wasm / native);
    }
    Ok(())
}

/// Runs a program that prints a name, a tab and milliseconds on each line, and gives those.
fn times(command: &mut Command) -> Result<Vec<(String, f64)>> {
    let mut times = Vec::new();
    let done = shell::run_reading(command, |line| {
        if let Some((name, time)) = line.split_once('\t')
            && let Ok(time) = time.parse()
        {
            times.push((name.to_owned(), time));
        }
    })?;
    if done { Ok(times) } else { Err("the timed jobs failed; their output is above.".to_owned()) }
}
