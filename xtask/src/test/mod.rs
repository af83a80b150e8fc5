//! `cargo xtask test`: runs all checks in stages, the quick ones first.

mod builds;
mod count;
mod stages;

pub use builds::run as print_builds;

use std::process::ExitCode;
use std::time::{Duration, Instant};

use count::Count;
use stages::Stage;

use crate::project::Project;
use crate::shell::{Result, minutes, step};

pub fn run(project: &Project, args: &[String]) -> Result<ExitCode> {
    let (stages, rest) = parse(args)?;
    let start = Instant::now();
    let tools = stages::Tools::ensure(project, &stages)?;
    let mut rows = vec![("set-up", Count::default(), start.elapsed())];
    let mut total = Count::default();
    let mut failure = None;
    for stage in &stages {
        println!();
        step(format!("stage {}", stage.name()));
        let stage_start = Instant::now();
        let (count, result) = stage.run(project, &tools, &rest);
        rows.push((stage.name(), count.clone(), stage_start.elapsed()));
        total += count;
        if let Err(message) = result {
            failure = Some((stage.name(), message));
            break;
        }
    }
    rows.push(("all", total.clone(), start.elapsed()));
    report(&rows);
    if failure.is_some() && rows.len() < stages.len() + 2 {
        println!("{} later stages were not run", stages.len() + 2 - rows.len());
    }
    if !total.left_out.is_empty() {
        println!("\n{} tests were left out:", total.left_out.len());
        total.left_out.iter().for_each(|name| println!("    {name}"));
    }
    if let Some((stage, message)) = &failure {
        println!("\nThe stage `{stage}` failed: {message}");
        // Code that does not build has no test to count.
        total.failed = total.failed.max(1);
    }
    // CI reads the last line.
    println!("\n{} passed, {} failed", total.passed, total.failed);
    Ok(if failure.is_none() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn report(rows: &[(&str, Count, Duration)]) {
    println!("\n{:<8} {:>7} {:>7} {:>9}", "stage", "passed", "failed", "time");
    for (name, count, time) in rows {
        println!("{name:<8} {:>7} {:>7} {:>9}", count.passed, count.failed, minutes(*time));
    }
}

/// The stages to run, and the arguments for a stage that is run alone.
fn parse(args: &[String]) -> Result<(Vec<Stage>, Vec<String>)> {
    let (own, rest) = match args.iter().position(|arg| arg == "--") {
        Some(at) => args.split_at(at),
        None => (args, [].as_slice()),
    };
    let stages = match own {
        [] => Stage::ALL.to_vec(),
        [flag, names] if flag == "--only" => {
            let named: Vec<Stage> = names.split(',').map(Stage::named).collect::<Result<_>>()?;
            Stage::ALL.into_iter().filter(|stage| named.contains(stage)).collect()
        }
        _ => return Err(format!("`test` takes `--only STAGES`, not `{}`.", own.join(" "))),
    };
    let rest: Vec<String> = rest.iter().skip(1).cloned().collect();
    if !rest.is_empty() && stages.len() != 1 {
        return Err("arguments after `--` go to one stage: name it with `--only`.".to_owned());
    }
    Ok((stages, rest))
}
