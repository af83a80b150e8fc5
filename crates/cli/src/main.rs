//! `meshwright`: the editor's commands from a terminal.
//!
//! The exit status is 0 on success, 1 when a command is refused, and 2 for wrong usage or a file that
//! can't be read or written.

#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable))]
#![cfg_attr(not(test), deny(clippy::indexing_slicing))]

mod apply;
mod arguments;
mod convert;
mod documents;
mod info;
mod report;

use arguments::Task;
use editor::script;
use std::process::ExitCode;

/// Why the program fails.
enum Failure {
    /// A command was refused.
    Refused(String),
    /// The arguments are wrong.
    Usage(String),
    /// A file can't be read or written.
    File(String),
}

fn main() -> ExitCode {
    let result = arguments::parse(std::env::args_os()).and_then(|task| match task {
        Task::Help => report::print(&arguments::help()),
        Task::OperationHelp(id) => report::print(&script::operation_help(id)),
        Task::Version => report::print(concat!("meshwright ", env!("CARGO_PKG_VERSION"), "\n")),
        Task::Info(task) => info::run(&task),
        Task::Convert(task) => convert::run(&task),
        Task::Apply(task) => apply::run(&task),
    });
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(Failure::Refused(text)) => {
            eprintln!("{text}");
            ExitCode::from(1)
        }
        Err(Failure::Usage(text)) => {
            eprintln!("{text}\nSee `meshwright --help`.");
            ExitCode::from(2)
        }
        Err(Failure::File(text)) => {
            eprintln!("{text}");
            ExitCode::from(2)
        }
    }
}
