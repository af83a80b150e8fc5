//! Making a program of the site small and quick.

use std::fs;
use std::path::Path;
use std::process::Command;

use super::weight;
use crate::project::Project;
use crate::shell::{self, Result};

/// How many of the largest crates are printed; the others are small.
const MAX_CRATES: usize = 24;

/// Optimises a module, prints what each crate costs in it, and removes the names of functions.
pub fn module(project: &Project, program: &str, module: &Path) -> Result {
    let mut opt = Command::new("wasm-opt");
    opt.args(["-O3", "--debuginfo"]).arg(module).arg("-o").arg(module);
    shell::run(opt.env("PATH", project.path()?))?;
    let cannot = |error: std::io::Error| format!("{} can't be read or written: {error}.", module.display());
    let bytes = fs::read(module).map_err(cannot)?;
    let bare = weight::without_names(&bytes)?;
    print(program, bare.len(), &weight::by_crate(&bytes)?);
    fs::write(module, bare).map_err(cannot)
}

fn print(program: &str, all: usize, weights: &[(String, usize)]) {
    println!("\n{program}: {all} bytes before compression, of which");
    for (name, bytes) in weights.iter().take(MAX_CRATES) {
        println!("{bytes:>10} {:>5.1}%  {name}", 100.0 * *bytes as f64 / all as f64);
    }
    let rest = weights.iter().skip(MAX_CRATES);
    println!(
        "{:>10}         {} other crates",
        rest.clone().map(|(_, bytes)| bytes).sum::<usize>(),
        rest.count()
    );
}
