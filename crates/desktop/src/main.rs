//! `meshwright-desktop`: the editor in a window of its own.

#![cfg_attr(not(test), deny(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::unreachable))]
#![cfg_attr(not(test), deny(clippy::indexing_slicing))]
// No console window behind the editor's own.
#![cfg_attr(all(windows, not(debug_assertions)), windows_subsystem = "windows")]

mod arguments;
mod closing;
mod platform;
mod window;

use arguments::Task;
use std::process::ExitCode;

/// The exit status for wrong usage.
const USAGE: u8 = 2;

fn main() -> ExitCode {
    let files = match arguments::parse(std::env::args_os()) {
        Ok(Task::Help) => {
            print!("{}", arguments::HELP);
            return ExitCode::SUCCESS;
        }
        Ok(Task::Version) => {
            println!("meshwright-desktop {}", env!("CARGO_PKG_VERSION"));
            return ExitCode::SUCCESS;
        }
        Ok(Task::Edit(files)) => files,
        Err(problem) => {
            eprintln!("meshwright-desktop: {problem}. `meshwright-desktop --help` shows the usage.");
            return ExitCode::from(USAGE);
        }
    };
    match window::run(files) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!(
                "meshwright-desktop: the window could not be opened: {error}. It needs a desktop and a graphics driver with \
                 Vulkan, Metal, Direct3D 12 or OpenGL ES 3. The program `meshwright` runs the same commands without a window."
            );
            ExitCode::FAILURE
        }
    }
}
