//! The Rust programs that building and testing the page take, at fixed versions.

use std::env::consts::{ARCH, EXE_SUFFIX, OS};
use std::path::Path;
use std::process::Command;
use std::time::Duration;

use crate::project::Project;
use crate::shell::{self, Result, find, step};

/// wasm-bindgen, which generates the JavaScript around a wasm module. Its version must be that of the crate in Cargo.lock.
pub fn wasm_bindgen(project: &Project) -> Result {
    let version = project.locked_version("wasm-bindgen")?;
    let platform = match (OS, ARCH) {
        ("linux", "x86_64") => Some("x86_64-unknown-linux-musl"),
        ("linux", "aarch64") => Some("aarch64-unknown-linux-gnu"),
        ("macos", "x86_64") => Some("x86_64-apple-darwin"),
        ("macos", "aarch64") => Some("aarch64-apple-darwin"),
        ("windows", "x86_64") => Some("x86_64-pc-windows-msvc"),
        _ => None,
    };
    let wasm_bindgen = Program {
        package: "wasm-bindgen-cli",
        version: &version,
        binaries: &["wasm-bindgen", "wasm-bindgen-test-runner"],
        archive: platform.map(|platform| {
            format!(
                "https://github.com/wasm-bindgen/wasm-bindgen/releases/download/{version}/wasm-bindgen-{version}-{platform}.tar.gz"
            )
        }),
        minutes: 4,
    };
    wasm_bindgen.ensure(project)
}

/// The formatter and linter of the toolchain in use.
pub fn rust_components() -> Result {
    for (component, program) in [("rustfmt", "rustfmt"), ("clippy", "clippy-driver")] {
        if shell::capture(Command::new(program).arg("--version")).is_some() {
            continue;
        }
        step(format!("{component}: $ rustup component add {component}"));
        let mut add = Command::new("rustup");
        if !shell::succeeds_within(add.args(["component", "add", component]), Duration::from_secs(300)) {
            return Err(format!("{component} is missing: run `rustup component add {component}`."));
        }
    }
    Ok(())
}

struct Program<'a> {
    package: &'a str,
    version: &'a str,
    /// The first one prints the version.
    binaries: &'a [&'a str],
    /// The URL of an archive with ready-made programs for this platform.
    archive: Option<String>,
    /// How long building it takes on two cores.
    minutes: u32,
}

impl Program<'_> {
    fn ensure(&self, project: &Project) -> Result {
        if self.ready(project) {
            step(format!("{}: {} is there", self.package, self.version));
            return Ok(());
        }
        if self.download(project) && self.ready(project) {
            step(format!("{}: {} downloaded", self.package, self.version));
            return Ok(());
        }
        self.build(project)?;
        if self.ready(project) {
            Ok(())
        } else {
            Err(format!(
                "{} was built but does not run: remove {} and try again.",
                self.package,
                project.tools_bin().display()
            ))
        }
    }

    fn ready(&self, project: &Project) -> bool {
        let path = |name: &str| project.tools_bin().join(format!("{name}{EXE_SUFFIX}"));
        let Some(first) = self.binaries.first() else {
            return false;
        };
        let version = shell::capture(Command::new(path(first)).arg("--version"));
        version.is_some_and(|text| text.split_whitespace().nth(1) == Some(self.version))
            && self.binaries.iter().all(|name| path(name).is_file())
    }

    /// Fetches the ready-made programs. Failing to is no error: they can be built.
    fn download(&self, project: &Project) -> bool {
        let Some(url) = &self.archive else {
            return false;
        };
        step(format!("{}: looking for a ready-made {}", self.package, self.version));
        let folder = project.tools.join("download");
        let archive = folder.join("archive");
        if shell::remove_folder(&folder).and_then(|()| shell::make_folder(&folder)).is_err() {
            return false;
        }
        let mut curl = Command::new("curl");
        curl.args(["-fsSL", "--connect-timeout", "5", "--max-time", "120", "-o"]).arg(&archive).arg(url);
        let mut tar = Command::new("tar");
        tar.arg("-xf").arg(&archive).arg("-C").arg(&folder);
        let fetched = shell::succeeds_within(&mut curl, Duration::from_secs(130))
            && shell::succeeds_within(&mut tar, Duration::from_secs(60))
            && self.take(&folder, &project.tools_bin());
        let _ = shell::remove_folder(&folder);
        fetched
    }

    /// Copies the programs out of an unpacked archive, where they lie at the top or one folder below.
    fn take(&self, from: &Path, to: &Path) -> bool {
        let mut folders = vec![from.to_path_buf()];
        folders.extend(shell::entries(from).into_iter().filter(|path| path.is_dir()));
        self.binaries.iter().all(|name| {
            let file = format!("{name}{EXE_SUFFIX}");
            let found = folders.iter().map(|folder| folder.join(&file)).find(|path| path.is_file());
            found.is_some_and(|path| shell::copy(&path, &to.join(&file)).is_ok())
        })
    }

    fn build(&self, project: &Project) -> Result {
        step(format!("{}: building {} (about {} minutes)", self.package, self.version, self.minutes));
        if find("cc").is_none() && OS == "linux" {
            return Err(
                "a C linker (`cc`) is missing: install your system's `build-essential` or `gcc`.".to_owned()
            );
        }
        let build = project.tools.join("build");
        let mut install = shell::cargo();
        install.args(["install", self.package, "--version", self.version, "--force", "--quiet"]);
        install.arg("--root").arg(&project.tools).arg("--target-dir").arg(&build);
        // Not `--locked`: the lock file of wasm-bindgen names a crate version that not every registry has.
        // The published profile spends most of the time on link-time optimisation.
        install.env("CARGO_PROFILE_RELEASE_LTO", "off").env("CARGO_PROFILE_RELEASE_CODEGEN_UNITS", "16");
        shell::run(&mut install)?;
        shell::remove_folder(&build)
    }
}
