//! The service worker's list of the files to keep for offline use.

use std::fs;
use std::path::{Path, PathBuf};

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use sha2::{Digest, Sha256};

use super::names;
use crate::shell::{self, Result, read};

const SCRIPT: &str = "service-worker.js";
/// What the script has in place of the list and of its hash.
const NO_FILES: &str = "const FILES = [];";
const NO_VERSION: &str = "const VERSION = \"\";";

/// Gives the service worker of a complete site the list of the other files.
pub fn list_files(site: &Path) -> Result {
    let files = hashes(site)?;
    let script = site.join(SCRIPT);
    let text = read(&script)?;
    if !text.contains(NO_FILES) || !text.contains(NO_VERSION) {
        return Err(format!(
            "web/site/{SCRIPT} has no places for the list of files, `{NO_FILES}` and `{NO_VERSION}`."
        ));
    }
    let list: String =
        files.iter().map(|(name, hash)| format!("\n  [\"{name}\", \"sha256-{hash}\"],")).collect();
    // A change of the script alone is a new version too.
    let version = names::hash(format!("{text}{list}").as_bytes());
    let text = text.replace(NO_FILES, &format!("const FILES = [{list}\n];"));
    shell::write(&script, &text.replace(NO_VERSION, &format!("const VERSION = \"{version}\";")))
}

/// The files of a site but the script, with their hashes as the integrity of requests states them.
fn hashes(site: &Path) -> Result<Vec<(String, String)>> {
    let others = shell::files_below(site).into_iter().filter(|(name, _)| name != SCRIPT);
    let hash = |(name, path): (String, PathBuf)| {
        let bytes = fs::read(&path).map_err(|error| format!("{} can't be read: {error}.", path.display()))?;
        Ok((name, STANDARD.encode(Sha256::digest(&bytes))))
    };
    others.map(hash).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_list_has_every_file_and_changes_with_each() {
        let site = std::env::temp_dir().join(format!("meshwright-offline-{}", std::process::id()));
        let build = |page: &str| {
            let _ = fs::remove_dir_all(&site);
            fs::create_dir_all(site.join("embed")).expect("a folder");
            let script = format!("{NO_FILES}\n{NO_VERSION}\n");
            for (name, text) in [("index.html", page), ("embed/a.js", "a"), (SCRIPT, &script)] {
                fs::write(site.join(name), text).expect("a file");
            }
            list_files(&site).expect("listed");
            read(&site.join(SCRIPT)).expect("text")
        };
        let first = build("one");
        // `printf one | openssl dgst -sha256 -binary | base64`
        assert!(
            first.contains("[\"index.html\", \"sha256-dpLDrTVAu4A8Ags67mbNiIcSMjTqDG5xQ8Ct1z/0Me0=\"]"),
            "{first}"
        );
        assert!(first.contains("[\"embed/a.js\", "), "{first}");
        assert!(!first.contains(SCRIPT) && !first.contains(NO_VERSION));
        assert_eq!(build("one"), first);
        let version = |text: &str| text.lines().last().map(str::to_owned);
        assert_ne!(version(&build("two")), version(&first));
        assert!(list_files(&site).is_err(), "it has its list already");
        fs::remove_dir_all(&site).expect("removed");
    }
}
