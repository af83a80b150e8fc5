//! Set-up: each part checks what is there, says so, and installs only what is missing.

mod apt;
pub mod browser;
mod debian_wasm;
pub mod npm;
mod programs;
mod wasm;

pub use browser::Browser;
pub use wasm::{TARGET, WasmToolchain};

use crate::project::Project;
use crate::shell::{Result, make_folder};

/// What compiling for the page takes.
pub fn for_compiling(project: &Project) -> Result<WasmToolchain> {
    make_folder(&project.tools_bin())?;
    wasm::ensure(project)
}

/// What building the site takes.
pub fn for_building(project: &Project) -> Result<WasmToolchain> {
    let wasm = for_compiling(project)?;
    programs::wasm_bindgen(project)?;
    Ok(wasm)
}

/// What all tasks need together.
pub fn everything(project: &Project) -> Result {
    programs::rust_components()?;
    for_building(project)?;
    npm::ensure(project)?;
    let browser = browser::ensure(project)?;
    browser::ensure_driver(project, &browser)?;
    browser::ensure_native_graphics();
    println!("\nEverything is there. Next: `cargo xtask serve`.");
    Ok(())
}

/// What formatting and linting take besides the compiler.
pub fn for_linting() -> Result {
    programs::rust_components()
}
