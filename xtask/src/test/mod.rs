//! `cargo xtask test`: everything that must hold, in stages, the quick ones first.

mod count;
mod stages;

use std::process::ExitCode;
use std::time::{Duration, Instant};

use count::Count;
use stages::Stage;

use crate::project::Project;
use crate::shell::{Result, step};

pub fn run(project: &Project, args: &[String]) -> Result<ExitCode> {
    let (stages, rest) = parse(args)?;
    let start = Instant::now();
    let tools = stages::Tools::ensure(project, &stages)?;
    step(format!("set-up took {}", seconds(start.elapsed())));

    let mut rows = Vec::new();
    let mut total = Count::default();
    let mut failure = None;
    for stage in &stages {
        println!();
        step(format!("stage {}", stage.name()));
        let start = Instant::now();
        let (count, result) = stage.run(project, &tools, &rest);
        rows.push((stage.name(), count.clone(), start.elapsed()));
        total += count;
        if let Err(message) = result {
            failure = Some((stage.name(), message));
            break;
        }
    }
    report(&rows, stages.len());
    if !total.left_out.is_empty() {
        println!("\n{} tests were left out:", total.left_out.len());
        total.left_out.iter().for_each(|name| println!("    {name}"));
    }
    if let Some((stage, message)) = &failure {
        println!("\nThe stage `{stage}` failed: {message}");
        // What does not build has no test to count.
        total.failed = total.failed.max(1);
    }
    // CI reads the last line.
    println!("\n{} passed, {} failed", total.passed, total.failed);
    Ok(if failure.is_none() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn report(rows: &[(&str, Count, Duration)], stages: usize) {
    println!("\n{:<8} {:>7} {:>7} {:>9}", "stage", "passed", "failed", "time");
    for (name, count, time) in rows {
        println!("{name:<8} {:>7} {:>7} {:>9}", count.passed, count.failed, seconds(*time));
    }
    if rows.len() < stages {
        println!("{} later stages were not run", stages - rows.len());
    }
}

fn seconds(time: Duration) -> String {
    format!("{:.1} s", time.as_secs_f64())
}

/// The stages to run and the arguments for the one that is run alone.
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
        _ => return Err(format!("`test` takes `--only STAGES` only, not `{}`.", own.join(" "))),
    };
    let rest: Vec<String> = rest.iter().skip(1).cloned().collect();
    if !rest.is_empty() && stages.len() != 1 {
        return Err("arguments after `--` go to one stage: name it with `--only`.".to_owned());
    }
    Ok((stages, rest))
}
