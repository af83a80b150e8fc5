//! The arguments of the command line.

use crate::Failure;
use editor::{Command, OpId, script};
use formats::{Format, NonManifold, Repairs};
use halfedge::words::sentence;
use lexopt::prelude::*;
use std::ffi::OsString;
use std::path::PathBuf;
use std::str::FromStr;

/// The text that `--help` prints before the list of operations, with `{codes}` in place of the codes of
/// the formats.
const HELP: &str = "\
Meshwright: polygon meshes from the command line

Usage:
  meshwright info FILE [--json] [REPAIRS]
  meshwright convert IN OUT [--format CODE] [REPAIRS]
  meshwright apply IN --do COMMAND [--do COMMAND ...] [-o OUT [--format CODE]] [--json] [--repeat N]
                   [REPAIRS]
  meshwright help [OPERATION]

A COMMAND is a JSON object such as '{\"op\": \"subdivide-catmull-clark\", \"levels\": 2}'.
Operations on whole meshes run on every object of the file; others run on the first object, unless
the command names another one with \"object\": 1.

Options:
  --do COMMAND      run this command; several of them run in the order given
  -o, --output OUT  save the result here; the extension chooses the format; .meshwright is the
                    whole document with its history, .json the half-edge mesh itself
  --format CODE     save in this format, whatever the extension:
                    {codes}
  --json            print one JSON object instead of text
  --repeat N        run the commands N times on the same input and print their median times
  -h, --help        print this
  -V, --version     print the version

Repairs, for files whose faces don't form a mesh:
  --non-manifold separate|drop
                    at edges with more than two faces, separate the faces or keep only the first
                    two (default: separate)
  --merge-by-distance D
                    merge vertices that are at most this far apart, in mesh units
  --no-orient       don't turn faces to match their neighbours; cut the mesh where they disagree

Exit status: 0 on success, 1 when a command is refused, 2 for wrong usage or a file that can't be
read or written.
";

/// The text that `--help` prints.
pub fn help() -> String {
    let help = HELP.replace("{codes}", &codes());
    format!(
        "{help}\nOperations; `meshwright help OPERATION` lists the fields of one:\n{}",
        script::operations_help()
    )
}

/// The task of the program.
pub enum Task {
    /// Print the help text.
    Help,
    /// Print the fields of an operation.
    OperationHelp(OpId),
    /// Print the version.
    Version,
    /// Print the contents of a file.
    Info(Info),
    /// Save a file in another format.
    Convert(Convert),
    /// Run commands on a file.
    Apply(Apply),
}

/// `meshwright info`.
pub struct Info {
    /// The file.
    pub file: PathBuf,
    /// Whether to print JSON.
    pub json: bool,
    /// How faces that don't form a mesh are repaired.
    pub repairs: Repairs,
}

/// `meshwright convert`.
pub struct Convert {
    /// The file to read.
    pub input: PathBuf,
    /// The file to write.
    pub output: PathBuf,
    /// The format to write; that of the file's extension if none is given.
    pub format: Option<Format>,
    /// How faces that don't form a mesh are repaired.
    pub repairs: Repairs,
}

/// `meshwright apply`.
pub struct Apply {
    /// The file to read.
    pub input: PathBuf,
    /// The commands, in order.
    pub commands: Vec<Command>,
    /// The file to write, if any.
    pub output: Option<PathBuf>,
    /// The format to write; that of the file's extension if none is given.
    pub format: Option<Format>,
    /// Whether to print JSON.
    pub json: bool,
    /// How many times to run the commands on the same input.
    pub repeat: usize,
    /// How faces that don't form a mesh are repaired.
    pub repairs: Repairs,
}

/// The arguments read so far; which options are allowed depends on the task.
#[derive(Default)]
struct Given {
    words: Vec<OsString>,
    json: bool,
    commands: Vec<Command>,
    output: Option<PathBuf>,
    format: Option<Format>,
    repeat: Option<usize>,
    repairs: Repairs,
}

/// Parses the arguments, of which the first is the program's name.
pub fn parse(args: impl IntoIterator<Item = OsString>) -> Result<Task, Failure> {
    let mut parser = lexopt::Parser::from_iter(args);
    let mut given = Given::default();
    while let Some(argument) = parser.next().map_err(usage)? {
        match argument {
            Short('h') | Long("help") => return Ok(Task::Help),
            Short('V') | Long("version") => return Ok(Task::Version),
            Long("json") => given.json = true,
            Long("do") => {
                let text = parser.value().map_err(usage)?.string().map_err(usage)?;
                given.commands.push(command(&text)?);
            }
            Short('o') | Long("output") => given.output = Some(parser.value().map_err(usage)?.into()),
            Long("format") => {
                let code = parser.value().map_err(usage)?.string().map_err(usage)?;
                given.format = Some(format(&code)?);
            }
            Long("repeat") => {
                let is_valid = |times: &usize| *times > 0;
                given.repeat =
                    Some(number(&mut parser, "--repeat", "a whole number of 1 or more", is_valid)?);
            }
            Long("non-manifold") => {
                let choice = parser.value().map_err(usage)?;
                given.repairs.non_manifold = match choice.to_str() {
                    Some("separate") => NonManifold::Separate,
                    Some("drop") => NonManifold::Drop,
                    _ => {
                        let text =
                            format!("--non-manifold: {} is not separate or drop", choice.to_string_lossy());
                        return Err(Failure::Usage(text));
                    }
                };
            }
            Long("merge-by-distance") => {
                let is_valid = |distance: &f32| distance.is_finite() && *distance >= 0.0;
                given.repairs.merge_by_distance =
                    Some(number(&mut parser, "--merge-by-distance", "a number of 0 or more", is_valid)?);
            }
            Long("no-orient") => given.repairs.orient = false,
            Value(word) => given.words.push(word),
            other => return Err(usage(other.unexpected())),
        }
    }
    given.into_task()
}

impl Given {
    fn into_task(self) -> Result<Task, Failure> {
        // Options of `apply` only.
        let others = [
            (!self.commands.is_empty(), "--do"),
            (self.output.is_some(), "-o"),
            (self.repeat.is_some(), "--repeat"),
        ];
        let mut words = self.words.into_iter();
        let Some(name) = words.next() else {
            return Err(Failure::Usage("The task is missing: give info, convert, apply or help.".into()));
        };
        let mut file = |what: &str| {
            words.next().map(PathBuf::from).ok_or_else(|| Failure::Usage(format!("{what} is missing.")))
        };
        let refuse = |given: bool, option: &str, with: &str| match given {
            true => Err(refused(option, with)),
            false => Ok(()),
        };
        let name = name.to_string_lossy();
        let task = match &*name {
            "info" if self.format.is_some() => return Err(refused("--format", "info")),
            "info" => Task::Info(Info { file: file("FILE")?, json: self.json, repairs: self.repairs }),
            "convert" => {
                refuse(self.json, "--json", "convert")?;
                let (input, output) = (file("IN")?, file("OUT")?);
                Task::Convert(Convert { input, output, format: self.format, repairs: self.repairs })
            }
            "apply" => {
                let input = file("IN")?;
                if self.commands.is_empty() {
                    return Err(Failure::Usage(
                        "The commands are missing: give at least one with --do COMMAND.".into(),
                    ));
                }
                refuse(self.format.is_some() && self.output.is_none(), "--format without -o", "apply")?;
                Task::Apply(Apply {
                    input,
                    commands: self.commands,
                    output: self.output,
                    format: self.format,
                    json: self.json,
                    repeat: self.repeat.unwrap_or(1),
                    repairs: self.repairs,
                })
            }
            "help" => {
                refuse(self.json, "--json", "help")?;
                match words.next() {
                    None => Task::Help,
                    Some(operation) => Task::OperationHelp(operation_named(&operation.to_string_lossy())?),
                }
            }
            other => return Err(Failure::Usage(format!("`{other}` is not info, convert, apply or help."))),
        };
        if let Some(extra) = words.next() {
            return Err(Failure::Usage(format!("Unexpected argument `{}`.", extra.to_string_lossy())));
        }
        if !matches!(task, Task::Apply(_)) {
            for (given, option) in others {
                refuse(given, option, &name)?;
            }
        }
        Ok(task)
    }
}

fn refused(option: &str, with: &str) -> Failure {
    Failure::Usage(format!("{option} can't be used with `{with}`."))
}

/// The codes of the formats that can be written.
fn codes() -> String {
    let codes: Vec<&str> =
        Format::all().filter(|format| format.can_save()).map(|format| format.code()).collect();
    codes.join(", ")
}

/// The format of a code.
fn format(code: &str) -> Result<Format, Failure> {
    Format::from_code(code).filter(|format| format.can_save()).ok_or_else(|| {
        Failure::Usage(format!(
            "--format: {code} is not a format that can be written; the codes are {}",
            codes()
        ))
    })
}

/// The value of an option that takes a number; `wanted` says which.
fn number<T: FromStr>(
    parser: &mut lexopt::Parser,
    option: &str,
    wanted: &str,
    is_valid: impl Fn(&T) -> bool,
) -> Result<T, Failure> {
    let text = parser.value().map_err(usage)?;
    let number = text.to_str().and_then(|text| text.parse().ok()).filter(is_valid);
    number.ok_or_else(|| Failure::Usage(format!("{option}: {} is not {wanted}", text.to_string_lossy())))
}

/// Parses a command. Text that is not JSON is wrong usage; JSON that is not a command is refused.
fn command(text: &str) -> Result<Command, Failure> {
    let value: serde_json::Value = serde_json::from_str(text).map_err(|error| {
        Failure::Usage(format!("--do: this is not JSON: {text}\n{}", sentence(&formats::json_fault(&error))))
    })?;
    let instead = match value.get("op").and_then(serde_json::Value::as_str).and_then(editor::Task::named) {
        Some(editor::Task::Open) => {
            Some("open is not an operation; name the input file as the first argument of apply")
        }
        Some(editor::Task::Export) => Some("export is not an operation; name the output file with -o"),
        _ => None,
    };
    if let Some(instead) = instead {
        return Err(Failure::Refused(format!("--do: {instead} instead.")));
    }
    Command::from_value(value).map_err(|error| Failure::Refused(error.to_string()))
}

fn operation_named(name: &str) -> Result<OpId, Failure> {
    OpId::named(name)
        .ok_or_else(|| Failure::Usage(format!("`{name}` is not an operation; `meshwright help` lists them.")))
}

fn usage(error: lexopt::Error) -> Failure {
    Failure::Usage(error.to_string())
}
