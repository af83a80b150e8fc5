//! Node and the npm packages that tests/package.json pins.

use std::process::Command;

use crate::project::Project;
use crate::shell::{self, Result, step};

const MIN_NODE_MAJOR: u32 = 20;

/// Installs the packages of the lock file into the tools folder.
pub fn ensure(project: &Project) -> Result {
    check_node()?;
    let folder = project.node();
    let lock = shell::read(&project.root.join("tests/package-lock.json"))?;
    // Written last: it means that the installation is complete.
    let installed = folder.join("installed.json");
    if shell::read(&installed).is_ok_and(|text| text == lock) {
        step("npm packages: there");
        return Ok(());
    }
    step("npm packages: installing what tests/package.json pins");
    shell::make_folder(&folder)?;
    for file in ["package.json", "package-lock.json"] {
        shell::copy(&project.root.join("tests").join(file), &folder.join(file))?;
    }
    let npm = if cfg!(windows) { "npm.cmd" } else { "npm" };
    shell::run(
        Command::new(npm).args(["ci", "--no-audit", "--no-fund", "--loglevel=error"]).current_dir(&folder),
    )?;
    shell::write(&installed, &lock)
}

fn check_node() -> Result {
    let how = "install Node.js 20 or newer with npm, from https://nodejs.org or your system's packages.";
    let Some(version) = shell::capture(Command::new("node").arg("--version")) else {
        return Err(format!("Node.js is missing: {how}"));
    };
    let major = version.trim_start_matches('v').split('.').next().and_then(|major| major.parse::<u32>().ok());
    match major {
        Some(major) if major >= MIN_NODE_MAJOR => Ok(()),
        _ => Err(format!("Node.js {version} is too old: {how}")),
    }
}
