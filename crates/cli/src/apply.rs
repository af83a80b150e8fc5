//! `meshwright apply`: run commands on a file.

use crate::arguments::Apply;
use crate::documents::Contents;
use crate::{Failure, documents, report};
use editor::{Begun, Command, CommandError, Editor, Elements, Finished, Outcome};
use formats::{Format, Import};
use serde_json::{Value, json};
use std::ops::ControlFlow;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// The result of one command.
struct Step {
    outcome: Outcome,
    time: Duration,
}

/// Runs commands on a file, saves the result and prints the outcomes.
pub fn run(task: &Apply) -> Result<(), Failure> {
    let format =
        task.output.as_deref().map(|path| documents::output_format(path, task.format)).transpose()?;
    let mut read = documents::read(&task.input, &task.repairs)?;
    let notes = if task.json { String::new() } else { report::notes(&task.input, read.contents.report()) };
    let counts = report::model_counts(&read.contents.model());
    let keeps_history = format.is_some_and(Format::is_project);
    let mut times: Vec<Vec<Duration>> = vec![Vec::new(); task.commands.len()];
    let mut last = None;
    for round in 0..task.repeat {
        // The last round takes the input itself, to keep one copy less in memory.
        let is_last = round + 1 == task.repeat;
        let input = if is_last { take(&mut read.contents) } else { copy(&read.contents) };
        let (editor, steps) = run_once(input, &task.commands, keeps_history)?;
        for (times, step) in times.iter_mut().zip(&steps) {
            times.push(step.time);
        }
        last = Some((editor, steps));
    }
    let Some((editor, mut steps)) = last else { return Ok(()) };
    for (step, times) in steps.iter_mut().zip(times) {
        step.time = median(times);
    }
    if let (Some(path), Some(format)) = (&task.output, format) {
        documents::write(path, format, &editor)?;
    }
    let output = report::document_counts(editor.document());
    if task.json {
        let mut answer = report::json_start(counts, &read);
        let steps: Vec<Value> = steps
            .iter()
            .map(|step| {
                json!({"op": step.outcome.op, "seconds": step.time.as_secs_f64(), "outcome": step.outcome})
            })
            .collect();
        answer.insert("steps".into(), steps.into());
        answer.insert("output".into(), json!(output));
        return report::print(&format!("{}\n", Value::Object(answer)));
    }
    let mut text = format!("{notes}input:  {}\n", report::counts_line(counts));
    for step in &steps {
        for warning in &step.outcome.warnings {
            eprintln!("{}: {warning}", step.outcome.op);
        }
        text += &format!("{} ({:.3} s)\n", step.outcome.message, step.time.as_secs_f64());
    }
    text += &format!("output: {}\n", report::counts_line(output));
    report::print(&text)
}

/// Moves the meshes out of what was read, and copies the rest.
fn take(contents: &mut Contents) -> Contents {
    match contents {
        Contents::Import(Import { model, report }) => {
            Contents::Import(Import { model: std::mem::take(model), report: report.clone() })
        }
        Contents::Project(_) => copy(contents),
    }
}

/// What was read, with meshes of its own, so that the first edit needn't copy them. Projects share them with their history.
fn copy(contents: &Contents) -> Contents {
    match contents {
        Contents::Import(import) => {
            let mut copy = import.clone();
            for object in &mut copy.model.objects {
                Arc::make_mut(&mut object.mesh);
            }
            Contents::Import(copy)
        }
        Contents::Project(read) => Contents::Project(read.clone()),
    }
}

/// Runs the commands on a fresh document.
fn run_once(
    input: Contents,
    commands: &[Command],
    keeps_history: bool,
) -> Result<(Editor, Vec<Step>), Failure> {
    let refused = |error: CommandError| Failure::Refused(error.to_string());
    let mut editor = Editor::new();
    if !keeps_history {
        editor.set_history_limit(0);
    }
    input.open_in(&mut editor).map_err(refused)?;
    let mut steps = Vec::with_capacity(commands.len());
    for command in commands {
        steps.push(run_step(&mut editor, command).map_err(refused)?);
    }
    Ok((editor, steps))
}

/// Runs one command; one for whole meshes runs on every object.
fn run_step(editor: &mut Editor, command: &Command) -> Result<Step, CommandError> {
    if !command.is_for_whole_meshes() {
        let start = Instant::now();
        let outcome = editor.run(command.clone())?;
        return Ok(Step { outcome, time: start.elapsed() });
    }
    let mut total: Option<Step> = None;
    for object in 0..editor.document().objects().len().max(1) {
        let command = match editor.document().objects().len() {
            0 | 1 => command.clone(),
            _ => command.clone().on(object),
        };
        let step = run_whole(editor, command)?;
        total = Some(match total {
            None => step,
            Some(sum) => Step { outcome: add(sum.outcome, step.outcome), time: sum.time + step.time },
        });
    }
    total.ok_or_else(|| CommandError::refused(command.name(), "the file has no object"))
}

/// Runs a command on a whole mesh. The time is that of the algorithm, without validating its result.
fn run_whole(editor: &mut Editor, command: Command) -> Result<Step, CommandError> {
    let name = command.name();
    let start = Instant::now();
    match editor.begin_from(command, 0)? {
        Begun::Done(outcome) => Ok(Step { outcome, time: start.elapsed() }),
        Begun::Selecting => Err(CommandError::refused(name, "this command selects elements of one object")),
        Begun::Job(request) => {
            let start = Instant::now();
            let result = request.run(&mut |_| ControlFlow::Continue(()));
            let time = start.elapsed();
            let id = request.id();
            drop(request);
            match editor.finish(id, result)? {
                Finished::Done(outcome) => Ok(Step { outcome, time }),
                Finished::Exported(_) | Finished::Shared(_) | Finished::Decoded(_) => {
                    Err(CommandError::refused(name, "this command saves files; use -o OUT instead"))
                }
            }
        }
    }
}

/// The outcome of one command on two objects: the sums of their counts. Ids are left out, because each
/// object numbers its own.
fn add(a: Outcome, b: Outcome) -> Outcome {
    let sum = |a: Elements, b: Elements| Elements {
        vertices: a.vertices + b.vertices,
        edges: a.edges + b.edges,
        faces: a.faces + b.faces,
        ids: None,
    };
    let outcome = Outcome::new(a.op, sum(a.created, b.created), sum(a.removed, b.removed));
    Outcome { warnings: [a.warnings, b.warnings].concat(), ..outcome }
}

/// The median of some times: the mean of the middle two when their number is even.
fn median(mut times: Vec<Duration>) -> Duration {
    times.sort_unstable();
    let middle = times.len() / 2;
    match (times.get(middle), times.get(middle.wrapping_sub(1))) {
        (Some(&high), Some(&low)) if times.len().is_multiple_of(2) => (low + high) / 2,
        (Some(&high), _) => high,
        (None, _) => Duration::ZERO,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_is_the_middle() {
        let seconds = |list: &[u64]| median(list.iter().map(|&s| Duration::from_secs(s)).collect());
        assert_eq!(seconds(&[9, 1, 5]), Duration::from_secs(5));
        assert_eq!(seconds(&[9, 1, 5, 7]), Duration::from_secs(6));
        assert_eq!(seconds(&[4]), Duration::from_secs(4));
        assert_eq!(seconds(&[]), Duration::ZERO);
    }
}
