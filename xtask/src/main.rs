//! `cargo xtask`: the tasks of developing Meshwright.

#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable))]
#![cfg_attr(not(test), deny(clippy::indexing_slicing))]

mod bench;
mod bench_wasm;
mod dist;
mod measures;
mod project;
mod serve;
mod setup;
mod shell;
mod site;
mod test;

use std::process::ExitCode;

use project::Project;
use shell::Result;

const USAGE: &str = "\
cargo xtask TASK

  setup             install the tools that the tasks need and that are missing
  serve [--port N]  build the page, serve it on 127.0.0.1 (port 8080) and rebuild it on change
  test [--only STAGES] [-- ARGS]
                    run the stages fmt, measures, clippy, native, wasm and e2e, or those named (`--only native,e2e`);
                    ARGS go to the one stage named (`--only native -- -p halfedge`, `--only e2e -- smoke`)
  measures          print the measures of the code's structure, each with its limit
  builds            compile what the tests need and print what is compiled more than once
  bench [ARGS]      run the criterion benchmarks (`bench -p surface`, `bench subdivide`)
  bench --wasm      time the large jobs natively and in WebAssembly under Node, side by side
  dist              build the optimised static site into dist/

Every task first installs the tools that it needs and that are missing, into .tools/ or $MESHWRIGHT_TOOLS.
";

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    match run(&args) {
        Ok(code) => code,
        Err(message) => {
            eprintln!("\nerror: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(args: &[String]) -> Result<ExitCode> {
    let Some((task, args)) = args.split_first() else {
        print!("{USAGE}");
        return Ok(ExitCode::SUCCESS);
    };
    let project = Project::find()?;
    match task.as_str() {
        "setup" => no_args(args).and_then(|()| setup::everything(&project))?,
        "serve" => serve::run(&project, args)?,
        "test" => return test::run(&project, args),
        "bench" if matches!(args, [flag] if flag == "--wasm") => bench_wasm::run(&project)?,
        "bench" => bench::run(&project, args)?,
        "builds" => no_args(args).and_then(|()| test::print_builds(&project))?,
        "measures" => no_args(args).and_then(|()| measures::run(&project))?,
        "dist" => no_args(args).and_then(|()| dist::run(&project))?,
        "help" | "--help" | "-h" => print!("{USAGE}"),
        other => return Err(format!("there is no task `{other}`.\n\n{USAGE}")),
    }
    Ok(ExitCode::SUCCESS)
}

fn no_args(args: &[String]) -> Result {
    match args.first() {
        Some(arg) => Err(format!("unexpected argument `{arg}`.\n\n{USAGE}")),
        None => Ok(()),
    }
}
