//! Puts a hash of their content into the names of the worker's files, as Trunk does with those of the page: a browser
//! never runs a cached worker of one build with the page of another.

use std::fs;
use std::path::Path;

use crate::shell::{self, Result, read};

/// How Trunk names the files.
const WORKER: &str = "meshwright-worker";

/// Renames the worker's files in a built site, and the references to them in its index.html.
pub fn name_by_content(site: &Path) -> Result {
    let at = |name: &str| site.join(name);
    let cannot =
        |name: &str, error: std::io::Error| format!("{} can't be renamed: {error}.", at(name).display());
    let (script, wasm, loader) =
        (format!("{WORKER}.js"), format!("{WORKER}_bg.wasm"), format!("{WORKER}_loader.js"));
    let program = fs::read(at(&wasm)).map_err(|error| cannot(&wasm, error))?;
    let code = read(&at(&script))?;
    let start = read(&at(&loader))?;
    let hash = [program.as_slice(), code.as_bytes(), start.as_bytes()]
        .iter()
        .fold(FNV_START, |hash, part| fnv(hash, part));
    let named = |name: &str| name.replacen(WORKER, &format!("{WORKER}-{hash:016x}"), 1);

    fs::rename(at(&wasm), at(&named(&wasm))).map_err(|error| cannot(&wasm, error))?;
    for (name, text, mentioned) in [(&script, code, &wasm), (&loader, start, &script)] {
        shell::write(&at(&named(name)), &replaced(&text, mentioned, &named(mentioned), name)?)?;
        fs::remove_file(at(name)).map_err(|error| cannot(name, error))?;
    }
    let index = read(&at("index.html"))?;
    shell::write(&at("index.html"), &replaced(&index, &loader, &named(&loader), "index.html")?)
}

/// Replaces a name in a text.
fn replaced(text: &str, from: &str, to: &str, file: &str) -> Result<String> {
    match text.contains(from) {
        true => Ok(text.replace(from, to)),
        false => {
            Err(format!("{file} of the built site does not mention {from}: has Trunk changed its output?"))
        }
    }
}

const FNV_START: u64 = 0xcbf2_9ce4_8422_2325;

/// Continues a 64-bit FNV-1a hash.
fn fnv(hash: u64, bytes: &[u8]) -> u64 {
    bytes.iter().fold(hash, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_hash_is_fnv() {
        // From the reference test suite of the hash's authors.
        assert_eq!(fnv(FNV_START, b""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(fnv(FNV_START, b"foobar"), 0x8594_4171_f739_67e8);
    }

    #[test]
    fn files_are_named_by_content_and_mention_each_other() {
        let site = std::env::temp_dir().join(format!("meshwright-worker-name-{}", std::process::id()));
        let build = |program: &str| {
            let _ = fs::remove_dir_all(&site);
            fs::create_dir_all(&site).expect("a folder");
            for (name, text) in [
                ("meshwright-worker.js", "new URL('meshwright-worker_bg.wasm', import.meta.url)"),
                ("meshwright-worker_bg.wasm", program),
                ("meshwright-worker_loader.js", "import init from './meshwright-worker.js';await init();"),
                ("index.html", "<meta name=\"meshwright-worker\" content=\"./meshwright-worker_loader.js\">"),
            ] {
                fs::write(site.join(name), text).expect("a file");
            }
            name_by_content(&site).expect("renamed");
            let mut names: Vec<String> = shell::entries(&site)
                .iter()
                .map(|path| path.file_name().unwrap_or_default().to_string_lossy().into_owned())
                .collect();
            names.sort();
            names
        };
        let first = build("one");
        assert_eq!(first.len(), 4);
        let loader = first.iter().find(|name| name.ends_with("_loader.js")).expect("a loader");
        let base = loader.trim_end_matches("_loader.js");
        assert!(
            first.contains(&format!("{base}.js")) && first.contains(&format!("{base}_bg.wasm")),
            "{first:?}"
        );
        let text = |name: &str| fs::read_to_string(site.join(name)).expect("text");
        assert_eq!(text("index.html"), format!("<meta name=\"meshwright-worker\" content=\"./{loader}\">"));
        assert_eq!(text(loader), format!("import init from './{base}.js';await init();"));
        assert_eq!(text(&format!("{base}.js")), format!("new URL('{base}_bg.wasm', import.meta.url)"));

        assert_eq!(build("one"), first, "the same content has the same name");
        assert_ne!(build("two"), first, "other content has another name");
        assert!(name_by_content(&site).is_err(), "there is nothing left to rename");
        fs::remove_dir_all(&site).expect("removed");
    }
}
