//! Trunk, which builds the page for serving and packaging.

use std::path::Path;
use std::process::Command;

use crate::project::Project;
use crate::setup::WasmToolchain;
use crate::shell::{self, Result};

/// A Trunk subcommand that uses the pinned tools and not the network.
pub fn trunk(project: &Project, wasm: &WasmToolchain, subcommand: &str, site: &Path) -> Result<Command> {
    fetch_dependencies(project, wasm)?;
    shell::make_folder(site)?;
    let mut trunk = Command::new(project.tools_bin().join("trunk"));
    trunk.args([subcommand, "--offline", "--dist"]).arg(site).current_dir(&project.root);
    trunk.env("PATH", project.path()?).env("CARGO_TARGET_DIR", &project.target).env_remove("CARGO");
    // Trunk takes the variable for a flag of its own and refuses the usual value, 1.
    trunk.env_remove("NO_COLOR");
    // Cargo explains a failed build; Trunk's own backtrace would only hide that.
    trunk.env("RUST_BACKTRACE", "0");
    wasm.choose(&mut trunk);
    Ok(trunk)
}

/// Fetches the locked dependencies: `--offline` applies to Cargo too.
fn fetch_dependencies(project: &Project, wasm: &WasmToolchain) -> Result {
    let mut fetch = shell::cargo();
    fetch.args(["fetch", "--quiet"]).current_dir(&project.root);
    shell::run(wasm.choose(&mut fetch))
}
