//! The lists outside the source that name each format: what a new format is missing from.

#[path = "../../../fuzz/targets.rs"]
#[allow(dead_code, reason = "only the list of targets is used")]
mod targets;

use formats::Format;
use std::path::{Path, PathBuf};

/// The files in which each format stands by its code, with those that have no place there.
const LISTS: [(&str, &[&str]); 4] = [
    // The tests of the formats with folders of their own have their own damaged files.
    ("crates/formats/tests/plain/damage.rs", &["obj", "dae", "glb", "gltf", "json", "bez", "bzc"]),
    ("crates/formats/tests/far.rs", &["bez"]),
    // Binary formats, JSON, which is always UTF-8, and surfaces, which are read as curves are.
    ("crates/formats/tests/encodings.rs", &["glb", "json", "bez"]),
    ("tests/saving.test.mjs", &[]),
];

fn repository(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

fn text(path: &str) -> String {
    std::fs::read_to_string(repository(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

fn seeds(target: &str) -> Vec<PathBuf> {
    let folder = repository("fuzz/seeds").join(target);
    let files =
        std::fs::read_dir(folder).map(|files| files.map(|file| file.expect("readable").path()).collect());
    files.unwrap_or_default()
}

#[test]
fn every_format_is_in_every_list() {
    let mut missing = Vec::new();
    for (path, exempt) in LISTS {
        let text = text(path);
        // Projects are the editor's, and tested there.
        for code in Format::all().filter(|format| !format.is_project()).map(Format::code) {
            let is_listed = text.contains(&format!("\"{code}\""));
            match (is_listed, exempt.contains(&code)) {
                (false, false) => missing.push(format!("{path}: \"{code}\"")),
                (true, true) => {
                    missing.push(format!("{path} has \"{code}\": no longer exempt it in this test"))
                }
                _ => {}
            }
        }
    }
    let readme = text("README.md").to_lowercase();
    for format in Format::all() {
        let name = format.name().trim_end_matches(" (text)").to_lowercase();
        let is_named = readme.contains(&name)
            || format.extensions().iter().any(|own| readme.contains(&format!(".{own}")));
        if !is_named {
            missing.push(format!("README.md: {name}"));
        }
        // A parser is a target with seeds of each extension.
        if format.can_read() {
            let all: Vec<PathBuf> = targets::TARGETS.iter().flat_map(|(target, _)| seeds(target)).collect();
            let has_seed =
                |own: &&str| all.iter().any(|path| path.extension().is_some_and(|found| *found == **own));
            if !format.extensions().iter().any(has_seed) {
                missing
                    .push(format!("fuzz/targets.rs and fuzz/seeds: .{}", format.extensions().join(" or .")));
            }
        }
    }
    assert!(missing.is_empty(), "missing:\n{}", missing.join("\n"));
}
