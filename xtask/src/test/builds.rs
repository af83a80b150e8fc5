//! `cargo xtask builds`: what the stages of `cargo xtask test` have Cargo compile more than once for one platform, and
//! why, so that nothing is compiled twice for nothing.

use std::collections::{BTreeMap, BTreeSet};
use std::process::{Command, Stdio};

use super::stages;
use crate::project::Project;
use crate::setup;
use crate::shell::{Result, step};

/// What Cargo says of one thing that it compiled.
#[derive(Debug, PartialEq, Eq)]
struct Artifact {
    /// Package, target, platform and whether it was compiled or only checked: compiling once for each is all it takes.
    unit: String,
    /// Its file, named after all that went into it: features, profile and those of its dependencies.
    file: String,
    features: String,
    profile: String,
}

/// Compiles everything, or finds it compiled, and prints what was compiled in more than one way.
pub fn run(project: &Project) -> Result {
    let wasm = setup::for_building(project)?;
    let mut found: BTreeMap<String, Vec<(Artifact, BTreeSet<&str>)>> = BTreeMap::new();
    for (name, command) in stages::builds(project, &wasm) {
        for artifact in artifacts(name, command)? {
            let same = found.entry(artifact.unit.clone()).or_default();
            match same.iter_mut().find(|(known, _)| known.file == artifact.file) {
                Some((_, stages)) => {
                    stages.insert(name);
                }
                None => same.push((artifact, BTreeSet::from([name]))),
            }
        }
    }
    println!("\n{} units; compiled in more than one way:", found.len());
    for (unit, ways) in found.iter().filter(|(_, ways)| ways.len() > 1) {
        println!("{unit}");
        for (artifact, stages) in ways {
            let stages: Vec<&str> = stages.iter().copied().collect();
            println!("    {}: features [{}], {}", stages.join(", "), artifact.features, artifact.profile);
        }
    }
    Ok(())
}

fn artifacts(name: &str, mut command: Command) -> Result<Vec<Artifact>> {
    step(format!("compiling for {name}"));
    let output = command.arg("--message-format=json").stderr(Stdio::inherit()).output();
    let output = output.map_err(|error| format!("Cargo cannot be started: {error}."))?;
    if !output.status.success() {
        return Err(format!("what the stage {name} takes doesn't compile; `cargo xtask test` says why."));
    }
    Ok(String::from_utf8_lossy(&output.stdout).lines().filter_map(artifact).collect())
}

/// What a line of Cargo's JSON messages says; `None` for other messages, and for tests, which are always their own.
fn artifact(line: &str) -> Option<Artifact> {
    let profile = between(line, "\"profile\":{", "}")?;
    if !line.contains("\"reason\":\"compiler-artifact\"") || profile.contains("\"test\":true") {
        return None;
    }
    // `registry+https://…#glam@0.34.2` or `path+file:///…/crates/halfedge#0.1.0`.
    let package = between(line, "\"package_id\":\"", "\"")?;
    let package = package.rsplit(if package.contains('@') { '#' } else { '/' }).next()?;
    let kind = between(line, "\"kind\":[\"", "\"")?;
    let file = between(line, "\"filenames\":[\"", "\"")?;
    let platform = if file.contains(setup::TARGET) { "page" } else { "host" };
    let mode = if file.ends_with(".rmeta") { "checked" } else { "compiled" };
    Some(Artifact {
        unit: format!("{package} ({kind}, {platform}, {mode})"),
        file: file.to_owned(),
        features: between(line, "\"features\":[", "]")?.replace('"', "").replace(',', ", "),
        profile: profile.replace('"', "").replace(',', ", "),
    })
}

fn between<'a>(text: &'a str, start: &str, end: &str) -> Option<&'a str> {
    text.split_once(start)?.1.split_once(end).map(|(found, _)| found)
}

#[cfg(test)]
mod tests {
    use super::*;

    const LINE: &str = r#"{"reason":"compiler-artifact","package_id":"registry+https://github.com/rust-lang/crates.io-index#glam@0.34.2","manifest_path":"/x/Cargo.toml","target":{"kind":["lib"],"crate_types":["lib"],"name":"glam","src_path":"/x/lib.rs","edition":"2021","doc":true,"doctest":true,"test":true},"profile":{"opt_level":"1","debuginfo":0,"debug_assertions":true,"overflow_checks":true,"test":false},"features":["bytemuck","std"],"filenames":["/t/wasm32-unknown-unknown/debug/deps/libglam-1f.rlib","/t/libglam-1f.rmeta"],"executable":null,"fresh":true}"#;

    #[test]
    fn an_artifact_is_read() {
        let artifact = artifact(LINE).expect("an artifact");
        assert_eq!(artifact.unit, "glam@0.34.2 (lib, page, compiled)");
        assert_eq!(artifact.features, "bytemuck, std");
        assert!(artifact.file.ends_with("libglam-1f.rlib") && artifact.profile.starts_with("opt_level:1, "));
    }

    #[test]
    fn other_messages_and_tests_are_left_out() {
        assert_eq!(artifact(&LINE.replace("\"test\":false", "\"test\":true")), None);
        assert_eq!(artifact(&LINE.replace("compiler-artifact", "build-script-executed")), None);
        assert_eq!(artifact("{\"reason\":\"build-finished\",\"success\":true}"), None);
    }
}
