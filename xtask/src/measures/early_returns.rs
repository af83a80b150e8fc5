//! Tests that may end before they have asserted anything.

use super::Measure;
use super::source;
use crate::project::Project;
use crate::shell::{self, Result};

/// `return` without a value in the files of `tests` folders: `let Some(x) = … else { return };` and the like.
pub fn in_tests(project: &Project) -> Result<Measure> {
    let mut folders = shell::entries(&project.root.join("crates"));
    folders.push(project.root.join("web"));
    let mut found = Vec::new();
    for folder in folders {
        let folder = folder.strip_prefix(&project.root).unwrap_or(&folder).join("tests");
        for file in source::read_folder(&project.root, &folder.to_string_lossy())? {
            for two in file.tokens().windows(2) {
                if let [keyword, end] = two
                    && keyword.is("return")
                    && (end.is(";") || end.is("}"))
                {
                    found.push(format!("{}:{}", file.path.display(), keyword.line));
                }
            }
        }
    }
    Ok(Measure {
        name: "places at which a test may return early".to_owned(),
        value: found.len(),
        limit: 0,
        is_enforced: true,
        details: found,
    })
}
