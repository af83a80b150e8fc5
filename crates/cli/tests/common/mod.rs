//! Running the program in folders of a test's own.
#![allow(dead_code, reason = "not every test program uses all of it")]

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

pub const CUBE: &str = "\
v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1
f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6
";

/// A folder of a test's own, empty.
pub fn folder(name: &str) -> PathBuf {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&path);
    std::fs::create_dir_all(&path).expect("a folder");
    path
}

pub fn write(folder: &Path, name: &str, text: &str) -> PathBuf {
    let path = folder.join(name);
    std::fs::write(&path, text).expect("written");
    path
}

pub fn run(args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_meshwright")).args(args).output().expect("runs")
}

pub fn text(path: &Path) -> &str {
    path.to_str().expect("text")
}

/// Runs what must succeed; gives what it printed as JSON.
pub fn json_of(args: &[&str]) -> Value {
    let output = run(args);
    let error = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{args:?}: {error}");
    let mut lines = output.stdout.split(|&b| b == b'\n');
    let first = lines.next().expect("a line");
    assert_eq!(lines.collect::<Vec<_>>(), [b""], "one object, on one line");
    serde_json::from_slice(first).expect("JSON")
}

/// Runs what must fail; gives what it said.
pub fn fails(args: &[&str], code: i32) -> String {
    let output = run(args);
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(code), "{args:?}: {error}");
    assert_eq!(output.stdout, b"", "{args:?}");
    assert!(!error.contains("panicked"), "{error}");
    error
}
