//! Trunk, which builds the page.

use std::path::Path;
use std::process::Command;

use crate::project::Project;
use crate::setup::WasmToolchain;
use crate::shell::{self, Result};
use crate::worker_name;

/// Trunk with a subcommand, using the pinned tools and nothing from the network.
pub fn trunk(project: &Project, wasm: &WasmToolchain, subcommand: &str, site: &Path) -> Result<Command> {
    fetch_dependencies(project, wasm)?;
    shell::make_folder(site)?;
    let mut trunk = Command::new(project.tools_bin().join("trunk"));
    trunk.args([subcommand, "--offline", "--dist"]).arg(site).current_dir(&project.root);
    trunk.env("PATH", project.path()?).env("CARGO_TARGET_DIR", &project.target).env_remove("CARGO");
    // Trunk reads the variable as a flag of its own and stops at the usual value, 1.
    trunk.env_remove("NO_COLOR");
    // A failed build is explained by Cargo; Trunk's own call stack only buries that.
    trunk.env("RUST_BACKTRACE", "0");
    wasm.choose(&mut trunk);
    Ok(trunk)
}

/// Builds the page as it is developed: quickly, and not for size.
pub fn build(project: &Project, wasm: &WasmToolchain, site: &Path) -> Result {
    shell::run(&mut trunk(project, wasm, "build", site)?)?;
    worker_name::name_by_content(site)
}

/// `--offline` holds for Cargo too, so what the lock file names must be there before.
fn fetch_dependencies(project: &Project, wasm: &WasmToolchain) -> Result {
    let mut fetch = shell::cargo();
    fetch.args(["fetch", "--quiet"]).current_dir(&project.root);
    shell::run(wasm.choose(&mut fetch))
}
