//! Running other programs.

use std::env;
use std::ffi::OsStr;
use std::fs;
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::LazyLock;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// The result of a task. An error is one message that says what went wrong and what to do.
pub type Result<T = ()> = std::result::Result<T, String>;

/// When the program started, or rather printed its first step.
static START: LazyLock<Instant> = LazyLock::new(Instant::now);

/// Prints what the task is doing, with the time since it started.
pub fn step(text: impl AsRef<str>) {
    println!("[xtask {}] {}", minutes(START.elapsed()), text.as_ref());
}

/// A time as minutes and seconds, `3:07`.
pub fn minutes(time: Duration) -> String {
    format!("{}:{:02}", time.as_secs() / 60, time.as_secs() % 60)
}

/// Cargo with the user's toolchain. The variable by which the running Cargo names itself is not passed on.
pub fn cargo() -> Command {
    let mut command = Command::new("cargo");
    command.env_remove("CARGO");
    command
}

/// Runs a program and shows its output.
pub fn run(command: &mut Command) -> Result {
    step(format!("$ {}", line(command)));
    let status = command.status().map_err(|error| cannot_start(command, &error))?;
    if status.success() {
        Ok(())
    } else {
        Err(format!("`{}` failed ({status}); its output is above.", line(command)))
    }
}

/// Runs a program, prints its standard output and passes each line to `on_line`. Gives `false` when the program fails.
pub fn run_reading(command: &mut Command, mut on_line: impl FnMut(&str)) -> Result<bool> {
    step(format!("$ {}", line(command)));
    let mut child = command.stdout(Stdio::piped()).spawn().map_err(|error| cannot_start(command, &error))?;
    if let Some(output) = child.stdout.take() {
        for text in BufReader::new(output).split(b'\n') {
            let text =
                text.map_err(|error| format!("the output of `{}` ended too early: {error}.", line(command)))?;
            let text = String::from_utf8_lossy(&text);
            println!("{text}");
            on_line(&text);
        }
    }
    let status =
        child.wait().map_err(|error| format!("`{}` could not be waited for: {error}.", line(command)))?;
    Ok(status.success())
}

/// The standard output of a program; `None` when the program is missing or fails.
pub fn capture(command: &mut Command) -> Option<String> {
    let output = command.stderr(Stdio::null()).stdin(Stdio::null()).output().ok()?;
    output.status.success().then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// Whether a program succeeds within the time limit. Its output is discarded.
pub fn succeeds_within(command: &mut Command, limit: Duration) -> bool {
    let quiet = command.stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    let Ok(mut child) = quiet.spawn() else {
        return false;
    };
    let start = Instant::now();
    loop {
        match child.try_wait() {
            Ok(Some(status)) => return status.success(),
            Ok(None) if start.elapsed() < limit => sleep(Duration::from_millis(50)),
            _ => {
                // An error means that it has just ended by itself.
                let _ = child.kill();
                let _ = child.wait();
                return false;
            }
        }
    }
}

/// The path of a program on the PATH.
pub fn find(program: &str) -> Option<PathBuf> {
    let name = format!("{program}{}", env::consts::EXE_SUFFIX);
    env::split_paths(&env::var_os("PATH")?).map(|folder| folder.join(&name)).find(|path| path.is_file())
}

/// Reads a text file.
pub fn read(path: &Path) -> Result<String> {
    fs::read_to_string(path).map_err(|error| format!("{} cannot be read: {error}.", path.display()))
}

/// Writes a text file.
pub fn write(path: &Path, text: &str) -> Result {
    fs::write(path, text).map_err(|error| format!("{} cannot be written: {error}.", path.display()))
}

/// Copies a file.
pub fn copy(from: &Path, to: &Path) -> Result {
    fs::copy(from, to)
        .map(|_| ())
        .map_err(|error| format!("{} cannot be copied to {}: {error}.", from.display(), to.display()))
}

/// Makes a folder and its parents.
pub fn make_folder(path: &Path) -> Result {
    fs::create_dir_all(path)
        .map_err(|error| format!("the folder {} cannot be made: {error}.", path.display()))
}

/// Removes a folder and its contents. A missing folder is no error.
pub fn remove_folder(path: &Path) -> Result {
    match fs::remove_dir_all(path) {
        Err(error) if error.kind() != std::io::ErrorKind::NotFound => {
            Err(format!("the folder {} cannot be removed: {error}.", path.display()))
        }
        _ => Ok(()),
    }
}

/// The files and folders in a folder, sorted. Empty when there is no such folder.
pub fn entries(folder: &Path) -> Vec<PathBuf> {
    let mut paths: Vec<PathBuf> =
        fs::read_dir(folder).into_iter().flatten().filter_map(|entry| Some(entry.ok()?.path())).collect();
    paths.sort();
    paths
}

/// The files in a folder and in those below it, with their names from there on: `inner/file`.
pub fn files_below(folder: &Path) -> Vec<(String, PathBuf)> {
    let mut files = Vec::new();
    for path in entries(folder) {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if path.is_dir() {
            files.extend(
                files_below(&path).into_iter().map(|(inner, path)| (format!("{name}/{inner}"), path)),
            );
        } else {
            files.push((name, path));
        }
    }
    files
}

/// The command as one would type it, shortened when it is long.
fn line(command: &Command) -> String {
    const MAX_CHARACTERS: usize = 240;
    let words = std::iter::once(command.get_program()).chain(command.get_args());
    let line = words.map(OsStr::to_string_lossy).collect::<Vec<_>>().join(" ");
    match line.char_indices().nth(MAX_CHARACTERS) {
        Some((end, _)) => format!("{}…", &line[..end]),
        None => line,
    }
}

fn cannot_start(command: &Command, error: &std::io::Error) -> String {
    format!(
        "`{}` cannot be started: {error}. Is it installed and on the PATH?",
        command.get_program().to_string_lossy()
    )
}
