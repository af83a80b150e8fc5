//! The program's arguments.

use lexopt::{Arg, Parser};
use std::ffi::OsString;
use std::path::PathBuf;

pub const HELP: &str = "\
The Meshwright mesh editor in a window of its own.

usage: meshwright-desktop [FILE...]

Opens the files together as one document; an OBJ finds its materials and images beside it. Without files, it goes on with the
document of the last time.

  -h, --help     show this help
  -V, --version  show the version

The program `meshwright` runs the editor's commands without a window.
";

/// What the program is asked to do.
#[derive(Debug, PartialEq, Eq)]
pub enum Task {
    Help,
    Version,
    /// Open the editor with these files.
    Edit(Vec<PathBuf>),
}

/// Reads the arguments, the first of which is the program's name.
pub fn parse(arguments: impl IntoIterator<Item = OsString>) -> Result<Task, lexopt::Error> {
    let mut parser = Parser::from_iter(arguments);
    let mut files = Vec::new();
    while let Some(argument) = parser.next()? {
        match argument {
            Arg::Short('h') | Arg::Long("help") => return Ok(Task::Help),
            Arg::Short('V') | Arg::Long("version") => return Ok(Task::Version),
            Arg::Value(file) => files.push(file.into()),
            other => return Err(other.unexpected()),
        }
    }
    Ok(Task::Edit(files))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parsed(arguments: &[&str]) -> Result<Task, String> {
        let all = std::iter::once("meshwright-desktop").chain(arguments.iter().copied());
        parse(all.map(OsString::from)).map_err(|error| error.to_string())
    }

    #[test]
    fn files_and_options_are_told_apart() {
        assert_eq!(parsed(&[]), Ok(Task::Edit(Vec::new())));
        assert_eq!(parsed(&["a.obj", "--", "-b.ply"]), Ok(Task::Edit(vec!["a.obj".into(), "-b.ply".into()])));
        assert_eq!(parsed(&["a.obj", "--help"]), Ok(Task::Help));
        assert_eq!(parsed(&["-V"]), Ok(Task::Version));
        assert_eq!(parsed(&["--hlep"]), Err("invalid option '--hlep'".to_owned()));
    }
}
