//! `cargo xtask dist`: builds the optimised static site.

use crate::project::Project;
use crate::setup;
use crate::setup::npm;
use crate::shell::{Result, read, step};
use crate::site::compress::{self, Sizes};
use crate::site::{self, PAGE, WORKER};

pub fn run(project: &Project) -> Result {
    let wasm = setup::for_building(project)?;
    // wasm-opt is among its packages.
    npm::ensure(project)?;
    let folder = project.root.join("dist");
    site::build(project, &wasm, site::Kind::Optimised, &folder)?;
    check_relative(&read(&folder.join("index.html"))?)?;

    step("compressing the files");
    let sizes = compress::all(&folder)?;
    step(format!("{} is ready for any static host:", folder.display()));
    println!("{:>12} {:>12} {:>12}  file", "bytes", "Brotli", "gzip");
    for (name, Sizes { plain, brotli, gzip }) in &sizes {
        println!("{plain:>12} {brotli:>12} {gzip:>12}  {name}");
    }
    check_budgets(&sizes)
}

/// What a program may take, with its script, in bytes as compressed.
struct Budget {
    program: &'static str,
    what: &'static str,
    format: fn(&Sizes) -> usize,
    goal: usize,
    /// Past this, the build fails: a little above what has been reached.
    limit: usize,
}

const BUDGETS: [Budget; 3] = [
    Budget { program: PAGE, what: "Brotli", format: |sizes| sizes.brotli, goal: 2_000_000, limit: 2_650_000 },
    Budget { program: PAGE, what: "gzip", format: |sizes| sizes.gzip, goal: 2_800_000, limit: 3_650_000 },
    Budget { program: WORKER, what: "Brotli", format: |sizes| sizes.brotli, goal: 600_000, limit: 1_150_000 },
];

/// Prints what the programs take beside their goals, and fails past the limits.
fn check_budgets(sizes: &[(String, Sizes)]) -> Result {
    let mut broken = Vec::new();
    for Budget { program, what, format, goal, limit } in &BUDGETS {
        let own = sizes.iter().filter(|(name, _)| name.starts_with(program));
        let taken: usize = own.map(|(_, sizes)| format(sizes)).sum();
        let met = if taken <= *goal { "met" } else { "NOT met" };
        println!("{program}: {taken} bytes of {what}; the goal of {goal} is {met}, the limit is {limit}");
        if taken > *limit {
            broken.push(format!(
                "{program} takes {taken} bytes of {what}, more than the limit of {limit}. The list of crates above says what \
                 is large; raise the limit in xtask/src/dist.rs only for something that is worth it."
            ));
        }
    }
    if broken.is_empty() { Ok(()) } else { Err(broken.join("\n")) }
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
