//! `cargo xtask bench`: runs the workspace's criterion benchmarks.

use crate::project::Project;
use crate::shell::{self, Result, read};

pub fn run(project: &Project, args: &[String]) -> Result {
    let mut bench = shell::cargo();
    bench.arg("bench").current_dir(&project.root);
    // Targets are named so that unit tests are not run, which refuse criterion's arguments.
    let chosen = args.iter().any(|arg| matches!(arg.as_str(), "-p" | "--package" | "--bench"));
    let all = benches(project)?;
    if !chosen {
        if all.is_empty() {
            return Err("there are no benchmarks: none of crates/*/benches has a file.".to_owned());
        }
        for package in all.iter().map(|(package, _)| package) {
            bench.args(["-p", package]);
        }
    }
    if !args.iter().any(|arg| arg == "--bench") {
        let packages = packages_named(args);
        for (_, name) in all.iter().filter(|(package, _)| !chosen || packages.contains(&package.as_str())) {
            bench.args(["--bench", name]);
        }
    }
    let packages = packages_named(args);
    if (packages.is_empty() || packages.contains(&"surface")) && shell::find("c++").is_some() {
        bench.args(["--features", "surface/meshopt"]);
    }
    shell::run(bench.args(args))
}

/// The packages that `-p` or `--package` name.
fn packages_named(args: &[String]) -> Vec<&str> {
    let pairs =
        args.windows(2).filter(|pair| matches!(pair.first().map(String::as_str), Some("-p" | "--package")));
    pairs.filter_map(|pair| pair.get(1).map(String::as_str)).collect()
}

/// Each benchmark's package and name.
fn benches(project: &Project) -> Result<Vec<(String, String)>> {
    let mut found = Vec::new();
    for folder in shell::entries(&project.root.join("crates")) {
        let files = shell::entries(&folder.join("benches"));
        let names = files.iter().filter(|path| path.extension().is_some_and(|extension| extension == "rs"));
        let mut names = names.filter_map(|path| path.file_stem()).peekable();
        if names.peek().is_none() {
            continue;
        }
        let manifest = folder.join("Cargo.toml");
        let text = read(&manifest)?;
        let package = text
            .lines()
            .find_map(|line| line.strip_prefix("name = \"")?.strip_suffix('"'))
            .ok_or_else(|| format!("{} has no name.", manifest.display()))?;
        found.extend(names.map(|name| (package.to_owned(), name.to_string_lossy().into_owned())));
    }
    Ok(found)
}
