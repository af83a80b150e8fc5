//! The folders of the project, of its build output and of its tools.

use std::env;
use std::path::{Path, PathBuf};

use crate::shell::{self, Result};

/// The folders that tasks use.
pub struct Project {
    /// The folder of the workspace's Cargo.toml.
    pub root: PathBuf,
    /// Cargo's target folder.
    pub target: PathBuf,
    /// The pinned tools: `$MESHWRIGHT_TOOLS`, or `.tools` in the project.
    pub tools: PathBuf,
}

impl Project {
    pub fn find() -> Result<Self> {
        // From the running Cargo rather than the compiler: checkouts that share a target folder share this program.
        let xtask = env::var_os("CARGO_MANIFEST_DIR").unwrap_or_else(|| env!("CARGO_MANIFEST_DIR").into());
        let root = Path::new(&xtask)
            .parent()
            .ok_or("xtask lies in no project folder; run it from a checkout of Meshwright.")?
            .to_path_buf();
        let folder = |variable: &str, default: &str| match env::var_os(variable) {
            Some(path) if !path.is_empty() => root.join(path),
            _ => root.join(default),
        };
        Ok(Self {
            target: folder("CARGO_TARGET_DIR", "target"),
            tools: folder("MESHWRIGHT_TOOLS", ".tools"),
            root,
        })
    }

    /// The folder of the pinned programs.
    pub fn tools_bin(&self) -> PathBuf {
        self.tools.join("bin")
    }

    /// The folder of the npm packages that tests/package.json pins.
    pub fn node(&self) -> PathBuf {
        self.tools.join("node")
    }

    /// The folder of a build of the page. Each use has its own, so that none serves half-written files of another.
    pub fn site(&self, name: &str) -> PathBuf {
        self.target.join("site").join(name)
    }

    /// The `PATH` with the project's tools in front.
    pub fn path(&self) -> Result<std::ffi::OsString> {
        let own = [self.tools_bin(), self.node().join("node_modules").join(".bin")];
        let inherited = env::var_os("PATH").unwrap_or_default();
        env::join_paths(own.into_iter().chain(env::split_paths(&inherited)))
            .map_err(|error| format!("a folder on the PATH has a name that the PATH cannot hold: {error}."))
    }

    /// The version of a package in Cargo.lock.
    pub fn locked_version(&self, package: &str) -> Result<String> {
        let lock = shell::read(&self.root.join("Cargo.lock"))?;
        let name = format!("name = \"{package}\"");
        lock.lines()
            .skip_while(|line| *line != name)
            .find_map(|line| line.strip_prefix("version = \"")?.strip_suffix('"'))
            .map(str::to_owned)
            .ok_or_else(|| {
                format!("Cargo.lock names no `{package}`; run `cargo check` once to bring it up to date.")
            })
    }
}
