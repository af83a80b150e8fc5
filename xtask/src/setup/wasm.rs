//! A compiler with a standard library for `wasm32-unknown-unknown`.

use std::path::Path;
use std::process::Command;
use std::time::Duration;

use super::{apt, debian_wasm};
use crate::project::Project;
use crate::shell::{self, Result, find, step};

/// The page's target.
pub const TARGET: &str = "wasm32-unknown-unknown";

/// The toolchain that builds for the page.
pub struct WasmToolchain {
    /// The name of a rustup toolchain; `None` for the one in use.
    name: Option<&'static str>,
}

impl WasmToolchain {
    /// Makes a command use this toolchain.
    pub fn choose<'a>(&self, command: &'a mut Command) -> &'a mut Command {
        if let Some(name) = self.name {
            command.env("RUSTUP_TOOLCHAIN", name);
        }
        command
    }

    /// Makes a command that builds for release use this toolchain, with 128-bit SIMD, which every current browser has.
    /// The library made for Debian's compiler holds machine code only, which link-time optimisation cannot use: there
    /// the standard library is built along.
    pub fn choose_for_dist<'a>(&self, command: &'a mut Command) -> &'a mut Command {
        command.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS", "-C target-feature=+simd128");
        if self.name == Some(debian_wasm::TOOLCHAIN) {
            command.env("RUSTC_BOOTSTRAP", "1").env("CARGO_UNSTABLE_BUILD_STD", "std,panic_abort");
        }
        self.choose(command)
    }
}

/// Finds such a toolchain, or installs one.
pub fn ensure(project: &Project) -> Result<WasmToolchain> {
    if in_use_has_target() {
        step("wasm target: there");
        return Ok(WasmToolchain { name: None });
    }
    let debian = WasmToolchain { name: Some(debian_wasm::TOOLCHAIN) };
    if debian_wasm::ready() {
        step(format!("wasm target: there (toolchain {})", debian_wasm::TOOLCHAIN));
        return Ok(debian);
    }
    let rustup = find("rustup").is_some();
    if rustup {
        step(format!("wasm target: $ rustup target add {TARGET}"));
        let mut add = Command::new("rustup");
        if shell::succeeds_within(add.args(["target", "add", TARGET]), Duration::from_secs(300))
            && in_use_has_target()
        {
            return Ok(WasmToolchain { name: None });
        }
        if apt::available() {
            step("wasm target: rustup cannot fetch it here, so Debian's compiler and sources make it");
            debian_wasm::install(project)?;
            return Ok(debian);
        }
    }
    let how = if rustup {
        format!("run `rustup target add {TARGET}` with the internet in reach.")
    } else {
        format!("install rustup from https://rustup.rs, then run `rustup target add {TARGET}`.")
    };
    Err(format!("the Rust standard library for {TARGET} is missing: {how}"))
}

fn in_use_has_target() -> bool {
    shell::capture(Command::new("rustc").args(["--print", "sysroot"]))
        .is_some_and(|sysroot| has_std(Path::new(&sysroot)))
}

/// Whether a sysroot has a standard library for the page's target.
fn has_std(sysroot: &Path) -> bool {
    shell::entries(&sysroot.join("lib/rustlib").join(TARGET).join("lib")).iter().any(|path| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.starts_with("libstd-") && name.ends_with(".rlib")
    })
}
