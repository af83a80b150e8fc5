//! `cargo xtask dist`: builds the optimised static site.

use std::fs;

use crate::project::Project;
use crate::setup::npm;
use crate::shell::{self, Result, read, step};
use crate::{setup, site};

pub fn run(project: &Project) -> Result {
    let wasm = setup::for_building(project)?;
    // wasm-opt is among its packages.
    npm::ensure(project)?;
    let folder = project.root.join("dist");
    site::build(project, &wasm, site::Kind::Optimised, &folder)?;
    check_relative(&read(&folder.join("index.html"))?)?;

    step(format!("{} is ready for any static host:", folder.display()));
    for path in shell::entries(&folder) {
        let bytes = fs::metadata(&path).map_or(0, |metadata| metadata.len());
        println!("{:>12}  {}", bytes, path.file_name().unwrap_or_default().to_string_lossy());
    }
    Ok(())
}

/// Refuses URLs that start at the host's root: they break a site that lies under a sub-path.
fn check_relative(html: &str) -> Result {
    let rooted = ["=\"/", "='/", "from '/", "from \"/", ": '/"].iter().find(|mark| html.contains(**mark));
    match rooted {
        Some(mark) => {
            Err(format!("dist/index.html has a URL from the host's root (`{mark}…`); it must be relative."))
        }
        None => Ok(()),
    }
}
