//! Names with a hash of the content: browsers may keep such files for ever.

use std::fs;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use crate::shell::{self, Result, read};

/// The hexadecimal digits of the hash in a name.
const DIGITS: usize = 16;

/// The files of a site that have been renamed.
pub struct Names<'a> {
    site: &'a Path,
    renamed: Vec<Renamed>,
}

struct Renamed {
    plain: String,
    named: String,
    /// Whether another file mentions it: what nothing mentions is never loaded.
    is_mentioned: bool,
}

impl<'a> Names<'a> {
    pub fn new(site: &'a Path) -> Self {
        Self { site, renamed: Vec::new() }
    }

    /// Puts a hash between the two parts of a file's name, after updating what the file mentions.
    pub fn rename(&mut self, start: &str, end: &str) -> Result {
        let plain = format!("{start}{end}");
        if !end.ends_with(".wasm") {
            self.update(&plain)?;
        }
        let bytes = fs::read(self.path(&plain)).map_err(|error| self.cannot("read", &plain, &error))?;
        let named = format!("{start}-{}{end}", hash(&bytes));
        fs::rename(self.path(&plain), self.path(&named))
            .map_err(|error| self.cannot("renamed", &plain, &error))?;
        self.renamed.push(Renamed { plain, named, is_mentioned: false });
        Ok(())
    }

    /// Replaces the former names that a text file mentions.
    pub fn update(&mut self, file: &str) -> Result {
        let path = self.path(file);
        let mut text = read(&path)?;
        for Renamed { plain, named, is_mentioned } in &mut self.renamed {
            *is_mentioned |= text.contains(plain.as_str());
            text = text.replace(plain.as_str(), named);
        }
        shell::write(&path, &text)
    }

    /// Checks that every renamed file is mentioned.
    pub fn finish(self) -> Result {
        match self.renamed.iter().find(|file| !file.is_mentioned) {
            Some(file) => Err(format!("no file of the site mentions {}: what loads it?", file.plain)),
            None => Ok(()),
        }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.site.join(name)
    }

    fn cannot(&self, what: &str, name: &str, error: &std::io::Error) -> String {
        format!("{} can't be {what}: {error}.", self.path(name).display())
    }
}

/// The start of the SHA-256 hash, in hexadecimal digits.
pub fn hash(bytes: &[u8]) -> String {
    Sha256::digest(bytes).iter().take(DIGITS / 2).map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_named_by_content_and_mention_each_other() {
        let site = std::env::temp_dir().join(format!("meshwright-names-{}", std::process::id()));
        let build = |program: &str| {
            let _ = fs::remove_dir_all(&site);
            fs::create_dir_all(&site).expect("a folder");
            for (name, text) in [
                ("w_bg.wasm", program),
                ("w.js", "new URL('w_bg.wasm', import.meta.url)"),
                ("w_loader.js", "import init from './w.js';"),
                ("index.html", "<meta content=\"./w_loader.js\">"),
            ] {
                fs::write(site.join(name), text).expect("a file");
            }
            let mut names = Names::new(&site);
            for end in ["_bg.wasm", ".js", "_loader.js"] {
                names.rename("w", end).expect("renamed");
            }
            names.update("index.html").expect("updated");
            let renamed = names.renamed.iter().map(|file| file.named.clone()).collect::<Vec<_>>();
            names.finish().expect("all are mentioned");
            renamed
        };
        let first = build("one");
        let text = |name: &str| read(&site.join(name)).expect("text");
        let [wasm, script, loader] = first.as_slice() else { panic!("three files: {first:?}") };
        assert_eq!(text("index.html"), format!("<meta content=\"./{loader}\">"));
        assert_eq!(text(loader), format!("import init from './{script}';"));
        assert_eq!(text(script), format!("new URL('{wasm}', import.meta.url)"));
        assert_eq!(text(wasm), "one");
        assert_eq!(wasm.len(), "w-_bg.wasm".len() + DIGITS);

        assert_eq!(build("one"), first, "the same content has the same name");
        let second = build("two");
        assert!(
            first.iter().zip(&second).all(|(a, b)| a != b),
            "other content has another name, and so has what mentions it"
        );
        let mut names = Names::new(&site);
        assert!(names.rename("w", ".js").is_err(), "there is nothing left to rename");
        names.rename("index", ".html").expect("renamed");
        assert!(names.finish().is_err_and(|error| error.contains("index.html")), "nothing mentions it");
        fs::remove_dir_all(&site).expect("removed");
    }
}
