//! The wasm standard library where rustup's server cannot be reached: Debian packages a compiler with its sources, from
//! which the library is built once, into that compiler's own folder.

use std::path::{Path, PathBuf};
use std::process::Command;

use super::apt;
use super::wasm::TARGET;
use crate::project::Project;
use crate::shell::{self, Result, step};

/// The name of the rustup toolchain that is Debian's compiler.
pub const TOOLCHAIN: &str = "debian-web";

const PACKAGES: [&str; 6] =
    ["rustc-web", "cargo-web", "rust-web-src", "rust-web-llvm", "rust-web-clippy", "lld-22"];

/// The file that names the compiler that built the library: no other can use it.
const STAMP: &str = "built-by.txt";

/// Whether the toolchain is installed with a library that its own compiler built.
pub fn ready() -> bool {
    let Some((version, folder)) = compiler() else {
        return false;
    };
    shell::read(&folder.join(STAMP)).is_ok_and(|built_by| built_by == version)
}

/// Installs the packages, names the toolchain and builds the library.
pub fn install(project: &Project) -> Result {
    apt::install(&PACKAGES)?;
    shell::run(Command::new("rustup").args(["toolchain", "link", TOOLCHAIN, "/usr"]))?;
    let (version, folder) = compiler().ok_or("Debian's Rust compiler (package rustc-web) does not run.")?;

    step(format!("building the standard library for {TARGET} (about a minute)"));
    let source = project.tools.join("wasm-std");
    let target = source.join("target");
    shell::make_folder(&source.join("src"))?;
    shell::write(&source.join("src/lib.rs"), "")?;
    shell::write(
        &source.join("Cargo.toml"),
        "[package]\nname = \"wasm-std\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[workspace]\n",
    )?;
    let mut build = shell::cargo();
    build
        .args(["build", "--release", "--target", TARGET, "-Zbuild-std=std,panic_abort,test"])
        .current_dir(&source);
    // RUSTC_BOOTSTRAP lets a stable Cargo take `-Z` flags.
    build.env("RUSTUP_TOOLCHAIN", TOOLCHAIN).env("RUSTC_BOOTSTRAP", "1").env("CARGO_TARGET_DIR", &target);
    shell::run(&mut build)?;

    let built = shell::entries(&target.join(TARGET).join("release/deps"));
    let libraries: Vec<PathBuf> = built.into_iter().filter(|path| is_library(path)).collect();
    let stamp = source.join(STAMP);
    shell::write(&stamp, &version)?;
    replace(&folder, &libraries, &stamp)?;
    shell::remove_folder(&target)
}

/// The compiler's full version, and the folder where it looks for the library.
fn compiler() -> Option<(String, PathBuf)> {
    let rustc =
        |args: &[&str]| shell::capture(Command::new("rustc").args(args).env("RUSTUP_TOOLCHAIN", TOOLCHAIN));
    let sysroot = rustc(&["--print", "sysroot"])?;
    Some((rustc(&["-vV"])?, Path::new(&sysroot).join("lib/rustlib").join(TARGET).join("lib")))
}

fn is_library(path: &Path) -> bool {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    name.ends_with(".rlib") && !name.starts_with("libwasm_std-")
}

/// Copies the libraries into the compiler's folder, as root, and the stamp last.
fn replace(folder: &Path, libraries: &[PathBuf], stamp: &Path) -> Result {
    let prefix =
        apt::prefix().ok_or("installing into Debian's compiler takes root: run set-up as root once.")?;
    let as_root = |program: &str| {
        let mut words = prefix.iter().copied().chain([program]);
        let mut command = Command::new(words.next().unwrap_or(program));
        command.args(words);
        command
    };
    shell::run(as_root("rm").arg("-rf").arg(folder))?;
    shell::run(as_root("mkdir").arg("-p").arg(folder))?;
    shell::run(as_root("cp").args(libraries).arg(folder))?;
    shell::run(as_root("cp").arg(stamp).arg(folder))
}
