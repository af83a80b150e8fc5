//! `cargo xtask serve`: serves the page on this machine and rebuilds it when a source changes.

use crate::project::Project;
use crate::shell::{self, Result, step};
use crate::{page, setup};

const DEFAULT_PORT: u16 = 8080;

pub fn run(project: &Project, args: &[String]) -> Result {
    let port = port(args)?;
    let wasm = setup::for_building(project)?;
    step(format!("the page will be at http://127.0.0.1:{port}/ (Ctrl+C stops)"));
    let mut trunk = page::trunk(project, &wasm, "serve", &project.site("serve"))?;
    shell::become_program(trunk.args(["--address", "127.0.0.1", "--port", &port.to_string()]))
}

fn port(args: &[String]) -> Result<u16> {
    match args {
        [] => Ok(DEFAULT_PORT),
        [flag, port] if flag == "--port" => {
            port.parse().map_err(|_| format!("`--port` takes a number from 0 to 65535, not `{port}`."))
        }
        _ => Err(format!("`serve` takes `--port N`, not `{}`.", args.join(" "))),
    }
}
