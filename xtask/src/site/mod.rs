//! The site: the page, its worker, the files of `web/site` and `web/embed`, and the help. Serving, testing and packaging
//! all build it here, so what is tested is what ships.

pub mod compress;
mod help;
mod names;
mod offline;
mod optimise;
mod readers;
mod weight;

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::project::Project;
use crate::setup::{TARGET, WasmToolchain};
use crate::shell::{self, Result, read};
use names::Names;

pub const PAGE: &str = "meshwright-web";
pub const WORKER: &str = "meshwright-worker";

/// The packages that exist on the page's target only, as Cargo takes them.
pub const PACKAGES: [&str; 4] = ["-p", PAGE, "-p", WORKER];

/// What index.html says about the size of the program, which the build knows.
const PROGRAM_BYTES: &str = "{program-bytes}";

/// How a site is built.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// In little time, for tests and for `serve`: with the dependencies that the tests inside the browser have built.
    Quick,
    /// For shipping: optimised, and small.
    Optimised,
}

/// Compiles the page and its worker.
pub fn cargo_build(project: &Project, wasm: &WasmToolchain, kind: Kind) -> Command {
    let mut cargo = shell::cargo();
    cargo.args(["build", "--target", TARGET, "--bins"]).args(PACKAGES).current_dir(&project.root);
    match kind {
        Kind::Quick => wasm.choose(&mut cargo),
        Kind::Optimised => wasm.choose_for_dist(cargo.args(["--profile", "dist"])),
    };
    cargo
}

/// Builds the site into a folder of its own.
pub fn build(project: &Project, wasm: &WasmToolchain, kind: Kind, site: &Path) -> Result {
    shell::run(&mut cargo_build(project, wasm, kind))?;

    shell::remove_folder(site)?;
    shell::make_folder(site)?;
    for program in [PAGE, WORKER] {
        bind(project, kind, program, site)?;
    }
    for entry in shell::entries(&project.root.join("web/site")) {
        copy(&entry, site)?;
    }
    for entry in ["web/embed", "web/meshwright.d.ts"] {
        copy(&project.root.join(entry), site)?;
    }
    help::write(&project.root, site)?;
    name_by_content(site)?;
    offline::list_files(site)
}

/// Makes a program's WebAssembly and its JavaScript of what Cargo has built.
fn bind(project: &Project, kind: Kind, program: &str, site: &Path) -> Result {
    let profile = match kind {
        Kind::Quick => "debug",
        Kind::Optimised => "dist",
    };
    let built = project.target.join(TARGET).join(profile).join(format!("{program}.wasm"));
    let mut bind = Command::new(project.tools_bin().join("wasm-bindgen"));
    bind.args(["--target", "web", "--no-typescript", "--out-dir"]).arg(site).arg(built);
    shell::run(&mut bind)?;
    match kind {
        Kind::Quick => Ok(()),
        Kind::Optimised => {
            if program == PAGE {
                readers::refuse_module(&wasm_of(program, site))?;
            }
            optimise::module(project, program, &wasm_of(program, site))
        }
    }
}

fn wasm_of(program: &str, site: &Path) -> PathBuf {
    site.join(format!("{program}_bg.wasm"))
}

/// Puts hashes of their contents into the names of the files that the page loads: a browser never runs cached files of two
/// builds together.
fn name_by_content(site: &Path) -> Result {
    let program = wasm_of(PAGE, site);
    let bytes = std::fs::metadata(&program)
        .map_err(|error| format!("{} can't be read: {error}.", program.display()))?
        .len();
    let mut names = Names::new(site);
    // Each file after those that it mentions.
    for program in [PAGE, WORKER] {
        names.rename(program, "_bg.wasm")?;
        names.rename(program, ".js")?;
    }
    names.rename(WORKER, "_loader.js")?;
    for (name, ending) in
        [("start", ".css"), ("start", ".js"), ("files", ".js"), ("rescue", ".js"), ("offline", ".js")]
    {
        names.rename(name, ending)?;
    }
    names.update("index.html")?;
    names.finish()?;

    let index = site.join("index.html");
    let html = read(&index)?;
    if !html.contains(PROGRAM_BYTES) {
        return Err(format!("web/site/index.html has no place for the program's size, `{PROGRAM_BYTES}`."));
    }
    shell::write(&index, &html.replace(PROGRAM_BYTES, &bytes.to_string()))
}

/// Copies a file, or a folder with its files, into a folder.
fn copy(from: &Path, folder: &Path) -> Result {
    let to = folder.join(from.file_name().unwrap_or_default());
    if !from.is_dir() {
        return shell::copy(from, &to);
    }
    shell::make_folder(&to)?;
    shell::entries(from).iter().try_for_each(|entry| copy(entry, &to))
}
